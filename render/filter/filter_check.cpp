#include "render/filter/filter_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace swaplight {
namespace {

/// Stands where a filter computes no number. Far below all light, and still so after filters' later passes.
constexpr float kNoNumber = -1e9F;
constexpr float kNoNumberSeen = -1e6F;

/// Everything that a frame can hold: dark to bright from left to right, and above it negative, very bright
/// and missing values.
Image hardPicture(FilterSpace space) {
  constexpr int kWidth = 64, kHeight = 36, kHardRows = 6;
  constexpr std::array<float, 6> kHard{-1.0F,    -1e-6F, 0.0F,
                                       65504.0F, 1e-30F, std::numeric_limits<float>::quiet_NaN()};
  Image image(ImageSpec::rgb(kWidth, kHeight));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < 3; ++c) {
        const float step = static_cast<float>(x + c) / kWidth;
        const bool light = space == FilterSpace::SceneLinear;
        image.span().at(c, x, y) = light && y < kHardRows ? kHard[static_cast<size_t>((x + c + y) % 6)]
                                   : light                ? std::exp2(24 * step - 8)
                                                          : std::min(step, 1.0F);
      }
  return image;
}

/// A picture with detail at every pixel, on which a filter that looks too far is found out.
Image detailedPicture() {
  constexpr int kWidth = 96, kHeight = 64;
  Image image(ImageSpec::rgb(kWidth, kHeight));
  unsigned state = 1;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p) {
      state = state * 1664525U + 1013904223U;  // Numerical Recipes' generator
      const float ramp = static_cast<float>(p % kWidth) / kWidth;
      image.plane(c)[p] = 0.7F * ramp + 0.3F * static_cast<float>(state >> 8) / 16777216.0F;
    }
  return image;
}

/// The largest difference of two pictures, relative where they are brighter than 1.
float differenceOf(const Image& a, const Image& b) {
  float most = 0;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < a.pixelCount(); ++p)
      most =
          std::max(most, std::abs(a.plane(c)[p] - b.plane(c)[p]) / std::max(1.0F, std::abs(a.plane(c)[p])));
  return most;
}

/// One filter, with values that change.
class Trial {
 public:
  Trial(const std::shared_ptr<const Filter>& filter, double mostSeconds) : m_stage{filter, {}} {
    for (const FilterInput& input : filter->inputs) m_stage.values.push_back(input.standard);
    m_options.displayFromScene = [](ImageSpan) {};
    m_options.limitsPerTile = {mostSeconds, kNoNumber};
    m_space = filter->space == FilterSpace::Any ? FilterSpace::SceneLinear : filter->space;
  }

  [[nodiscard]] std::string fault() {
    if (std::string words = faultOfValues(); !words.empty()) return words;
    return seam();
  }

  /// The same with one parameter at another value.
  [[nodiscard]] std::string faultWith(size_t input, const FilterValue& value) {
    const FilterValue before = std::exchange(m_stage.values[input], value);
    std::string words = fault();
    m_stage.values[input] = before;
    if (!words.empty())
      words += fmt::format(", with {}={}", m_stage.filter->inputs[input].name, textFromFilterValue(value));
    return words;
  }

 private:
  Image draw(Image image, int tileSide = 4096) {
    m_options.tileSide = tileSide;
    return m_renderer.apply({std::move(image), m_space}, {&m_stage, 1}, m_options).image;
  }

  std::string faultOfValues() {
    const Image drawn = draw(hardPicture(m_space));
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = 0; x < drawn.width(); ++x)
        for (int c = 0; c < 3; ++c) {
          const float value = drawn.view().at(c, x, y);
          if (std::isfinite(value) && value > kNoNumberSeen && value < FilterTexture::kBrightest) continue;
          const float in = hardPicture(m_space).view().at(c, x, y);
          return fmt::format("gives no finite number{}", std::isnan(in)
                                                             ? std::string(" where one is missing")
                                                             : fmt::format(" where the light is {:.3g}", in));
        }
    return {};
  }

  std::string seam() {
    constexpr int kPartSide = 40;
    // The program's own are read by pixels; others' interpolation rounds otherwise at other coordinates.
    const float tolerance = m_stage.filter->builtIn ? 0 : 1.0F / 1024;
    if (!m_stage.filter->halo) return {};
    const float difference = differenceOf(draw(detailedPicture()), draw(detailedPicture(), kPartSide));
    if (difference <= tolerance) return {};
    return fmt::format("looks further than its HALO: drawn in parts it differs by {:.3g}", difference);
  }

  ResolvedStage m_stage;
  PipelineRenderer m_renderer;
  PipelineOptions m_options;
  FilterSpace m_space;
};

/// The values of a parameter at which it is most likely to go wrong.
std::vector<FilterValue> endsOf(const FilterInput& input) {
  if (input.type == FilterInputType::Bool) return {!std::get<bool>(input.standard)};
  if (input.type == FilterInputType::Choice) return {input.values.begin(), input.values.end()};
  if (input.type == FilterInputType::Color)
    return {FilterColor{0, 0, 0, 1}, FilterColor{1, 1, 1, 1}, FilterColor{1, 0, 0, 1}};
  if (!input.low || !input.high) return {};
  const auto* low = std::get_if<float>(&*input.low);
  const auto* high = std::get_if<float>(&*input.high);
  if (const auto* vector = std::get_if<FilterVector>(&input.standard))
    return {FilterVector(vector->size(), *low), FilterVector(vector->size(), *high)};
  if (const auto* matrix = std::get_if<FilterMatrix>(&input.standard))
    return {FilterMatrix(matrix->size(), FilterVector(matrix->size(), *low)),
            FilterMatrix(matrix->size(), FilterVector(matrix->size(), *high))};
  if (input.type == FilterInputType::Curve)
    return {FilterCurve{{0, *low}, {1, *low}}, FilterCurve{{0, *high}, {1, *low}},
            FilterCurve{{0.499F, *low}, {0.501F, *high}}};
  return {*input.low, *input.high};
}

}  // namespace

std::string faultOf(const std::shared_ptr<const Filter>& filter, double mostSeconds) {
  Trial trial(filter, mostSeconds);
  std::string words = trial.fault();
  for (size_t i = 0; filter->ours && i < filter->inputs.size(); ++i)
    for (const FilterValue& value : endsOf(filter->inputs[i]))
      if (words.empty()) words = trial.faultWith(i, value);
  return words;
}

}  // namespace swaplight
