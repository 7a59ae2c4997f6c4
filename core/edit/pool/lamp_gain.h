#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "core/edit/pool/light_pool.h"

namespace swaplight {

/// A row of pixels of one light, R G B apart, and what is known of it; all start at the same pixel.
struct LampRow {
  float* light[3];                     ///< its contribution: changed
  const float* white[3];               ///< all lights of the set as solved, where the gain uses them
  std::array<const float*, 3> solved;  ///< this light as solved, on the surfaces of `white`
  /// Where the lamp's size changes, else nullptr: how much of the light is seen before and after, 0..1, and
  /// what it would give where nothing of it were hidden.
  const float* seen = nullptr;
  const float* seenThen = nullptr;
  std::array<const float*, 3> direct{};
};

/// What another place, aim or breadth of its lamp does to a light's contribution: a smooth gain, and of a
/// spot the cone in its new place. Nothing of the picture itself is displaced, so that no texture or outline
/// doubles; shadows stay.
///
///   T' = gain * T * (cone' + bounce) / (cone + bounce)      well inside the old cone, or without one
///   T' = gain * (cone' + bounce) * ratio * others           at its edge and beyond, where the cone comes or
///   goes: a guess
///
/// with LightPool's bounce and ratio, where T has the shadows of the lamp's new size (penumbra_scales.h);
/// where the cone stays as it is, so does the light. The gain is between -4 and 4 stops; T' >= 0 and finite.
class LampGain {
 public:
  /// For a picture of this size. Keeps what it needs of the pool.
  LampGain(const LightPool& pool, const LampChange& change, int width, int height);

  /// Whether what the other lights give says what this one would.
  [[nodiscard]] bool usesWhite() const { return m_coneMoves && !m_pool.alone; }
  /// Changes a row by `mask` (0..1) times what the lamp's change asks for.
  void changeRow(int x, int y, int count, const float* mask, const LampRow& row) const;
  /// The part of a pixel's new light that is a guess, 0..1: 1 where the light comes to what it never reached,
  /// 0 where only its level changes.
  [[nodiscard]] float guessAt(int x, int y) const;
  /// Of the lamp's front as it was photographed, widths of the picture.
  [[nodiscard]] float diameter() const { return static_cast<float>(m_lamp.diameter()); }

 private:
  struct Cones {
    float before, after;  // 0..1
    float guess;          // 0..1: how far the light's own texture cannot be used
    [[nodiscard]] bool isSame() const { return before == after && guess == 0; }
  };
  [[nodiscard]] Cones conesAt(int x, int y) const;
  void gainRow(int x, int y, int count, float* gain) const;
  /// What the cone's coming and going makes of a light.
  void coneRow(int x, int y, int count, const LampRow& row, const std::array<float*, 3>& changed) const;
  void ratioRow(int channel, int x, int y, int count, float* ratio) const;

  LightPool m_pool;
  ChangedLamp m_lamp;
  int m_width, m_height;
  bool m_coneMoves;
  cv::Mat m_gain;  // at the corners of cells of kCell pixels
};

}  // namespace swaplight
