#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/set/solved_set.h"
#include "core/shadow/result/shadow_mark.h"
#include "core/shadow/result/shadow_outline.h"

namespace swaplight {

struct SetEvidence;
struct ShadowSides;
struct LightOdds;
struct LastWords;

/// How bright a light shows, pixel by pixel, reflectance mostly taken out: the shares of the pixels in even
/// steps from kLowestStops to kHighestStops over well-lit pixels. The ends hold what lies beyond.
struct ShadowHistogram {
  static constexpr float kLowestStops = -10, kHighestStops = 2;
  static constexpr size_t kBins = 96;
  std::array<float, kBins> share{};
};

/// A light's shadows as a preview tells them.
struct PreviewedShadows {
  std::vector<ShadowLabel> labels;
  int width = 0;    ///< of the labels
  float scale = 1;  ///< pixels of the picture that a label covers, across
  [[nodiscard]] ShadowOutlines outlines() const { return shadowOutlines(labels, width, scale); }
};

/// Finds shadows on a picture that is small enough (about a megapixel) to follow a hand on the threshold:
/// like detectShadows(), but for penumbras made exact and what the filled shadows add, which take half a
/// second; of the other lights it uses their own thresholds, also where others are given. For looking, not
/// for edits.
class ShadowPreview {
 public:
  explicit ShadowPreview(const SolvedSet& set, const Progress& progress = {});

  [[nodiscard]] size_t lightCount() const { return m_lights.size(); }
  [[nodiscard]] const ShadowHistogram& histogram(size_t light) const { return m_lights[light].histogram; }
  /// The threshold that the light has of itself (as ShadowOptions::threshold).
  [[nodiscard]] float ownThreshold(size_t light) const { return m_lights[light].threshold; }
  /// A light's shadows for a threshold (nothing: its own) and marks in the set's pixels. May be called in any
  /// thread.
  [[nodiscard]] PreviewedShadows shadows(size_t light, const std::optional<float>& threshold,
                                         const ShadowMarks& marks = {}) const;

 private:
  struct PreviewedLight {
    ShadowHistogram histogram;
    float lit = 0;  // log level of well-lit pixels
    float threshold = 0;
    std::shared_ptr<const ShadowSides> sides;
    std::shared_ptr<const LightOdds> odds;
  };
  std::shared_ptr<const SetEvidence> m_evidence;
  std::vector<PreviewedLight> m_lights;
  std::shared_ptr<LastWords> m_words;
  int m_width, m_height;  // of the set
  float m_scale = 1;
};

/// A threshold (ShadowOptions) as stops over well-lit pixels, and back.
[[nodiscard]] float stopsFromThreshold(float threshold);
[[nodiscard]] float thresholdFromStops(float stops);
/// How far below the threshold, in stops, a pixel is surely in shadow, and how far above it surely lit.
[[nodiscard]] float surelyShadowStops();
[[nodiscard]] float surelyLitStops();

}  // namespace swaplight
