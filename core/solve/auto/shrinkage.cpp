#include "core/solve/auto/shrinkage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/quantile.h"
#include "core/linear/decompositions.h"
#include "core/solve/estimators/run_scratch.h"
#include "core/solve/model/pixel_sample.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

Shrinkage::Shrinkage(const EstimatorContext& context, const ShotSignal& signal, const ShrinkageTuning& tuning)
    : m_tuning(tuning), m_matte(context) {
  const int n = context.lighting.lights;
  const int k3 = 3 * context.lighting.shots;
  const int d = 3 * n;
  m_plan.lights = n;
  m_plan.shots = context.lighting.shots;
  m_plan.constant = context.noise.constant;
  m_plan.linear = context.noise.linear;
  m_plan.square = context.noise.square;
  for (int k = 0; k < context.lighting.shots; ++k)
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < n; ++i) m_plan.color.push_back(context.lighting.color(k, i)[c]);

  // The shape of the noise over shots and channels: that of the set's mean signal.
  const std::vector<Rgb> mean = signal.meanSignal();
  Eigen::VectorXd shape(k3);
  for (int k = 0; k < context.lighting.shots; ++k)
    for (int c = 0; c < 3; ++c) shape[k * 3 + c] = double(context.noise.variance(mean[size_t(k)][c]));
  shape /= shape.mean();
  for (int m = 0; m < k3; ++m) m_plan.shape.push_back(float(1 / shape[m]));

  // D^-1/2 A P^1/2 = U S W'.
  Eigen::Matrix3d prior =
      Eigen::Matrix3d::Constant(tuning.whiteness) + (1 - tuning.whiteness) * Eigen::Matrix3d::Identity();
  // What no light shows is not led by the other channels: it stays dark.
  for (int c = 0; c < 3; ++c)
    if (context.lighting.matrix(c).isZero()) {
      m_plan.unseen[size_t(c)] = 1;
      prior.row(c).setZero();
      prior.col(c).setZero();
      prior(c, c) = 1;
    }
  const SymmetricEigen eigen = symmetricEigen(prior);
  const Eigen::VectorXd roots = eigen.values.cwiseSqrt();
  const Eigen::Matrix3d root = eigen.vectors * roots.asDiagonal() * eigen.vectors.transpose();
  const Eigen::Matrix3d inverseRoot =
      eigen.vectors * roots.cwiseInverse().asDiagonal() * eigen.vectors.transpose();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(k3, d);
  for (int k = 0; k < context.lighting.shots; ++k)
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < n; ++i)
        for (int e = 0; e < 3; ++e)
          a(k * 3 + c, i * 3 + e) =
              double(context.lighting.color(k, i)[c]) * root(c, e) / std::sqrt(shape[k * 3 + c]);
  const SingularValues svd = singularValues(a);
  const int rank = int(svd.values.size());
  for (int m = 0; m < d; ++m) {
    m_plan.singular.push_back(m < rank ? float(svd.values[m]) : 0.0F);
    for (int j = 0; j < k3; ++j)
      m_plan.toModes.push_back(m < rank ? float(svd.u(j, m) / std::sqrt(shape[j])) : 0.0F);
    for (int j = 0; j < d; ++j) m_plan.modes.push_back(float(svd.v(j, m)));
  }
  for (int c = 0; c < 3; ++c)
    for (int e = 0; e < 3; ++e) m_plan.whiten[size_t(c) * 3 + size_t(e)] = float(inverseRoot(c, e));
  m_plan.greyPower.assign(size_t(d), 0.0F);
  for (int i = 0; i < n; ++i) {
    Eigen::RowVectorXd grey = Eigen::RowVectorXd::Zero(d);
    for (int c = 0; c < 3; ++c) {
      const Eigen::RowVectorXd row = root.row(c) * svd.v.middleRows(i * 3, 3);
      if (m_plan.unseen[size_t(c)] == 0) grey += row;
      for (int m = 0; m < d; ++m) m_plan.fromModes.push_back(float(row[m]));
    }
    for (int m = 0; m < d; ++m) m_plan.greyPower[size_t(m)] += float(grey[m] * grey[m] / n);
  }
  const float freedom = float(std::max(m_matte.freedom(), 1));
  m_gate = freedom + tuning.gate * std::sqrt(2 * freedom);
}

void Shrinkage::learn(const ShotSignal& signal, const float* noise) {
  std::vector<size_t> index;
  const auto size = size_t(m_tuning.sample);
  PackedRun sample = pixelSample(signal, m_plan.shots, size, &index);
  // A shot that is clipped throughout leaves no whole pixel; the other shots still show the surfaces.
  if (index.empty()) sample = pixelSample(signal, m_plan.shots, size, &index, SamplePixels::Partial);
  m_plan.prior.weight.fill(1.0F / ShrinkagePrior::kScales);
  if (index.empty()) return;  // nothing can be learnt: every scale is 0, the matte fit
  const int count = sample.run().count;
  MatteScratch matte(m_plan.lights, count);
  m_matte.fit(sample.run(), matte.run());
  std::vector<float> brightness(size_t(count), 0.0F);
  for (int p = 0; p < count; ++p)
    for (int c = 0; c < 3; ++c) brightness[size_t(p)] += matte.run().reflectance[c][p] / 3;
  const float bright = std::max(quantile(std::span(brightness), m_tuning.brightLevel), 1e-6F);
  m_plan.prior.scale = {0, m_tuning.smallScale * bright, m_tuning.middleScale * bright,
                        m_tuning.largeScale * bright};
  constexpr size_t kScales = ShrinkagePrior::kScales;
  const size_t padded = roundedUpToLanes(size_t(count));
  std::vector<float> evidence(padded * kScales);
  ShrinkageRun out;
  for (size_t j = 0; j < kScales; ++j) out.logEvidence[j] = &evidence[j * padded];
  std::vector<float> factor(padded, 1.0F);
  if (noise)
    for (size_t p = 0; p < index.size(); ++p) factor[p] = noise[index[p]];
  SWAPLIGHT_KERNEL(shrinkRun)(m_plan, sample.run(), matte.run(), nullptr, factor.data(), out);
  std::vector<std::array<double, kScales>> likelihood(static_cast<size_t>(count));  // over the likeliest
  for (int p = 0; p < count; ++p) {
    float best = evidence[size_t(p)];
    for (size_t j = 1; j < kScales; ++j) best = std::max(best, evidence[j * padded + size_t(p)]);
    for (size_t j = 0; j < kScales; ++j)
      likelihood[size_t(p)][j] = std::exp(double(evidence[j * padded + size_t(p)] - best));
  }
  for (int round = 0; round < m_tuning.rounds; ++round) {
    std::array<double, kScales> responsibility{};
    for (const auto& ofPixel : likelihood) {
      std::array<double, kScales> weight;
      double sum = 0;
      for (size_t j = 0; j < kScales; ++j) sum += weight[j] = double(m_plan.prior.weight[j]) * ofPixel[j];
      for (size_t j = 0; j < kScales; ++j) responsibility[j] += weight[j] / sum;
    }
    for (size_t j = 0; j < kScales; ++j)
      m_plan.prior.weight[j] = std::max(float(responsibility[j] / count), m_tuning.leastWeight);
  }
}

void Shrinkage::finish(const PixelRun& in, const MatteRun& matte, const Evidence& evidence,
                       const SolvedRun& out, float* notMatte) const {
  const int n = m_plan.lights;
  // Written always and counted where it holds: which pixels it does, no processor foresees.
  std::vector<int> index(size_t(in.count) + 1);
  size_t found = 0;
  for (int p = 0; p < in.count; ++p) {
    index[found] = p;
    found += evidence.misfit[p] > m_gate;
  }
  index.resize(found);
  const auto gather = [&](const float* from, float* to) {
    for (size_t j = 0; j < index.size(); ++j) to[j] = from[index[j]];
  };
  const size_t padded = roundedUpToLanes(index.size());
  std::vector<float> odds(padded, 1.0F);
  if (evidence.odds) gather(evidence.odds, odds.data());
  std::vector<float> noise(padded, 1.0F);
  if (evidence.noise) gather(evidence.noise, noise.data());
  writeContributions(matte, n, in.count, out);
  writeQuality(matte, m_matte.freedom(), in.count, out);
  if (notMatte) std::fill_n(notMatte, in.count, 0.0F);
  if (index.empty()) return;

  // Pixels that need more, packed together.
  PackedRun packed(m_plan.shots, index.size());
  MatteScratch fit(n, int(index.size()));
  std::vector<float> room(padded * size_t(3 * n + 2));
  float* next = room.data();
  const auto take = [&] { return std::exchange(next, next + padded); };
  SolvedRun solved;
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) solved.contribution[i][c] = take();
  solved.sigma = take();
  float* probability = take();
  packed.add(in, index);
  for (int i = 0; i < n; ++i) gather(matte.share[i], fit.run().share[i]);
  for (int c = 0; c < 3; ++c) gather(matte.reflectance[c], fit.run().reflectance[c]);
  gather(matte.variance, fit.run().variance);
  ShrinkageRun to;
  to.solved = &solved;
  to.notMatte = probability;
  SWAPLIGHT_KERNEL(shrinkRun)(m_plan, packed.run(), fit.run(), odds.data(), noise.data(), to);
  const auto scatter = [&](const float* from, float* all) {
    for (size_t j = 0; j < index.size(); ++j) all[index[j]] = from[j];
  };
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) scatter(solved.contribution[i][c], out.contribution[i][c]);
  if (out.sigma) scatter(solved.sigma, out.sigma);
  if (notMatte) scatter(probability, notMatte);
}

}  // namespace swaplight
