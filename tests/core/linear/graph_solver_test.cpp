#include "core/linear/graph_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

using Weight = std::function<float(int x, int y, int x2, int y2)>;

/// Neighbours of a grid, with an anchor of 1 at its left border.
LinkedNodes grid(int width, int height, const Weight& weight) {
  LinkedNodes nodes;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      for (const auto& [dx, dy] : {std::pair{0, -1}, {-1, 0}, {1, 0}, {0, 1}}) {
        const int x2 = x + dx, y2 = y + dy;
        if (x2 < 0 || y2 < 0 || x2 >= width || y2 >= height) continue;
        nodes.neighbour.push_back(y2 * width + x2);
        nodes.weight.push_back(weight(std::min(x, x2), std::min(y, y2), std::max(x, x2), std::max(y, y2)));
      }
      nodes.anchor.push_back(x == 0 ? 1.F : 0.F);
      nodes.first.push_back(int(nodes.neighbour.size()));
    }
  return nodes;
}

float even(int, int, int, int) {
  return 1;
}

/// From a thousandth to 1, anyhow.
float motley(int x, int y, int x2, int y2) {
  std::mt19937 random(unsigned(((x * 613 + y) * 613 + x2) * 613 + y2));
  return std::pow(10.F, -3 * std::uniform_real_distribution<float>()(random));
}

/// Rooms of 16 x 16 whose walls let a thousandth through.
float rooms(int x, int y, int x2, int y2) {
  return x / 16 == x2 / 16 && y / 16 == y2 / 16 ? 1.F : .001F;
}

TEST(GraphSolver, FindsWhatADenseSolverFinds) {
  const LinkedNodes nodes = grid(19, 14, motley);
  const auto count = size_t(nodes.count());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(Eigen::Index(count), Eigen::Index(count));
  Eigen::MatrixXd right(Eigen::Index(count), 1);
  std::vector<float> pull(count);
  for (size_t i = 0; i < count; ++i) {
    const auto row = Eigen::Index(i);
    matrix(row, row) += nodes.anchor[i];
    for (int k = nodes.first[i]; k < nodes.first[i + 1]; ++k) {
      matrix(row, row) += nodes.weight[size_t(k)];
      matrix(row, nodes.neighbour[size_t(k)]) -= nodes.weight[size_t(k)];
    }
    right(row, 0) = pull[i] = std::sin(float(i));
  }
  const Eigen::MatrixXd expected = solveSymmetric(matrix, right);
  std::vector<float> x(count, 0);
  EXPECT_LE(GraphSolver(nodes).solve(pull, x, 1e-6), 40);
  for (size_t i = 0; i < count; ++i)
    EXPECT_NEAR(x[i], expected(Eigen::Index(i), 0), 1e-3 * expected.cwiseAbs().maxCoeff()) << i;
}

TEST(GraphSolver, ContinuesAnAnchorsValueEverywhere) {
  for (const Weight& weight : {Weight(even), Weight(motley), Weight(rooms)}) {
    const LinkedNodes nodes = grid(150, 90, weight);
    std::vector<float> pull(nodes.anchor), x(pull.size(), 0);
    for (float& each : pull) each *= 3;
    GraphSolver(nodes).solve(pull, x, 1e-7);
    for (const float each : x) ASSERT_NEAR(each, 3, .03);
  }
}

TEST(GraphSolver, NeedsHardlyMoreStepsForMoreNodes) {
  for (const Weight& weight : {Weight(even), Weight(motley), Weight(rooms)}) {
    int steps[2];
    for (int i = 0; i < 2; ++i) {
      const int size = i ? 320 : 80;
      const LinkedNodes nodes = grid(size, size, weight);
      std::vector<float> pull(nodes.anchor.size(), 0), x(pull.size(), 0);
      for (size_t p = 0; p < pull.size(); ++p) pull[p] = float(p % 7) - 3;
      steps[i] = GraphSolver(nodes).solve(pull, x, 1e-4);
    }
    EXPECT_LE(steps[0], 40);
    EXPECT_LE(steps[1], 2 * steps[0] + 10) << "of " << steps[0];
  }
}

TEST(GraphSolver, LeavesASolutionAsItIs) {
  const LinkedNodes nodes = grid(40, 40, even);
  std::vector<float> pull(nodes.anchor), x(pull.size(), 1);
  EXPECT_EQ(GraphSolver(nodes).solve(pull, x), 0);
  for (const float each : x) EXPECT_EQ(each, 1);
}

}  // namespace
}  // namespace swaplight
