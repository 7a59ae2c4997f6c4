#include "core/solve/highlights/highlights.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.h"
#include "core/solve/highlights/highlight_holes.h"
#include "core/solve/highlights/highlight_surroundings.h"

namespace swaplight {
namespace {

using Place = HighlightSurroundings::Place;
using Values = std::array<float, kMaxLights>;

constexpr float kLeastSaturation = 0.02F;  // of a surface that can show a highlight
constexpr float kShadow = 0.5F;            // of a light around: less is a shadow
constexpr float kBounced = 0.15F;          // of the brightest light around: less may be thrown back by things
constexpr float kRim = 0.3F;               // of its peak that one has at its rim, at most
constexpr double kWorthwhile = 1e-4;       // part of the picture that has to show highlights
constexpr int kReach = 2;                  // pixels around one
constexpr int kSupport = 12;               // of the 25 there that have to show highlights, too
constexpr int kRows = 16;                  // at once
constexpr const char* kWhat = "Finding highlights";
constexpr int kUnusable = kTooDark | kMoved | kNotFinite;

/// What is asked of a highlight.
struct Demand {
  float sure;    ///< standard errors above none
  float peak;    ///< times the light around
  float alone;   ///< the same, of one that drowns the other lights
  bool swamped;  ///< whether it has to drown them in its noise
};
/// To begin, and to go on from one that has begun.
constexpr Demand kStrong{3, 1.5F, 3, true}, kWeak{2, 1, 1, false};

/// A highlight, and how many standard errors it is above none.
struct Found {
  float height = 0, certainty = 0;
};

/// Of a light on a surface of this saturation that would give back `matte` of it at least.
Found highlightOn(const LightSaturation& pixel, size_t light, float saturation, float matte) {
  if (saturation < kLeastSaturation) return {};
  const float height = pixel.mean[light] - std::max(pixel.color[light] / saturation, matte);
  const float error = pixel.error * std::sqrt(1.0F / 3 + 1 / (saturation * saturation));
  return {height, height / error};
}

/// The saturation that a light which shines here itself, not only by what things around throw back, surely
/// has; the most of them.
float ownSaturation(const LightSaturation& pixel, const Place& place) {
  const float brightest = *std::max_element(place.level, place.level + pixel.lights);
  float most = 0;
  for (int i = 0; i < pixel.lights; ++i)
    if (pixel.mean[static_cast<size_t>(i)] >= std::max(kShadow * place.level[i], kBounced * brightest))
      most = std::max(most, pixel.of(i) - kStrong.sure * pixel.errorOf(i));
  return most;
}

/// Whether the light peaks here while no other one shows the surface to be white, or falls into shadow.
bool peaksAlone(const LightSaturation& pixel, size_t light, const Place& place, const Demand& demand) {
  if (pixel.mean[light] <= demand.alone * place.level[light]) return false;
  const bool swamped = HighlightSurroundings::isSwamped(pixel, place);
  if (demand.swamped && !swamped) return false;
  for (int j = 0; j < pixel.lights; ++j) {
    const auto other = static_cast<size_t>(j);
    if (other == light) continue;
    if (!swamped && pixel.of(j) + kStrong.sure * pixel.errorOf(j) < place.saturation) return false;
    if (pixel.mean[other] + 2 * pixel.error < kShadow * place.level[other]) return false;
  }
  return true;
}

/// Each light's highlight at a pixel; whether there is one.
bool highlightsAt(const LightSaturation& pixel, const Place& place, const Demand& demand,
                  Values& highlights) {
  const float own = ownSaturation(pixel, place);
  bool any = false;
  for (size_t i = 0; i < static_cast<size_t>(pixel.lights); ++i) {
    Found best = highlightOn(pixel, i, own, 0);
    if (best.certainty <= demand.sure || pixel.mean[i] <= demand.peak * place.level[i]) best = {};
    const Found least = highlightOn(pixel, i, place.leastSaturation, place.level[i]);
    if (least.certainty > demand.sure && peaksAlone(pixel, i, place, demand))
      if (const Found lost = highlightOn(pixel, i, place.saturation, place.level[i]);
          lost.height > best.height)
        best = lost;
    const float doubt = best.certainty > demand.sure ? demand.sure / best.certainty : 1;
    highlights[i] = std::clamp(best.height * (1 - doubt * doubt), 0.0F, std::max(pixel.least[i], 0.0F));
    any |= highlights[i] > 0;
  }
  return any;
}

bool usable(const SolvedSet& set, size_t p) {
  return (static_cast<int>(set.quality.plane(kFlags)[p]) & kUnusable) == 0;
}

bool worthwhile(const SolvedSet& set, const HighlightSurroundings& around) {
  size_t found = 0, all = 0;
  Values values;
  around.eachSample([&](int x, int y, const LightSaturation& pixel) {
    const size_t p = static_cast<size_t>(y) * static_cast<size_t>(set.width()) + static_cast<size_t>(x);
    ++all;
    found += highlightsAt(pixel, around.at(x, y), kStrong, values) && usable(set, p);
  });
  return static_cast<double>(found) > kWorthwhile * static_cast<double>(all);
}

enum Mark : uint8_t { None, Weak, Strong, Seen, Kept };

/// Highlights of all pixels into the set, and how they are told.
void fillIn(SolvedSet& set, const HighlightSurroundings& around, std::vector<uint8_t>& marks,
            const Progress& progress) {
  std::atomic<int> done = 0;
  parallelRows(set.height(), kRows, [&](int begin, int end) {
    Values values, strong;
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < set.width(); ++x) {
        const size_t p = static_cast<size_t>(y) * static_cast<size_t>(set.width()) + static_cast<size_t>(x);
        if (!usable(set, p)) continue;
        const LightSaturation pixel = saturationAt(set, p, around.leastError());
        if (!highlightsAt(pixel, around.at(x, y), kWeak, values)) continue;
        marks[p] = highlightsAt(pixel, around.at(x, y), kStrong, strong) ? Strong : Weak;
        for (size_t i = 0; i < set.highlights.size(); ++i)
          for (int c = 0; c < 3; ++c) set.highlights[i].plane(c)[p] = values[i];
      }
    progress.update(float(done += end - begin) / float(set.height()), kWhat);
  });
}

/// Calls use(pixel) for those within `reach` of one.
template <typename Use>
void eachAround(const SolvedSet& set, size_t p, int reach, const Use& use) {
  const int x = static_cast<int>(p % static_cast<size_t>(set.width()));
  const int y = static_cast<int>(p / static_cast<size_t>(set.width()));
  for (int v = std::max(0, y - reach); v <= std::min(set.height() - 1, y + reach); ++v)
    for (int u = std::max(0, x - reach); u <= std::min(set.width() - 1, x + reach); ++u)
      use(static_cast<size_t>(v) * static_cast<size_t>(set.width()) + static_cast<size_t>(u));
}

/// The height of the highest highlight of a pixel.
float heightAt(const SolvedSet& set, size_t p) {
  float most = 0;
  for (const Image& highlight : set.highlights) most = std::max(most, highlight.plane(0)[p]);
  return most;
}

/// All marked pixels that hang together with one (hysteresis: Canny 1986). They become Seen.
std::vector<size_t> regionOf(const SolvedSet& set, size_t seed, std::vector<uint8_t>& marks) {
  std::vector<size_t> region = {seed};
  marks[seed] = Seen;
  for (size_t next = 0; next < region.size(); ++next)
    eachAround(set, region[next], 1, [&](size_t q) {
      if (marks[q] == None || marks[q] >= Seen) return;
      marks[q] = Seen;
      region.push_back(q);
    });
  return region;
}

/// Whether it fades towards its rim as a highlight does; a white thing ends with its full brightness.
bool fades(const SolvedSet& set, const std::vector<size_t>& region, const std::vector<uint8_t>& marks) {
  float peak = 0, rim = 0;
  size_t count = 0;
  for (const size_t p : region) {
    peak = std::max(peak, heightAt(set, p));
    bool inside = true;
    eachAround(set, p, 1, [&](size_t q) { inside &= marks[q] != None; });
    if (inside) continue;
    rim += heightAt(set, p);
    ++count;
  }
  return rim <= kRim * peak * static_cast<float>(count);
}

/// Keeps regions that hold a strong mark which does not stand alone or in a line, as where two surfaces share
/// a pixel, and that fade. Returns how many pixels.
size_t keepRegions(const SolvedSet& set, std::vector<uint8_t>& marks) {
  std::vector<size_t> seeds;
  for (size_t p = 0; p < marks.size(); ++p) {
    if (marks[p] != Strong) continue;
    int count = 0;
    eachAround(set, p, kReach, [&](size_t q) { count += marks[q] == Strong; });
    if (count >= kSupport) seeds.push_back(p);
  }
  size_t kept = 0;
  for (const size_t seed : seeds) {
    if (marks[seed] >= Seen) continue;
    const std::vector<size_t> region = regionOf(set, seed, marks);
    if (!fades(set, region, marks)) continue;
    for (const size_t p : region) marks[p] = Kept;
    kept += region.size();
  }
  return kept;
}

/// Takes away the highlights that are not kept.
void dropOthers(const std::vector<uint8_t>& marks, SolvedSet& set) {
  for (size_t p = 0; p < marks.size(); ++p) {
    if (marks[p] == None || marks[p] == Kept) continue;
    for (Image& highlight : set.highlights)
      for (int c = 0; c < 3; ++c) highlight.plane(c)[p] = 0;
  }
}

}  // namespace

void findHighlights(SolvedSet& set, const Progress& progress) {
  progress.update(0, kWhat);
  if (set.lightCount() < 2 || set.quality.empty()) return;
  const HighlightSurroundings around(set);
  if (!(around.leastError() > 0) || !worthwhile(set, around)) return;
  for (const Image& light : set.contributions) set.highlights.emplace_back(light.spec(), 0.0F);
  std::vector<uint8_t> marks(set.beta.pixelCount(), None);
  fillIn(set, around, marks, progress);
  size_t kept = keepRegions(set, marks);
  if (static_cast<double>(kept) < kWorthwhile * static_cast<double>(marks.size()))
    return set.highlights.clear();
  dropOthers(marks, set);
  std::vector<bool> has(marks.size());
  std::transform(marks.begin(), marks.end(), has.begin(), [](uint8_t mark) { return mark == Kept; });
  kept += fillHighlightHoles(set, has, progress);
  const double part = static_cast<double>(kept) / static_cast<double>(marks.size());
  if (!set.report) return;
  set.report->highlights = part;
  set.report->message += fmt::format(" Highlights in {:.2f} % of the picture.", 100 * part);
}

}  // namespace swaplight
