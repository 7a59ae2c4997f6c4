#include "core/solve/calibration/color_equations.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/linear/decompositions.h"
#include "core/solve/estimators/matte_slopes.h"

namespace swaplight {
namespace {

constexpr int kTogether = 128;  // pixels: their rows stay in a core's cache

}  // namespace

ColorEquations::ColorEquations(const EstimatorContext& context, const PixelRun& in, const MatteRun& fit,
                               double baseUncertainty, const ColorUnknowns& unknowns)
    : m_pixels(in.count),
      m_unknowns(unknowns.count),
      m_blocks(size_t((in.count + kTogether - 1) / kTogether)),
      m_scale(size_t(in.count)),
      m_noise(size_t(in.count)) {
  parallelEach(int(m_blocks.size()), [&](int b) {
    Block& block = m_blocks[size_t(b)];
    block.firstPixel = b * kTogether;
    block.firstRow.push_back(0);
    const int pixels = std::min(kTogether, in.count - block.firstPixel);
    const Eigen::Index most = Eigen::Index(pixels) * 3 * context.lighting.shots;
    block.slopes = Eigen::MatrixXd::Zero(most, unknowns.count);
    block.residual.resize(most);
    for (int j = 0; j < pixels; ++j)
      addPixel(context, in, fit, block.firstPixel + j, baseUncertainty, unknowns, block);
    block.slopes.conservativeResize(block.firstRow.back(), Eigen::NoChange);
    block.residual.conservativeResize(block.firstRow.back());
  });
}

void ColorEquations::addPixel(const EstimatorContext& context, const PixelRun& in, const MatteRun& fit,
                              int pixel, double baseUncertainty, const ColorUnknowns& unknowns,
                              Block& block) {
  const LightingMatrix& lighting = context.lighting;
  const MatteSlopes slopes = matteSlopes(context, in, fit, pixel, baseUncertainty);
  const double power = slopes.predicted.squaredNorm();
  m_scale[size_t(pixel)] =
      double(slopes.predicted.size()) / (std::sqrt(std::max(power, 1e-30)) * slopes.weight.norm());
  double noise = 0;
  for (const double value : slopes.predicted) noise += double(context.noise.variance(float(value)));
  m_noise[size_t(pixel)] = noise / std::max(power, 1e-30);

  const Eigen::MatrixXd free = orthogonalComplement(slopes.own).transpose();
  const Eigen::Index first = block.firstRow.back();
  block.residual.segment(first, free.rows()) = free * slopes.residual;
  for (int k = 0; k < lighting.shots; ++k)
    for (int i = 0; i < lighting.lights; ++i)
      for (int c = 0; c < 3; ++c) {
        const double light =
            double(lighting.color(k, i)[c]) * double(fit.share[i][pixel]) * double(fit.reflectance[c][pixel]);
        const int unknown = unknowns.of[size_t(3 * (k * lighting.lights + i) + c)];
        block.slopes.col(unknown).segment(first, free.rows()) +=
            slopes.weight[3 * k + c] * light * free.col(3 * k + c);
      }
  block.firstRow.push_back(first + free.rows());
}

ColorEquations::Sums ColorEquations::sums(const std::vector<double>& weights) const {
  std::vector<Sums> parts(m_blocks.size());
  parallelEach(int(m_blocks.size()), [&](int b) {
    const Block& block = m_blocks[size_t(b)];
    Eigen::VectorXd roots(block.residual.size());
    for (int j = 0; j < block.pixels(); ++j)
      roots.segment(block.firstRow[size_t(j)], block.rows(j))
          .setConstant(std::sqrt(weights[size_t(block.firstPixel + j)]));
    const Eigen::MatrixXd weighted = roots.asDiagonal() * block.slopes;
    Sums& part = parts[size_t(b)];
    part.normal = Eigen::MatrixXd::Zero(m_unknowns, m_unknowns);
    part.normal.selfadjointView<Eigen::Lower>().rankUpdate(weighted.transpose());
    part.right = weighted.transpose() * roots.cwiseProduct(block.residual);
  });
  Sums all{Eigen::MatrixXd::Zero(m_unknowns, m_unknowns), Eigen::VectorXd::Zero(m_unknowns)};
  for (const Sums& part : parts) {
    all.normal += part.normal;
    all.right += part.right;
  }
  all.normal = Eigen::MatrixXd(all.normal.selfadjointView<Eigen::Lower>());
  return all;
}

std::vector<double> ColorEquations::squaredLeft(const Eigen::VectorXd& step) const {
  std::vector<double> squared(static_cast<size_t>(m_pixels));
  parallelEach(int(m_blocks.size()), [&](int b) {
    const Block& block = m_blocks[size_t(b)];
    const Eigen::VectorXd left = block.residual - block.slopes * step;
    for (int j = 0; j < block.pixels(); ++j)
      squared[size_t(block.firstPixel + j)] =
          left.segment(block.firstRow[size_t(j)], block.rows(j)).squaredNorm();
  });
  return squared;
}

}  // namespace swaplight
