#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/solve/estimators/matte_fit.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

/// Which unknown of a fit of colours each is: [3 (lights shot + light) + channel].
struct ColorUnknowns {
  std::vector<int> of;
  int count = 0;
};

/// What pixels that were fitted by the matte model say of small relative errors of the colours: weighted
/// residuals, to first order, in the directions that the pixel's own unknowns (beta, rho) leave free. All
/// threads work on it; sums do not depend on how many they are.
class ColorEquations {
 public:
  /// `baseUncertainty`: relative standard error of the matte model itself.
  ColorEquations(const EstimatorContext& context, const PixelRun& in, const MatteRun& fit,
                 double baseUncertainty, const ColorUnknowns& unknowns);

  /// Those of least squares, `normal` x = `right`.
  struct Sums {
    Eigen::MatrixXd normal;
    Eigen::VectorXd right;
  };
  /// `weights`: a pixel each.
  [[nodiscard]] Sums sums(const std::vector<double>& weights) const;
  /// The squared residual of each pixel once the colours are changed by `step`.
  [[nodiscard]] std::vector<double> squaredLeft(const Eigen::VectorXd& step) const;

  [[nodiscard]] int pixels() const { return m_pixels; }
  /// What turns a pixel's weighted residual into one relative to the signal.
  [[nodiscard]] double scale(int pixel) const { return m_scale[size_t(pixel)]; }
  /// The variance that noise explains of each pixel, relative to the signal squared.
  [[nodiscard]] const std::vector<double>& noise() const { return m_noise; }

 private:
  /// Neighbours in the list of pixels, their rows one after the other.
  struct Block {
    int firstPixel = 0;
    std::vector<Eigen::Index> firstRow;  ///< of each pixel, and one more
    Eigen::MatrixXd slopes;              ///< rows x unknowns
    Eigen::VectorXd residual;

    [[nodiscard]] int pixels() const { return int(firstRow.size()) - 1; }
    [[nodiscard]] Eigen::Index rows(int pixel) const {
      return firstRow[size_t(pixel) + 1] - firstRow[size_t(pixel)];
    }
  };
  void addPixel(const EstimatorContext& context, const PixelRun& in, const MatteRun& fit, int pixel,
                double baseUncertainty, const ColorUnknowns& unknowns, Block& block);

  int m_pixels, m_unknowns;
  std::vector<Block> m_blocks;
  std::vector<double> m_scale, m_noise;
};

}  // namespace swaplight
