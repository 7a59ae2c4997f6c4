#include "core/normals/normal_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

/// One weighted fit; false where the directions are too much alike.
bool solve(std::span<const LampSight> sights, const Eigen::VectorXd& weights, NormalFit& fit) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < sights.size(); ++i) {
    const double weight = weights[static_cast<Eigen::Index>(i)];
    normal += weight * sights[i].direction * sights[i].direction.transpose();
    right += weight * sights[i].light * sights[i].direction;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(normal, Eigen::EigenvaluesOnly);
  fit.spread = solver.eigenvalues()[0];
  if (!fit.known()) return false;
  fit.scaled = normal.inverse() * right;
  return true;
}

}  // namespace

NormalFit fitNormal(std::span<const LampSight> sights, int rounds) {
  NormalFit fit;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(sights.size()));
  if (sights.size() < kFewestLamps || !solve(sights, weights, fit) || sights.size() == kFewestLamps)
    return fit;
  for (int round = 0;; ++round) {
    const double reflectance = std::max(fit.scaled.norm(), 1e-12);
    double squares = 0;
    for (size_t i = 0; i < sights.size(); ++i) {
      const double off = (sights[i].light - sights[i].direction.dot(fit.scaled)) / reflectance;
      squares += off * off;
      weights[static_cast<Eigen::Index>(i)] = 1 / std::pow(1 + std::pow(off / kOutlier, 2), 2);
    }
    fit.residual = std::sqrt(squares / static_cast<double>(sights.size() - kFewestLamps));
    if (round == rounds || !solve(sights, weights, fit)) return fit;
  }
}

}  // namespace swaplight
