#include "core/linear/decompositions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

Eigen::MatrixXd columns(Eigen::Index rows, Eigen::Index count) {
  Eigen::MatrixXd a(rows, count);
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = 0; i < rows; ++i) a(i, j) = std::sin(double((1 + i * i) * (2 + 3 * j)));
  return a;
}

/// How many directions are free, which have to be orthonormal, and at right angles to all of a.
Eigen::Index freeOf(const Eigen::MatrixXd& a) {
  const Eigen::MatrixXd free = orthogonalComplement(a);
  EXPECT_LT((free.transpose() * free - Eigen::MatrixXd::Identity(free.cols(), free.cols())).norm(), 1e-12);
  EXPECT_LT((a.transpose() * free).norm(), 1e-12 * std::max(a.norm(), 1.0));
  return free.cols();
}

TEST(OrthogonalComplement, HasWhatNoColumnReaches) {
  Eigen::MatrixXd a = columns(12, 7);
  EXPECT_EQ(freeOf(a), 5);
  EXPECT_EQ(freeOf(1e-9 * a), 5) << "in whatever units";
  a.col(6) = a.col(0) - 3 * a.col(2);
  EXPECT_EQ(freeOf(a), 6) << "what others reach already takes up nothing";
  a.col(3).setZero();
  EXPECT_EQ(freeOf(a), 7);
  EXPECT_EQ(freeOf(Eigen::MatrixXd::Zero(6, 5)), 6);
  EXPECT_EQ(freeOf(columns(4, 4)), 0);
}

}  // namespace
}  // namespace swaplight
