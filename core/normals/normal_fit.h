#pragma once

#include <Eigen/Core>
#include <span>

namespace swaplight {

/// What one lamp that shines on a pixel says of it.
struct LampSight {
  Eigen::Vector3d direction;  ///< to the lamp, of length 1
  double light = 0;           ///< of the lamp's level there
};

/// A pixel's normal times its reflectance, and how well it is known.
struct NormalFit {
  Eigen::Vector3d scaled = Eigen::Vector3d::Zero();
  double spread = 0;  ///< of the lamps' directions: smallest eigenvalue of the sum of l l'
  double residual =
      0;  ///< of the reflectance: root of the mean square per degree of freedom; 0 of three lamps

  /// Below, an error of 1 % of the light turns a normal by 3 degrees and more (1 / sqrt(.04) = 5 times as
  /// far): nothing is fitted.
  static constexpr double kLeastSpread = 0.04;
  [[nodiscard]] bool known() const { return spread >= kLeastSpread; }
};

/// The lamps of which a normal and a reflectance can be told: three numbers.
constexpr size_t kFewestLamps = 3;
/// Of the reflectance: lamps that are farther off count little.
constexpr double kOutlier = 0.1;

/// light = l . b by least squares (Woodham, "Photometric method for determining surface orientation from
/// multiple images", 1980, equations 13-16). `rounds`: of reweighting by Geman and McClure's weights, by
/// which a lamp that the others contradict (a highlight, the edge of a shadow) bends the normal little;
/// `residual` still counts it in full, so that such a pixel may be refused. With three lamps nothing is
/// reweighted.
[[nodiscard]] NormalFit fitNormal(std::span<const LampSight> sights, int rounds);

}  // namespace swaplight
