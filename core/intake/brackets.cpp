#include "core/intake/brackets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/capture/lightings.h"
#include "core/intake/exposure_ratio.h"

namespace swaplight {
namespace {

// Stops. Cameras step exposures by thirds.
constexpr double kAlike = 0.1;      ///< exposures no farther apart are the same
constexpr double kDifferent = 0.3;  ///< and farther apart are others
constexpr double kNominal = 0.2;    ///< between what a file states and what its shutter did, at most
constexpr double kLinear = 0.1;     ///< more than this between dark and bright parts is a wrong curve
constexpr double kWrong = 0.05;     ///< of an exposure that was told: 3.5 % of the light

/// Whether a series of that length repeats itself, and its exposures are all different.
bool repeats(const std::vector<double>& stops, size_t length) {
  if (stops.size() % length != 0) return false;
  for (size_t k = length; k < stops.size(); ++k)
    if (std::abs(stops[k] - stops[k % length]) > kAlike) return false;
  for (size_t a = 0; a < length; ++a)
    for (size_t b = 0; b < a; ++b)
      if (std::abs(stops[a] - stops[b]) < kDifferent) return false;
  return true;
}

/// The signal of a shot where it counts as much as it has of it.
double meanSignalOf(const CapturePixels& pixels, size_t shot) {
  const Image& image = pixels.shots[shot];
  const size_t step = 1 + image.pixelCount() / 10000;
  double sum = 0;
  for (size_t p = 0; p < image.pixelCount(); p += step)
    sum += std::isfinite(image.plane(1)[p]) ? std::min(image.plane(1)[p], pixels.clipLevel[shot]) : 0;
  return sum;
}

/// The exposures of shots first .. first + length over the first of them, measured from one to the next
/// brighter one; nothing where they are not of one lighting.
std::optional<std::vector<ExposureRatio>> exposuresOfLighting(const CapturePixels& pixels, size_t first,
                                                              size_t length) {
  std::vector<size_t> order(length);
  std::iota(order.begin(), order.end(), first);
  std::vector<double> means;
  for (size_t k = first; k < first + length; ++k) means.push_back(meanSignalOf(pixels, k));
  std::sort(order.begin(), order.end(),
            [&](size_t a, size_t b) { return means[a - first] < means[b - first]; });
  std::vector<ExposureRatio> measured(length);
  ExposureRatio sum;
  for (size_t j = 1; j < length; ++j) {
    const auto more = exposureRatio(pixels, order[j - 1], order[j]);
    if (!more) return std::nullopt;
    sum.stops += more->stops;
    measured[order[j] - first] = {sum.stops, more->bend};
  }
  const double own = measured[0].stops;
  for (ExposureRatio& one : measured) one.stops -= own;
  return measured;
}

/// The exposures of all shots, if they are brackets of that length: of each over the first of its own.
std::optional<std::vector<ExposureRatio>> measuredBrackets(const CapturePixels& pixels, size_t length) {
  std::vector<ExposureRatio> all;
  for (size_t first = 0; first + length <= pixels.shots.size(); first += length) {
    const auto lighting = exposuresOfLighting(pixels, first, length);
    if (!lighting) return std::nullopt;
    all.insert(all.end(), lighting->begin(), lighting->end());
  }
  return all;
}

Brackets bracketsOf(const std::vector<double>& stops, size_t length, const char* how) {
  Brackets brackets;
  brackets.length = static_cast<int>(length);
  for (const double one : stops) brackets.stops.push_back(static_cast<float>(one - stops[0]));
  brackets.words = length > 1
                       ? fmt::format("brackets of {}: {} stops, {}", length, exposureList(brackets), how)
                       : fmt::format("{} stops, {}", exposureList(brackets), how);
  return brackets;
}

std::optional<std::vector<double>> statedStops(const ShotFolder& folder) {
  std::vector<double> stops;
  for (const FoundShot& shot : folder.shots) {
    if (!shot.exposureStops) return std::nullopt;
    stops.push_back(*shot.exposureStops - *folder.shots.front().exposureStops);
  }
  return stops;
}

/// What the files state, measured where the pictures are linear and do not contradict it.
std::vector<double> refined(std::vector<double> stops, const std::vector<ExposureRatio>& measured,
                            size_t length) {
  for (size_t k = 0; k < stops.size(); ++k) {
    const double base = stops[k / length * length], seen = base + measured[k].stops;
    if (std::abs(measured[k].bend) < kLinear && std::abs(seen - stops[k]) < kNominal) stops[k] = seen;
  }
  return stops;
}

double stopsFromText(std::string_view text) {
  const size_t first = std::min(text.find_first_not_of(' '), text.size());
  const std::string_view word = text.substr(first, text.find_last_not_of(' ') + 1 - first);
  const std::optional<float> stops = numberFromText(word);
  if (!stops || std::abs(*stops) > kMostExposureStops)
    throw InputError("exposures: '{}' is no number of stops; write 0,-3,+2", text);
  return *stops;
}

}  // namespace

std::string exposureList(const Brackets& brackets) {
  const size_t count = brackets.length > 1 ? static_cast<size_t>(brackets.length) : brackets.stops.size();
  std::string list;
  for (size_t k = 0; k < std::min(count, brackets.stops.size()); ++k) {
    const double rounded = std::round(100 * double(brackets.stops[k])) / 100;
    list += (k ? ", " : "") + (rounded == 0 ? "0" : fmt::format("{:+g}", rounded));
  }
  return list;
}

Brackets toldBrackets(const ShotFolder& folder, const std::string& exposures) {
  std::vector<double> series;
  std::istringstream parts(exposures);
  for (std::string part; std::getline(parts, part, ',');) series.push_back(stopsFromText(part));
  if (series.empty() || folder.shots.size() % series.size() != 0)
    throw InputError(
        "exposures {}: {} of them for {} photographs; give those of one bracket, which all others repeat, or "
        "one a photograph",
        exposures, series.size(), folder.shots.size());
  std::vector<double> stops;
  for (size_t k = 0; k < folder.shots.size(); ++k) stops.push_back(series[k % series.size()]);
  size_t length = series.size();
  if (length == stops.size()) {
    length = 1;
    for (size_t shorter = 2; shorter <= stops.size() / 2 && length == 1; ++shorter)
      if (repeats(stops, shorter)) length = shorter;
  }
  return bracketsOf(stops, length, "as told");
}

Brackets findBrackets(const ShotFolder& folder, const CapturePixels& pixels) {
  const size_t count = folder.shots.size();
  const auto stated = statedStops(folder);
  for (size_t length = count / 2; length >= 2; --length) {
    if (count % length != 0 || (stated && !repeats(*stated, length))) continue;
    const auto measured = measuredBrackets(pixels, length);
    if (!measured) continue;
    if (stated)
      return bracketsOf(refined(*stated, *measured, length), length, "by the files and the photographs");
    std::vector<double> seen;
    for (const ExposureRatio& one : *measured) seen.push_back(one.stops);
    if (repeats(seen, length)) return bracketsOf(seen, length, "by the ratios of the photographs");
  }
  return {};
}

Brackets statedBrackets(const ShotFolder& folder) {
  const auto stated = statedStops(folder);
  if (!stated)
    throw InputError("the photographs do not say their exposures: tell them (--exposures 0,-3,+2)");
  for (size_t length = 2; length <= stated->size(); ++length)
    if (repeats(*stated, length)) return bracketsOf(*stated, length, "by the files");
  throw InputError("the exposures in the files are no brackets: tell them (--exposures 0,-3,+2)");
}

std::vector<std::string> bracketWarnings(const ShotFolder& folder, const CapturePixels& pixels,
                                         const Brackets& brackets) {
  std::vector<std::string> warnings;
  if (brackets.length < 2) return warnings;
  const auto length = static_cast<size_t>(brackets.length);
  double bend = 0, off = 0;
  size_t bent = 0, wrong = 0;
  for (size_t first = 0; first + length <= pixels.shots.size(); first += length) {
    const auto measured = exposuresOfLighting(pixels, first, length);
    if (!measured) {
      warnings.push_back(fmt::format("{}: the photographs of its bracket are not of one lighting",
                                     folder.shots[first].file));
      continue;
    }
    for (size_t k = first + 1; k < first + length; ++k) {
      const ExposureRatio& seen = (*measured)[k - first];
      const double difference = seen.stops - (brackets.stops[k] - brackets.stops[first]);
      if (std::abs(seen.bend) > std::abs(bend)) bend = seen.bend, bent = k;
      if (std::abs(difference) > std::abs(off)) off = difference, wrong = k;
    }
  }
  if (std::abs(bend) > kLinear)
    warnings.push_back(
        fmt::format("{}: a bracket's ratio changes by {:+.2f} stops from dark to bright: the photographs do "
                    "not hold light as their colour space says; a solve will be wrong",
                    folder.shots[bent].file, bend));
  else if (std::abs(off) > kWrong)
    warnings.push_back(
        fmt::format("{}: by the photographs its exposure is {:+.2f} stops, not {:+.2f}{}",
                    folder.shots[wrong].file, double(brackets.stops[wrong]) + off, brackets.stops[wrong],
                    std::abs(off) > kNominal ? ": that, or their colour space, is wrong" : ""));
  return warnings;
}

}  // namespace swaplight
