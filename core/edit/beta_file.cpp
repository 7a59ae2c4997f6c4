#include "core/edit/beta_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/image/image_io.h"

namespace swaplight {
namespace {

constexpr float kRounding = 1e-3f;

std::vector<int> chosenChannels(const Image& image, const std::string& channel, const std::string& light) {
  if (!channel.empty()) return {image.channelIndex(channel)};
  if (const int beta = image.channelIndex("beta." + light); beta >= 0) return {beta};
  if (image.channelCount() <= 2) return {0};  // grey, or grey and alpha
  return {image.channelIndex("R"), image.channelIndex("G"), image.channelIndex("B")};
}

}  // namespace

std::vector<std::filesystem::path> writeBetaMaps(const SolvedSet& set, const std::filesystem::path& file) {
  WriteOptions options;
  if (file.extension() != ".png") {
    options.pixelType = "float";
    writeImage(set.beta, file, options);
    return {file};
  }
  options.pixelType = "uint16";
  std::vector<std::filesystem::path> files;
  for (int i = 0; i < set.lightCount(); ++i) {
    Image one(ImageSpec{set.width(), set.height(), {"Y"}, "data"});
    std::copy_n(set.beta.plane(i), one.pixelCount(), one.plane(0));
    files.push_back(file);
    files.back().replace_extension(set.capture.lights[static_cast<size_t>(i)].name + ".png");
    writeImage(one, files.back(), options);
  }
  return files;
}

Image readBetaMap(const std::filesystem::path& file, const std::string& channel, const std::string& light,
                  int width, int height) {
  const Image picture = readImage(file).image;
  if (picture.width() != width || picture.height() != height)
    throw InputError("{}: is {} x {} pixels, the set is {} x {}: a beta map has the set's size.",
                     file.string(), picture.width(), picture.height(), width, height);
  const std::vector<int> channels = chosenChannels(picture, channel, light);
  if (std::count(channels.begin(), channels.end(), -1))
    throw InputError("{}: has no channel {}, but {}.", file.string(),
                     channel.empty() ? "beta." + light : channel, fmt::join(picture.spec().channels, ", "));
  Image beta(ImageSpec{width, height, {"beta." + light}, "data"});
  for (size_t p = 0; p < beta.pixelCount(); ++p) {
    float value = 0;
    for (const int c : channels) value += picture.plane(c)[p] / static_cast<float>(channels.size());
    if (!(value >= -kRounding && value <= 1 + kRounding))
      throw InputError("{}: the pixel {}, {} is {}, expected a proportion from 0 to 1.", file.string(),
                       p % static_cast<size_t>(width), p / static_cast<size_t>(width), value);
    beta.plane(0)[p] = std::clamp(value, 0.f, 1.f);
  }
  return beta;
}

}  // namespace swaplight
