#include "core/intake/photograph_choice.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

#include "core/capture/left_out.h"

namespace swaplight {
namespace {

const Shot* shotOf(const std::vector<Shot>& shots, const std::string& file) {
  const auto found =
      std::find_if(shots.begin(), shots.end(), [&](const Shot& shot) { return shot.image == file; });
  return found == shots.end() ? nullptr : &*found;
}

/// Every digit of a colour: what is read back is written as it was.
std::string textOf(const Shot& shot, size_t light) {
  const std::optional<Rgb>& color = shot.lightColors[light];
  if (!color) return shot.colorName(light).empty() ? "unknown" : shot.colorName(light);
  if (*color == Rgb(0)) return "off";
  if (*color == Rgb(1)) return "white";
  return fmt::format("{}/{}/{}", color->r, color->g, color->b);
}

}  // namespace

std::vector<ToldPhotograph> toldPhotographs(const Capture& capture, const ShotFolder& folder) {
  const std::vector<Shot> leftOut = leftOutOf(capture);
  std::vector<ToldPhotograph> all;
  for (const FoundShot& photograph : folder.shots) {
    ToldPhotograph told;
    const Shot* shot = shotOf(capture.shots, photograph.file);
    if (shot == nullptr) {
      shot = shotOf(leftOut, photograph.file);
      told.used = shot == nullptr;
    }
    if (shot != nullptr)
      for (size_t i = 0; i < shot->lightColors.size(); ++i) {
        told.colors.push_back(textOf(*shot, i));
        // Nobody had to say it of a photograph that is not used.
        if (!told.used && told.colors.back() == "unknown") told.colors.back().clear();
      }
    all.push_back(std::move(told));
  }
  return all;
}

std::vector<float> toldExposures(const Capture& capture, const ShotFolder& folder) {
  std::vector<float> stops;
  for (const FoundShot& photograph : folder.shots) {
    const Shot* shot = shotOf(capture.shots, photograph.file);
    stops.push_back(shot == nullptr ? 0 : shot->exposureStops);
  }
  return stops;
}

std::shared_ptr<const CapturePixels> pixelsOf(std::shared_ptr<const CapturePixels> pixels,
                                              const std::vector<size_t>& shots) {
  std::vector<size_t> all(pixels->shots.size());
  std::iota(all.begin(), all.end(), size_t{0});
  if (shots == all) return pixels;
  auto some = std::make_shared<CapturePixels>(withoutShots(*pixels));
  some->clipLevel.clear();
  some->quantum.clear();
  for (const size_t k : shots) {
    some->shots.push_back(pixels->shots[k].clone());
    some->clipLevel.push_back(pixels->clipLevel[k]);
    some->quantum.push_back(pixels->quantum[k]);
  }
  return some;
}

}  // namespace swaplight
