#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "core/simd/padding.h"
#include "tests/core/simd/kernels/lane_maths_kernel.h"
#include "tests/support/processor_levels.h"

namespace swaplight::test {
namespace {

/// kMostLanes symmetric positive systems of n equations whose condition is about `condition`.
struct Systems {
  int n;
  std::vector<Eigen::MatrixXd> matrix;
  std::vector<Eigen::VectorXd> side;

  Systems(int size, double condition, unsigned seed) : n(size) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss;
    for (int lane = 0; lane < kMostLanes; ++lane) {
      const Eigen::MatrixXd noise = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return gauss(random); });
      const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(noise).householderQ();
      Eigen::VectorXd spectrum(n);
      for (int i = 0; i < n; ++i) spectrum[i] = std::pow(condition, n > 1 ? -double(i) / (n - 1) : 0);
      // As floats hold it, so that the answers differ by the solving alone.
      const Eigen::MatrixXd exact = q * spectrum.asDiagonal() * q.transpose();
      const Eigen::MatrixXd lower = exact.cast<float>().cast<double>().triangularView<Eigen::Lower>();
      matrix.emplace_back(lower.selfadjointView<Eigen::Lower>());
      side.emplace_back(Eigen::VectorXf::NullaryExpr(n, [&] { return float(gauss(random)); }).cast<double>());
    }
  }

  /// The answers of solveSystems, one a lane; `factor` receives the packed factors.
  [[nodiscard]] std::vector<Eigen::VectorXd> solved(std::vector<float>* factor = nullptr) const {
    std::vector<float> a, x(size_t(n * kMostLanes));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j)
        for (int lane = 0; lane < kMostLanes; ++lane) a.push_back(float(matrix[size_t(lane)](i, j)));
    for (int i = 0; i < n; ++i)
      for (int lane = 0; lane < kMostLanes; ++lane)
        x[size_t(i * kMostLanes + lane)] = float(side[size_t(lane)][i]);
    SWAPLIGHT_KERNEL(solveSystems)(n, a.data(), x.data());
    std::vector<Eigen::VectorXd> answers;
    for (int lane = 0; lane < kMostLanes; ++lane)
      answers.emplace_back(
          Eigen::VectorXd::NullaryExpr(n, [&](auto i) { return x[size_t(i * kMostLanes + lane)]; }));
    if (factor) *factor = a;
    return answers;
  }
};

class LanesCholesky : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, LanesCholesky, testing::Values(1, 2, 3, 5, 8, 13, 19, 35));

TEST_P(LanesCholesky, SolvesAsExactlyAsFloatsCan) {
  const int n = GetParam();
  for (const double condition : {1.0, 30.0, 1000.0}) {
    const Systems systems(n, condition, unsigned(n));
    atEveryLevel([&] {
      const std::vector<Eigen::VectorXd> answers = systems.solved();
      for (size_t lane = 0; lane < kMostLanes; ++lane) {
        const Eigen::VectorXd expected = systems.matrix[lane].ldlt().solve(systems.side[lane]);
        // Higham 2002, theorem 10.4: an error of at most a small multiple of n and the condition.
        EXPECT_LT((answers[lane] - expected).norm(), 4 * n * condition * 0x1p-24 * expected.norm())
            << "lane " << lane << ", condition " << condition;
      }
    });
  }
}

TEST_P(LanesCholesky, TheFactorsDiagonalIsTheInverseOfEigens) {
  const int n = GetParam();
  const Systems systems(n, 10, 99);
  atEveryLevel([&] {
    std::vector<float> factor;
    (void)systems.solved(&factor);
    for (size_t lane = 0; lane < kMostLanes; ++lane) {
      double expected = 0, found = 0;  // log determinants, what the evidence of a fit is made of
      const Eigen::VectorXd pivots = Eigen::LLT<Eigen::MatrixXd>(systems.matrix[lane]).matrixLLT().diagonal();
      for (int i = 0; i < n; ++i) {
        expected += 2 * std::log(pivots[i]);
        found -= std::log(double(factor[size_t(i * (i + 1) / 2 + i) * kMostLanes + lane]));
      }
      EXPECT_NEAR(found, expected, 1e-5 * n);
    }
  });
}

TEST(LanesCholesky, AMatrixThatIsNotPositiveGivesNothingThatIsNotFinite) {
  Systems systems(4, 1, 5);
  for (Eigen::MatrixXd& matrix : systems.matrix) matrix = Eigen::MatrixXd::Zero(4, 4);
  for (Eigen::VectorXd& side : systems.side) side.setZero();
  atEveryLevel([&] {
    for (const Eigen::VectorXd& answer : systems.solved()) EXPECT_TRUE(answer.allFinite());
  });
}

}  // namespace
}  // namespace swaplight::test
