#include "core/intake/response_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/image/io/image_io.h"
#include "core/image/rgb_image.h"
#include "core/intake/log_response.h"
#include "core/ocio/color_config.h"

namespace swaplight {
namespace {

constexpr int kSeenOften = 20;     // samples
constexpr double kLeastRange = 1;  // stops between the exposures
constexpr int kLeastCodes = 64;    // different ones that are seen

/// The nearest curve that does not fall: neighbours that do become their mean.
void makeRising(std::vector<double>& values) {
  std::vector<std::pair<double, int>> blocks;
  for (const double value : values) {
    blocks.emplace_back(value, 1);
    while (blocks.size() > 1 && blocks[blocks.size() - 2].first > blocks.back().first) {
      const auto [last, count] = blocks.back();
      blocks.pop_back();
      auto& [mean, size] = blocks.back();
      mean = (mean * size + last * count) / (size + count);
      size += count;
    }
  }
  values.clear();
  for (const auto& [mean, size] : blocks) values.insert(values.end(), static_cast<size_t>(size), mean);
}

/// How far single exposures are from g.
double responseMisfit(const ResponseSamples& samples, const std::vector<double>& g) {
  const auto lightOf = [&](size_t p, size_t j) {
    return g[static_cast<size_t>(samples.level(p, j))] - samples.logTime(p, j);
  };
  double squares = 0, weights = 0;
  for (size_t p = 0; p < samples.pixels(); ++p) {
    double mean = 0, sum = 0;
    for (size_t j = 0; j < samples.length; ++j) {
      const double w = responseWeight(samples.level(p, j));
      mean += w * lightOf(p, j), sum += w;
    }
    for (size_t j = 0; sum > 0 && j < samples.length; ++j) {
      const double w = responseWeight(samples.level(p, j));
      squares += w * std::pow(lightOf(p, j) - mean / sum, 2), weights += w;
    }
  }
  return weights > 0 ? std::sqrt(squares / weights) : 0;
}

std::vector<double> risingResponse(const ResponseSamples& samples, ResponseMethod method) {
  std::vector<double> g =
      method == ResponseMethod::Debevec ? debevecResponse(samples) : robertsonResponse(samples);
  makeRising(g);
  return g;
}

/// Light 1 at the last code.
std::vector<float> lightOf(const std::vector<double>& g) {
  std::vector<float> light;
  light.reserve(g.size());
  for (const double value : g) light.push_back(static_cast<float>(std::exp(value - g.back())));
  light.front() = 0;  // black is no light: a logarithm has nowhere to go
  return light;
}

double largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
  double largest = 0;
  for (size_t z = 0; z < a.size(); ++z) largest = std::max(largest, double(std::abs(a[z] - b[z])));
  return largest;
}

/// A pixel that is neither black nor clipped in two exposures.
bool isSeenTwice(const ResponseSamples& samples) {
  for (size_t p = 0; p < samples.pixels(); ++p) {
    int seen = 0;
    for (size_t j = 0; j < samples.length; ++j) seen += responseWeight(samples.level(p, j)) > 0;
    if (seen > 1) return true;
  }
  return false;
}

void fitChannel(const ResponseSamples& samples, int c, ResponseMethod method, ResponseFit& fit) {
  const auto counts = samples.counts();
  const auto seen = std::count_if(counts.begin(), counts.end(), [](int count) { return count > 0; });
  if (seen < kLeastCodes)
    throw InputError(
        "too little is seen of the camera's response: only {} of {} codes, in places that are even; "
        "photograph something with smooth light and dark, in steps of one or two stops",
        seen, kResponseLevels);
  if (!isSeenTwice(samples))
    throw InputError(
        "nothing is seen in two of the exposures, between black and white: photograph them one or two stops "
        "apart");
  const auto often =
      std::find_if(counts.begin(), counts.end(), [](int count) { return count >= kSeenOften; });
  fit.darkest[static_cast<size_t>(c)] = double(often - counts.begin()) / (kResponseLevels - 1);
  const std::vector<double> g = risingResponse(samples, method);
  fit.misfit[static_cast<size_t>(c)] = responseMisfit(samples, g);
  const ResponseMethod other =
      method == ResponseMethod::Debevec ? ResponseMethod::Robertson : ResponseMethod::Debevec;
  std::vector<float>& light = fit.curve.light[static_cast<size_t>(c)];
  light = lightOf(g);
  fit.methodDifference =
      std::max(fit.methodDifference, largestDifference(light, lightOf(risingResponse(samples, other))));
}

void compareWithUsual(ResponseFit& fit) {
  static const ColorConfig builtin("");
  fit.nearestDifference = INFINITY;
  for (const char* name : {"srgb", "lin_rec709", "gamma22", "gamma24", "rec709"}) {
    Image usual(ImageSpec::rgb(kResponseLevels, 1));
    for (int c = 0; c < 3; ++c)
      for (int z = 0; z < kResponseLevels; ++z) usual.plane(c)[z] = float(z) / (kResponseLevels - 1);
    builtin.convert(usual.span(), name, "lin_rec709");
    double largest = 0;
    const std::vector<float> light(usual.plane(0), usual.plane(0) + kResponseLevels);
    for (const std::vector<float>& curve : fit.curve.light)
      largest = std::max(largest, largestDifference(curve, light));
    if (largest < fit.nearestDifference) fit.nearest = name, fit.nearestDifference = largest;
  }
}

}  // namespace

std::vector<Image> loadCodes(const ShotFolder& folder) {
  std::vector<Image> codes;
  for (const FoundShot& shot : folder.shots) {
    const std::filesystem::path path = folder.folder / shot.file;
    ImageFile file = readImage(path);
    if (file.info.isFloat || file.info.format == "raw")
      throw InputError("{}: holds light, no codes of a camera's curve: give JPEG, PNG or TIFF",
                       path.string());
    codes.push_back(rgbImage(std::move(file.image), path));
    const Image &first = codes.front(), &last = codes.back();
    if (last.width() != first.width() || last.height() != first.height())
      throw InputError("{} is {} x {} pixels, {} is {} x {}: give photographs of one size", path.string(),
                       last.width(), last.height(), folder.shots.front().file, first.width(), first.height());
  }
  return codes;
}

ResponseFit fitResponse(const std::vector<Image>& codes, const Brackets& brackets, ResponseMethod method) {
  if (brackets.length < 2 || brackets.stops.size() != codes.size())
    throw InputError("a response is found from brackets: two or more exposures of the same light");
  const auto [low, high] = std::minmax_element(brackets.stops.begin(), brackets.stops.end());
  if (*high - *low < kLeastRange)
    throw InputError("the exposures are only {:.2f} stops apart: a response needs {:.0f} or more",
                     *high - *low, kLeastRange);
  ResponseFit fit;
  for (int c = 0; c < 3; ++c) fitChannel(responseSamples(codes, brackets, c), c, method, fit);
  compareWithUsual(fit);
  return fit;
}

}  // namespace swaplight
