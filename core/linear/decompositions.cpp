#include "core/linear/decompositions.h"

#include <Eigen/Dense>

namespace swaplight {

Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.ldlt().solve(b);
}

Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.colPivHouseholderQr().solve(b);
}

Eigen::MatrixXd orthogonalComplement(const Eigen::MatrixXd& a) {
  constexpr double kReached = 3e-5;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
  qr.setThreshold(kReached);
  const Eigen::Index rank = qr.rank();
  Eigen::MatrixXd free = Eigen::MatrixXd::Zero(a.rows(), a.rows() - rank);
  free.bottomRows(a.rows() - rank).setIdentity();
  qr.householderQ().applyThisOnTheLeft(free);
  return free;
}

Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& a) {
  return a.inverse();
}

SingularValues singularValues(const Eigen::MatrixXd& a) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

SymmetricEigen symmetricEigen(const Eigen::MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

}  // namespace swaplight
