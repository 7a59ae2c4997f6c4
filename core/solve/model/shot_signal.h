#pragma once

#include <cstdint>
#include <vector>

#include "core/capture/capture_pixels.h"
#include "core/solve/model/estimator.h"

namespace swaplight {

/// Which values of a capture's shots can be used, and the light in them that the controlled lights explain.
/// Looks at every value once; where all are good and there is no ambient picture, runs point straight into
/// the shots, and nothing is copied.
class ShotSignal {
 public:
  ShotSignal(const CapturePixels& pixels, const LightingMatrix& lighting, const NoiseModel& noise,
             const std::vector<float>& exposure);

  /// PixelFlag bits of every pixel; empty where no pixel has any.
  [[nodiscard]] const std::vector<uint8_t>& flags() const { return m_flags; }
  /// Whether a run has pixels with flags.
  [[nodiscard]] bool flagged(size_t first, int count) const;

  /// Fills `run` with the signal of pixels first .. first + count; `scratch` gives it room. With `mask`,
  /// values that are clipped or broken become NaN (a clipped value stays where too few would be left without
  /// it, and no shorter exposure of the same light says more); otherwise broken ones become 0, and clipped
  /// ones what a shorter exposure says.
  void run(size_t first, int count, bool mask, std::vector<float>& scratch, PixelRun& run) const;

  /// A value of a shot, as run() gives it; clipped ones are what the light is at least, broken ones say 0 at
  /// least.
  struct Reading {
    float light = 0;
    bool clipped = false;
  };
  [[nodiscard]] Reading reading(size_t pixel, int shot, int channel) const;
  /// One byte a pixel: 1 where run() leaves clipped values standing because too few are usable. Empty where
  /// there are none.
  [[nodiscard]] std::vector<uint8_t> undetermined() const;

  /// How many pixels have values that are no numbers, or negative, and too few others.
  [[nodiscard]] size_t lostPixels() const;

  /// The mean signal of each shot, over an even sample of usable pixels.
  [[nodiscard]] std::vector<Rgb> meanSignal() const;

  /// The shots as photographed.
  [[nodiscard]] const CapturePixels& pixels() const { return *m_pixels; }
  [[nodiscard]] size_t pixelCount() const { return m_pixelCount; }

 private:
  [[nodiscard]] bool isUsable(size_t pixel, size_t shot, int channel) const;
  [[nodiscard]] bool hasEnough(size_t pixel) const;
  void repair(size_t pixel, bool mask, float* values, size_t stride) const;

  const CapturePixels* m_pixels;
  int m_needed;  ///< usable values that a pixel must keep
  float m_lowest;
  std::vector<float> m_exposure;
  std::vector<int> m_shorter;  ///< of each shot: that of the same light with the next shorter exposure, or -1
  size_t m_pixelCount;
  std::vector<uint8_t> m_flags;
};

}  // namespace swaplight
