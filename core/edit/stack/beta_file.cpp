#include "core/edit/stack/beta_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/image/io/carried_data.h"
#include "core/image/io/image_io.h"

namespace swaplight {
namespace {

constexpr float kRounding = 1e-3F;

std::vector<int> chosenChannels(const ImageSpec& spec, const std::string& channel, const std::string& light) {
  const auto index = [&](const std::string& name) {
    const auto found = std::find(spec.channels.begin(), spec.channels.end(), name);
    return found == spec.channels.end() ? -1 : static_cast<int>(found - spec.channels.begin());
  };
  if (!channel.empty()) return {index(channel)};
  if (const int beta = index("beta." + light); beta >= 0) return {beta};
  if (spec.channels.size() == 1) return {0};
  if (const int grey = index("Y"); grey >= 0) return {grey};
  return {index("R"), index("G"), index("B")};
}

/// The channels of a file that hold the lights' proportions.
struct BetaChannels {
  std::vector<std::vector<int>> ofLight;
  std::map<int, Image> pixels;  ///< by channel
};

/// One light's map out of its channels.
Image mapOf(const BetaChannels& file, size_t light, const ImageSpec& spec, const std::string& name) {
  std::vector<const float*> planes;
  for (const int c : file.ofLight[light]) planes.push_back(file.pixels.at(c).plane(0));
  Image beta(spec);
  for (size_t p = 0; p < beta.pixelCount(); ++p) {
    float value = 0;
    for (const float* plane : planes) value += plane[p] / static_cast<float>(planes.size());
    if (!(value >= -kRounding && value <= 1 + kRounding))
      throw InputError("{}: the pixel {}, {} is {}, expected a proportion from 0 to 1.", name,
                       p % static_cast<size_t>(spec.width), p / static_cast<size_t>(spec.width), value);
    beta.plane(0)[p] = std::clamp(value, 0.F, 1.F);
  }
  return beta;
}

bool isMapALight(const std::filesystem::path& file) {
  return lowerExtension(file) == ".png";
}

void findSums(BetaMaps& beta) {
  const Image& first = beta.maps.front();
  const auto width = static_cast<size_t>(first.width());
  bool any = false;
  for (size_t p = 0; p < first.pixelCount(); ++p) {
    float sum = 0;
    for (const Image& map : beta.maps) sum += map.plane(0)[p];
    if (sum == 0) continue;
    const BetaMaps::Sum here{sum, static_cast<int>(p % width), static_cast<int>(p / width)};
    if (!any || sum < beta.least.value) beta.least = here;
    if (!any || sum > beta.most.value) beta.most = here;
    any = true;
  }
}

}  // namespace

std::vector<std::filesystem::path> betaMapFiles(const std::filesystem::path& file,
                                                std::span<const std::string> lights) {
  if (!isMapALight(file)) return {file};
  std::vector<std::filesystem::path> files;
  for (const std::string& light : lights)
    files.push_back(std::filesystem::path(file).replace_extension(light + ".png"));
  return files;
}

std::vector<std::filesystem::path> writeBetaMaps(const SolvedSet& set, const std::filesystem::path& file) {
  WriteOptions options;
  if (set.carried)  // of the picture's channels none
    options.carried = std::make_shared<CarriedData>(
        CarriedData{set.carried->header, set.carried->pixelAspect, set.carried->dataWindow, {}, {}});
  std::vector<std::string> lights;
  for (const Light& light : set.capture.lights) lights.push_back(light.name);
  std::vector<std::filesystem::path> files = betaMapFiles(file, lights);
  if (!isMapALight(file)) {
    options.pixelType = "float";
    writeImage(set.beta, file, options);
    return files;
  }
  options.pixelType = "uint16";
  for (int i = 0; i < set.lightCount(); ++i) {
    Image one(ImageSpec{set.width(), set.height(), {"Y"}, "data"});
    std::copy_n(set.beta.plane(i), one.pixelCount(), one.plane(0));
    writeImage(one, files[static_cast<size_t>(i)], options);
  }
  return files;
}

BetaMaps readBetaMaps(const std::filesystem::path& file, const std::string& channel,
                      const std::vector<std::string>& lights, int width, int height,
                      const Progress& progress) {
  const std::string name = file.string();
  BetaChannels found;
  const ImageSpec plane{width, height, {"Y"}, "data"};
  const auto planes = [&](const ImageSpec& spec, const ImageFileInfo& /*info*/) {
    if (spec.width != width || spec.height != height)
      throw InputError("{}: is {} x {} pixels, the set is {} x {}: a beta map has the set's size.", name,
                       spec.width, spec.height, width, height);
    std::vector<float*> wanted(spec.channels.size());
    for (const std::string& light : lights) {
      found.ofLight.push_back(chosenChannels(spec, channel, light));
      for (const int c : found.ofLight.back()) {
        if (c < 0)
          throw InputError("{}: has no channel {}, but {}.", name,
                           channel.empty() ? "beta." + light : channel, fmt::join(spec.channels, ", "));
        wanted[static_cast<size_t>(c)] = found.pixels.try_emplace(c, plane).first->second.plane(0);
      }
    }
    return wanted;
  };
  readChannels(file, planes, progress);
  BetaMaps beta;
  for (size_t i = 0; i < lights.size(); ++i)
    beta.maps.push_back(mapOf(found, i, {width, height, {"beta." + lights[i]}, "data"}, name));
  if (!lights.empty()) findSums(beta);
  return beta;
}

void checkProportions(const BetaMaps& beta, bool all, const std::filesystem::path& file) {
  if (beta.maps.size() < 2) return;
  const float rounding = kRounding * static_cast<float>(beta.maps.size());
  const bool tooMuch = beta.most.value > 1 + rounding;
  const bool tooLittle = all && beta.least.value < 1 - rounding;
  if (!tooMuch && !tooLittle) return;
  const bool most = tooMuch && (!tooLittle || beta.most.value - 1 > 1 - beta.least.value);
  const BetaMaps::Sum& worst = most ? beta.most : beta.least;
  throw InputError(
      "{}: the lights' betas at pixel {}, {} add up to {:.3f}, expected {}. Read one light's map alone, or "
      "let the edit add light (\"meaning\": \"add\").",
      file.string(), worst.x, worst.y, worst.value, all ? "1" : "1 at most");
}

}  // namespace swaplight
