// What the odds of umbra weigh, for tests/bench/train_umbra.py: umbraFeatures() of a rendered set.
// usage: shadow_bench FOLDER NOISE OUT.f32
// FOLDER: with T_<light>.exr; NOISE: 0, or 1 for the noise of shots (full well 5,000, read noise .004).
// Writes floats [light][feature][row][column], and says their sizes as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "core/base/json.h"
#include "core/image/io/image_io.h"
#include "core/image/rgb_image.h"
#include "core/shadow/evidence/shadow_evidence.h"
#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/odds/umbra_features.h"
#include "core/shadow/odds/umbra_tuning.h"

using namespace swaplight;
namespace fs = std::filesystem;

namespace {

constexpr float kFullWell = 5000, kReadNoise = .004F;

// The lights as they were rendered. A contribution of another place of its lamp (T_<light>@<edit>.exr) is
// none.
SolvedSet readContributions(const fs::path& folder) {
  std::vector<std::string> lights;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    if (name.starts_with("T_") && name.find('@') == std::string::npos) lights.push_back(name.substr(2));
  }
  std::sort(lights.begin(), lights.end());
  SolvedSet set;
  for (const std::string& light : lights) {
    const fs::path file = folder / ("T_" + light + ".exr");
    set.capture.lights.push_back({light, Role::Other, Json::object()});
    set.contributions.push_back(rgbImage(readImage(file).image, file));
  }
  updateBeta(set);
  return set;
}

// Noise as the shots have it, and a quality that says so.
void addNoise(SolvedSet& set) {
  const ImageSpec& spec = set.contributions.front().spec();
  set.quality = Image(ImageSpec{spec.width, spec.height, {"residual", "sigma", "flags", "model"}, ""});
  std::mt19937 generator(1);
  std::normal_distribution<float> normal;
  for (size_t p = 0; p < set.quality.pixelCount(); ++p) {
    float sum = 0;
    for (const Image& t : set.contributions)
      for (int c = 0; c < 3; ++c) sum += t.plane(c)[p] / 3;
    const float sigma = std::sqrt(std::max(sum, 0.F) / kFullWell + kReadNoise * kReadNoise);
    for (Image& t : set.contributions)
      for (int c = 0; c < 3; ++c) t.plane(c)[p] = std::max(0.F, t.plane(c)[p] + sigma * normal(generator));
    set.quality.plane(kSigma)[p] = sigma / std::max(sum, 1e-6F);
  }
}

void writeFeatures(const SolvedSet& solved, const char* file) {
  const SetEvidence evidence = gatherShadowEvidence(solved);
  const cv::Size size = sizeWithin(evidence.known.size(), UmbraOddsTuning().longest);
  const SmallSet set = smallSetOf(evidence.contributions, size);
  std::ofstream out(file, std::ios::binary);
  std::string lights;
  for (size_t i = 0; i < set.rgb.size(); ++i) {
    lights += fmt::format("{}\"{}\"", i ? ", " : "", solved.capture.lights[i].name);
    for (const cv::Mat& feature : umbraFeatures(set, i))
      for (int y = 0; y < size.height; ++y)
        out.write(reinterpret_cast<const char*>(feature.ptr<float>(y)), size.width * 4L);
  }
  fmt::print("{{\"lights\": [{}], \"features\": {}, \"height\": {}, \"width\": {}}}\n", lights,
             umbraFeatureNames().size(), size.height, size.width);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    std::fputs("usage: shadow_bench FOLDER NOISE OUT.f32\n", stderr);
    return 2;
  }
  SolvedSet set = readContributions(arguments[1]);
  if (std::string(arguments[2]) != "0") addNoise(set);
  writeFeatures(set, arguments[3]);
  return 0;
}
