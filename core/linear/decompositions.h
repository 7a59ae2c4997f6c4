#pragma once

#include <Eigen/Core>

namespace swaplight {

// Eigen's decompositions of small matrices of any size, compiled once: each use of one costs the compiler
// seconds.

/// x of a x = b; a is symmetric and positive semidefinite (L D L' with pivoting). b may have several columns.
[[nodiscard]] Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// x of the smallest |a x - b| (Householder QR, columns pivoted).
[[nodiscard]] Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Orthonormal directions that no column of a reaches (Householder QR, columns pivoted). What a column has
/// beyond the others counts where it is more than a 3e-5th of the longest one.
[[nodiscard]] Eigen::MatrixXd orthogonalComplement(const Eigen::MatrixXd& a);

/// Not finite where a is singular (LU, rows pivoted).
[[nodiscard]] Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& a);

/// a = u diag(values) v' (Jacobi, two-sided).
struct SingularValues {
  Eigen::MatrixXd u;       ///< as many columns as there are values
  Eigen::VectorXd values;  ///< min(rows, columns) of them, falling
  Eigen::MatrixXd v;       ///< square
};
[[nodiscard]] SingularValues singularValues(const Eigen::MatrixXd& a);

/// a = vectors diag(values) vectors', of the lower triangle of a symmetric matrix.
struct SymmetricEigen {
  Eigen::VectorXd values;  ///< rising
  Eigen::MatrixXd vectors;
};
[[nodiscard]] SymmetricEigen symmetricEigen(const Eigen::MatrixXd& a);

}  // namespace swaplight
