#include "core/plan/plan_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr size_t kAllOf = 20000;    // plans that are compared one by one
constexpr size_t kStepsAPlan = 40;  // of the search for all plans, before it is given up as too many
// Where there are more: so many climbs from random plans, of at most so many rounds over all entries. A climb
// ends by itself when no change of one colour helps; the rounds only bound it.
constexpr int kStarts = 16;
constexpr int kPasses = 40;
constexpr double kNoGain = 1e-9;  // relative: a smaller gain is one of rounding
// Where the model is not known to be matte or free, both costs count alike.
constexpr double kTransportWeight = 0.5;

using Ring = std::vector<int>;  // of a rotation; the whole table where the coding is free

/// One kind of plan: what a ring stands for, and which rings are allowed.
struct Space {
  const std::vector<PlanColor>& colors;
  const PlanSearchOptions& options;
  int lights, shots;
  int length;
  bool different;  // no colour twice
  std::vector<TypicalPixel> pixels;

  [[nodiscard]] std::vector<int> tableOf(const Ring& ring) const {
    if (options.coding == PlanCoding::Free) return ring;
    std::vector<int> table;
    for (int k = 0; k < shots; ++k)
      for (int i = 0; i < lights; ++i) table.push_back(ring[size_t((i + k) % length)]);
    return table;
  }
  [[nodiscard]] double costOf(const Ring& ring) const {
    const LightingMatrix lighting = lightingFromIndices(colors, tableOf(ring), options);
    const double weight = options.model == Model::Lambert     ? 0
                          : options.model == Model::Transport ? 1
                                                              : kTransportWeight;
    double cost = weight > 0 ? weight * transportCost(lighting, options.noise, pixels) : 0;
    if (weight < 1) cost += (1 - weight) * matteCost(lighting, options.noise, pixels);
    return cost;
  }
  /// A ring that is turned gives the same shots in another order, where they are whole turns.
  [[nodiscard]] bool turns() const { return options.coding == PlanCoding::Rotation && shots % length == 0; }
};

struct Found {
  Ring ring;
  double cost = std::numeric_limits<double>::infinity();
  size_t tried = 0;

  void consider(const Ring& other, double otherCost) {
    if (ring.empty() || otherCost < cost) ring = other, cost = otherCost;
  }
};

/// Every ring, or none where there are more than kAllOf. Of those that are turns of each other the first.
std::vector<Ring> allRings(const Space& space) {
  std::vector<Ring> rings;
  Ring ring;
  const int count = int(space.colors.size());
  size_t steps = 0;
  std::function<bool()> extend = [&] {
    if (++steps > kStepsAPlan * kAllOf) return false;
    if (int(ring.size()) == space.length) {
      rings.push_back(ring);
      return rings.size() <= kAllOf;
    }
    const int first = space.turns() && !ring.empty() ? ring.front() : 0;
    for (int c = first; c < count; ++c) {
      if (space.different && std::find(ring.begin(), ring.end(), c) != ring.end()) continue;
      ring.push_back(c);
      const bool more = extend();
      ring.pop_back();
      if (!more) return false;
    }
    return true;
  };
  if (!extend()) rings.clear();
  return rings;
}

Found bestOf(const Space& space, const std::vector<Ring>& rings, const Progress& progress) {
  std::vector<double> costs(rings.size());
  std::atomic<int> done = 0;
  parallelRows(int(rings.size()), 64, [&](int begin, int end) {
    for (int r = begin; r < end; ++r) costs[size_t(r)] = space.costOf(rings[size_t(r)]);
    progress.update(float(done += end - begin) / float(rings.size()), "Comparing plans");
  });
  Found found;
  for (size_t r = 0; r < rings.size(); ++r) found.consider(rings[r], costs[r]);
  found.tried = rings.size();
  return found;
}

Ring randomRing(const Space& space, std::mt19937& random) {
  Ring order(space.colors.size());
  for (size_t c = 0; c < order.size(); ++c) order[c] = int(c);
  Ring ring;
  for (int p = 0; p < space.length; ++p) {
    const size_t first = space.different ? size_t(p) : 0;
    const size_t chosen = first + random() % (order.size() - first);
    ring.push_back(order[chosen]);
    if (space.different) std::swap(order[first], order[chosen]);
  }
  return ring;
}

/// Takes every change of one colour that helps (a swap, where the colour is taken), until none does.
Found climb(const Space& space, const Ring& ring) {
  Found found;
  found.consider(ring, space.costOf(ring));
  const auto attempt = [&](const Ring& changed) {
    ++found.tried;
    found.consider(changed, space.costOf(changed));
  };
  for (int pass = 0; pass < kPasses; ++pass) {
    const double before = found.cost;
    for (size_t p = 0; p < found.ring.size(); ++p) {
      for (int c = 0; c < int(space.colors.size()); ++c) {
        Ring changed = found.ring;
        if (changed[p] == c) continue;
        const auto taken = std::find(changed.begin(), changed.end(), c);
        if (space.different && taken != changed.end())
          std::swap(changed[p], *taken);
        else
          changed[p] = c;
        attempt(changed);
      }
      for (size_t q = 0; q < p && !space.different; ++q) {
        Ring changed = found.ring;
        std::swap(changed[p], changed[q]);
        if (changed[p] != changed[q]) attempt(changed);
      }
    }
    if (!(found.cost < before * (1 - kNoGain))) break;
  }
  return found;
}

Found climbFromManyStarts(const Space& space, const std::vector<Ring>& starts, const Progress& progress) {
  std::vector<Found> found(kStarts);
  std::atomic<int> done = 0;
  parallelEach(kStarts, [&](int s) {
    std::mt19937 random(static_cast<unsigned>(s + 1));
    found[size_t(s)] =
        climb(space, size_t(s) < starts.size() ? starts[size_t(s)] : randomRing(space, random));
    progress.update(float(++done) / kStarts, "Searching for a plan");
  });
  Found best;
  for (const Found& one : found) {
    best.tried += one.tried;
    best.consider(one.ring, one.cost);
  }
  return best;
}

void check(const std::vector<PlanColor>& colors, const PlanSearchOptions& options, int shots) {
  const int lights = int(options.lights.size());
  if (lights < 2 || lights > kMaxLights)
    throw InputError("--lights: {} lights; a plan is for 2 to {}", lights, kMaxLights);
  if (shots < 1 || shots > kMaxShots)
    throw InputError("--shots: {} shots; a plan is for 1 to {}", shots, kMaxShots);
  if (3 * shots < lights + 2)
    throw InputError("--shots: {} lights are more than {} shot{} x 3 channels can separate; plan at least {}",
                     lights, shots, shots == 1 ? "" : "s", (lights + 4) / 3);
  if (options.model == Model::Transport && shots < lights)
    throw InputError("--shots: the full contributions of {} lights need at least {} shots, not {}", lights,
                     lights, shots);
  const SensorNoise& noise = options.noise;
  if (!(noise.read >= 0 && noise.read <= 1) || !(noise.fullWell > 0))
    throw InputError("--read {}, --full-well {}: read noise is 0 to 1, full well above 0 (full scale = 1)",
                     noise.read, noise.fullWell);
  if (!(std::abs(options.exposureStops) <= 30))
    throw InputError("--exposure: {} is not right; write stops, as 1.5", options.exposureStops);
  if (options.model == Model::Single || options.model == Model::Gloss)
    throw InputError("--model: a plan is for auto, lambert or transport");
  if (options.coding == PlanCoding::Rotation && !options.repeat && int(colors.size()) < lights)
    throw InputError(
        "{} lights that swap their colours need {} colours, here {} {}; name more, or allow --repeat", lights,
        lights, colors.size() == 1 ? "is" : "are", colors.size());
  if (std::none_of(colors.begin(), colors.end(), [](const PlanColor& c) { return c.color != Rgb(0); }))
    throw InputError("every colour at hand is black; name one that is not");
}

}  // namespace

LightingMatrix lightingFromIndices(const std::vector<PlanColor>& colors, const std::vector<int>& index,
                                   const PlanSearchOptions& options) {
  const int lights = int(options.lights.size());
  LightingMatrix plan{int(index.size()) / lights, lights, options.lights, {}};
  const float exposure = std::exp2(options.exposureStops);
  for (int c : index) plan.colors.push_back(exposure * colors[size_t(c)].color);
  return plan;
}

PlanChoice searchPlan(const std::vector<PlanColor>& colors, const PlanSearchOptions& options,
                      const Progress& progress) {
  const int lights = int(options.lights.size());
  const int shots = options.shots > 0 || lights == 0 ? options.shots : lights;
  check(colors, options, shots);
  const bool rotation = options.coding == PlanCoding::Rotation;
  const bool different = rotation && !options.repeat;
  // Few pixels are enough to compare plans by; the more lights, the fewer.
  const std::vector<TypicalPixel> pixels = typicalPixels(lights, std::clamp(192 / lights, 16, 48));

  std::set<int> lengths{rotation ? lights : lights * shots};
  if (rotation && shots > lights && (!different || int(colors.size()) >= shots)) lengths.insert(shots);
  PlanChoice choice;
  choice.exhaustive = true;
  choice.cost = std::numeric_limits<double>::infinity();
  for (int length : lengths) {
    const Space space{colors, options, lights, shots, length, different, pixels};
    const std::vector<Ring> all = allRings(space);
    Found found;
    if (!all.empty()) {
      found = bestOf(space, all, progress);
    } else {
      std::vector<Ring> starts;
      if (!rotation && int(colors.size()) >= lights) {
        PlanSearchOptions rotated = options;
        rotated.coding = PlanCoding::Rotation;
        starts.push_back(searchPlan(colors, rotated, progress).colorIndex);
      }
      found = climbFromManyStarts(space, starts, progress);
      choice.exhaustive = false;
    }
    choice.tried += found.tried;
    if (!choice.colorIndex.empty() && !(found.cost < choice.cost)) continue;
    choice.cost = found.cost;
    choice.colorIndex = space.tableOf(found.ring);
  }
  choice.plan = lightingFromIndices(colors, choice.colorIndex, options);
  return choice;
}

}  // namespace swaplight
