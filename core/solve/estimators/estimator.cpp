#include "core/solve/model/estimator.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/solve/estimators/demultiplex.h"
#include "core/solve/estimators/gloss_fit.h"
#include "core/solve/estimators/matte_fit.h"
#include "core/solve/estimators/single_light.h"
#include "core/solve/estimators/two_lights.h"

namespace swaplight {
namespace {

template <typename Kind, auto... kHow>
std::unique_ptr<Estimator> make(const EstimatorContext& context) {
  return std::make_unique<Kind>(context, kHow...);
}

constexpr std::array kEstimators = {
    EstimatorInfo{"brute-force", Model::Lambert, false,
                  "reference grid search (1000 steps) and its relight formula; two lights", false,
                  make<TwoLights, BetaSearch::BruteForce, Reflectance::Published>},
    EstimatorInfo{"published", Model::Lambert, false,
                  "the same minimum in closed form, with its relight formula; two lights", false,
                  make<TwoLights, BetaSearch::ClosedForm, Reflectance::Published>},
    EstimatorInfo{"closed-form", Model::Lambert, false,
                  "the same minimum in closed form, reflectance from both shots; two lights; fastest", false,
                  make<TwoLights, BetaSearch::ClosedForm, Reflectance::BothShots>},
    EstimatorInfo{"single", Model::Single, true, "the one light that explains the pixel best", true,
                  make<SingleLight>},
    EstimatorInfo{"maximum-likelihood", Model::Lambert, true,
                  "beta x reflectance, maximum likelihood over all photographs", true, make<Lambert>},
    EstimatorInfo{"dichromatic", Model::Gloss, true, "the same, and a highlight of each light's colour", true,
                  make<GlossFit>},
    EstimatorInfo{"demultiplex", Model::Transport, false,
                  "pseudo-inverse per channel, negative values clamped", false,
                  make<Demultiplex, Demultiplex::Bound::Clamp>},
    EstimatorInfo{"nnls", Model::Transport, true, "non-negative least squares per channel", false,
                  make<Demultiplex, Demultiplex::Bound::LeastSquares>},
    // Of pixels by themselves it is the matte fit; what their neighbours say of them is solveAuto's.
    EstimatorInfo{"auto", Model::Auto, true, "what each pixel needs, by evidence and its neighbours", true,
                  make<Lambert>},
};

}  // namespace

SolvedRun runAt(SolvedSet& set, size_t first) {
  SolvedRun run;
  for (int i = 0; i < set.lightCount(); ++i)
    for (int c = 0; c < 3; ++c) run.contribution[i][c] = set.contributions[size_t(i)].plane(c) + first;
  for (int i = 0; i < set.lightCount(); ++i) run.beta[i] = set.beta.plane(i) + first;
  run.residual = set.quality.plane(kResidual) + first;
  run.sigma = set.quality.plane(kSigma) + first;
  return run;
}

void writeBeta(int lights, int count, const SolvedRun& run) {
  sharesOf(lights, &run.contribution[0][0], run.beta, size_t(count));
}

std::span<const EstimatorInfo> estimators() {
  return kEstimators;
}

const EstimatorInfo& estimatorInfo(const std::string& name) {
  for (const EstimatorInfo& info : kEstimators)
    if (info.name == name) return info;
  std::vector<std::string_view> known;
  known.reserve(kEstimators.size());
  for (const EstimatorInfo& info : kEstimators) known.push_back(info.name);
  throw InputError("solver '{}' is not known; known: {}", name, fmt::join(known, ", "));
}

const EstimatorInfo& estimatorFor(Model model) {
  return *std::find_if(kEstimators.begin(), kEstimators.end(),
                       [&](const EstimatorInfo& info) { return info.model == model && info.standsForModel; });
}

}  // namespace swaplight
