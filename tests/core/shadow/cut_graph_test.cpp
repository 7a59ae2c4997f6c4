#include "core/shadow/numeric/cut_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace swaplight {
namespace {

/// A grid of random pulls and links, and what it costs to cut it in some way.
struct Grid {
  struct Link {
    int a, b;
    float cost;
  };
  int width, height;
  std::vector<float> pulls;
  std::vector<Link> links;

  Grid(int gridWidth, int gridHeight, unsigned seed) : width(gridWidth), height(gridHeight) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> pull(-1, 1), cost(0, 1);
    for (int i = 0; i < width * height; ++i) pulls.push_back(random() % 4 ? pull(random) : 0);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        if (x > 0) links.push_back({y * width + x, y * width + x - 1, cost(random)});
        if (y > 0) links.push_back({y * width + x, (y - 1) * width + x, cost(random)});
      }
  }
  /// `side`: true for the source's.
  template <typename Side>
  [[nodiscard]] double cost(const Side& side) const {
    double sum = 0;
    for (int i = 0; i < width * height; ++i) {
      const double pull = pulls[static_cast<size_t>(i)];
      sum += side(i) ? std::max(-pull, 0.) : std::max(pull, 0.);
    }
    for (const Link& link : links)
      if (side(link.a) != side(link.b)) sum += static_cast<double>(link.cost);
    return sum;
  }
  [[nodiscard]] CutGraph graph() const {
    CutGraph graph(width * height, static_cast<int>(links.size()));
    for (int i = 0; i < width * height; ++i) graph.setPull(i, pulls[static_cast<size_t>(i)]);
    for (const Link& link : links) graph.link(link.a, link.b, link.cost);
    return graph;
  }
};

TEST(CutGraph, CostsAsLittleAsTheBestOfAllCuts) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Grid grid(4, 3, seed);
    CutGraph graph = grid.graph();
    graph.solve();
    double best = 1e9;
    for (unsigned sides = 0; sides < 1U << 12; ++sides)
      best = std::min(best, grid.cost([&](int i) { return (sides >> i & 1) != 0; }));
    EXPECT_NEAR(grid.cost([&](int i) { return graph.onSourceSide(i); }), best, 1e-5) << seed;
  }
}

TEST(CutGraph, NoVertexOfALargeGridWouldRatherChangeSides) {
  const Grid grid(60, 40, 7);
  CutGraph graph = grid.graph();
  graph.solve();
  const auto side = [&](int i) { return graph.onSourceSide(i); };
  const double found = grid.cost(side);
  for (int changed = 0; changed < grid.width * grid.height; changed += 7)
    EXPECT_GE(grid.cost([&](int i) { return side(i) != (i == changed); }), found - 1e-4) << changed;
}

TEST(CutGraph, WithoutLinksEveryVertexGoesWhereItIsDrawn) {
  CutGraph graph(3, 0);
  graph.setPull(0, 1);
  graph.setPull(1, -1);
  graph.setPull(2, .5F);
  graph.solve();
  EXPECT_TRUE(graph.onSourceSide(0));
  EXPECT_FALSE(graph.onSourceSide(1));
  EXPECT_TRUE(graph.onSourceSide(2));
}

}  // namespace
}  // namespace swaplight
