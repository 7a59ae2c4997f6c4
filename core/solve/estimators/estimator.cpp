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

constexpr std::array kEstimators = {
    EstimatorInfo{"brute-force", Model::Lambert,
                  "the dissertation's search of 1000 steps and its relight formula; two lights; reference",
                  false},
    EstimatorInfo{"published", Model::Lambert,
                  "the same minimum in closed form, with its relight formula; two lights", false},
    EstimatorInfo{"closed-form", Model::Lambert,
                  "the same minimum in closed form, reflectance from both shots; two lights; fastest", false},
    EstimatorInfo{"single", Model::Single, "the one light that explains the pixel best", true},
    EstimatorInfo{"maximum-likelihood", Model::Lambert,
                  "proportions x reflectance, fitted to all shots by their noise", true},
    EstimatorInfo{"dichromatic", Model::Gloss, "the same, and a highlight of each light's colour", true},
    EstimatorInfo{"demultiplex", Model::Transport, "pseudo-inverse a channel, negative values cut off",
                  false},
    EstimatorInfo{"nnls", Model::Transport, "least squares a channel over contributions >= 0", false},
    EstimatorInfo{"auto", Model::Auto, "what each pixel needs, by evidence, with its neighbours' help", true},
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
  switch (model) {
    case Model::Single:
      return estimatorInfo("single");
    case Model::Lambert:
      return estimatorInfo("maximum-likelihood");
    case Model::Transport:
      return estimatorInfo("nnls");
    case Model::Gloss:
      return estimatorInfo("dichromatic");
    case Model::Auto:
      break;
  }
  return estimatorInfo("auto");
}

std::unique_ptr<Estimator> makeEstimator(const std::string& name, const EstimatorContext& context) {
  const EstimatorInfo& info = estimatorInfo(name);
  if (info.name == "brute-force")
    return std::make_unique<TwoLights>(context, BetaSearch::BruteForce, Reflectance::Published);
  if (info.name == "published")
    return std::make_unique<TwoLights>(context, BetaSearch::ClosedForm, Reflectance::Published);
  if (info.name == "closed-form")
    return std::make_unique<TwoLights>(context, BetaSearch::ClosedForm, Reflectance::BothShots);
  if (info.name == "single") return std::make_unique<SingleLight>(context);
  if (info.name == "dichromatic") return std::make_unique<GlossFit>(context);
  if (info.name == "demultiplex") return std::make_unique<Demultiplex>(context, Demultiplex::Bound::Clamp);
  if (info.name == "nnls") return std::make_unique<Demultiplex>(context, Demultiplex::Bound::LeastSquares);
  return std::make_unique<Lambert>(context);
}

}  // namespace swaplight
