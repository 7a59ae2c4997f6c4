#pragma once

#include <span>
#include <vector>

namespace swaplight {

/// Nodes with weighted links between them, each link told by both of its ends, and a pull on some of them: in
/// rows, those of node i from first[i] to first[i + 1].
struct LinkedNodes {
  std::vector<int> first{0};
  std::vector<int> neighbour;
  std::vector<float> weight;  ///< of a link, > 0
  std::vector<float> anchor;  ///< of a node towards a value of its own, >= 0

  [[nodiscard]] int count() const { return static_cast<int>(anchor.size()); }
};

/// Finds the x that minimises sum of weight (x_i - x_j)^2 over all links + sum of anchor (x_i - value_i)^2:
/// pictures that are continued smoothly, heat that spreads. Every part that hangs together needs an anchor.
///
/// Conjugate gradients, with a multigrid cycle as preconditioner whose coarser nodes are pairs of pairs of
/// pairs, along the strongest links (Notay, "An aggregation-based algebraic multigrid method", ETNA 37, 2010,
/// with one pairing more than there: a fifth more steps, of a half of the work; K-cycle, one step of Gauss
/// and Seidel before and after). The number of steps hardly grows with the number of nodes, also where
/// weights differ a thousandfold.
class GraphSolver {
 public:
  explicit GraphSolver(LinkedNodes nodes);

  /// `pull`: anchor times value, a node; `x`: where to start, and the solution. Ends where the residual is
  /// `tolerance` of the pull, both RMS, or after 100 steps; returns how many there were.
  int solve(std::span<const float> pull, std::span<float> x, double tolerance = 1e-5) const;

 private:
  struct Level {
    LinkedNodes nodes;
    std::vector<int> middle;     ///< where a node's links to later nodes begin
    std::vector<float> inverse;  ///< one over a node's anchor and weights together
    std::vector<int> coarse;     ///< the node of the next level that a node belongs to; empty at the last

    void product(const std::vector<float>& x, std::vector<float>& out) const;
    void sweepDown(const std::vector<float>& right, std::vector<float>& x) const;
    void sweepUp(const std::vector<float>& right, std::vector<float>& x) const;
  };
  struct Room;  ///< of one level, for solve()

  void cycle(size_t level, const std::vector<float>& right, std::vector<float>& x,
             std::vector<Room>& rooms) const;
  void coarseSolve(size_t level, std::vector<Room>& rooms) const;

  std::vector<Level> m_levels;
};

}  // namespace swaplight
