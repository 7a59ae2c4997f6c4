#include "core/linear/graph_solver.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/check.h"

namespace swaplight {
namespace {

constexpr int kFewNodes = 64;        // are solved by sweeps alone
constexpr int kSweeps = 20;          // there, each way
constexpr float kStrong = .25F;      // of a node's strongest link: weaker ones make no pairs
constexpr int kPairings = 3;         // one after another: eight nodes or so become one
constexpr double kStalled = .75;     // of the nodes left by them: no coarser level is worth its work
constexpr double kGoodEnough = .25;  // of the residual after one inner step: no second one
constexpr int kMostSteps = 100;
constexpr int kGridLinks = 4;  // of a pixel

double dot(const std::vector<float>& a, const std::vector<float>& b) {
  const auto as = [](const std::vector<float>& x) {
    return Eigen::Map<const Eigen::VectorXf>(x.data(), Eigen::Index(x.size())).cast<double>();
  };
  return as(a).dot(as(b));
}

void add(std::vector<float>& to, double times, const std::vector<float>& x) {
  for (size_t i = 0; i < to.size(); ++i) to[i] += float(times) * x[i];
}

std::vector<float> diagonalOf(const LinkedNodes& nodes) {
  std::vector<float> diagonal(nodes.anchor);
  for (int i = 0; i < nodes.count(); ++i)
    for (int k = nodes.first[size_t(i)]; k < nodes.first[size_t(i) + 1]; ++k)
      diagonal[size_t(i)] += nodes.weight[size_t(k)];
  return diagonal;
}

/// What the links from `begin` to `end` give a node.
float given(const LinkedNodes& nodes, int begin, int end, const std::vector<float>& x) {
  const auto one = [&](int k) { return nodes.weight[size_t(k)] * x[size_t(nodes.neighbour[size_t(k)])]; };
  if (end - begin == kGridLinks)  // nearly all: none waits for the one before
    return (one(begin) + one(begin + 1)) + (one(begin + 2) + one(begin + 3));
  float sum = 0;
  for (int k = begin; k < end; ++k) sum += one(k);
  return sum;
}

/// Sorts each node's links: first those to nodes before it. Returns where the others begin.
std::vector<int> earlierFirst(LinkedNodes& nodes) {
  std::vector<int> middle;
  middle.reserve(nodes.anchor.size());
  for (int i = 0; i < nodes.count(); ++i) {
    int next = nodes.first[size_t(i)];
    for (int k = next; k < nodes.first[size_t(i) + 1]; ++k)
      if (nodes.neighbour[size_t(k)] < i) {
        std::swap(nodes.neighbour[size_t(k)], nodes.neighbour[size_t(next)]);
        std::swap(nodes.weight[size_t(k)], nodes.weight[size_t(next++)]);
      }
    middle.push_back(next);
  }
  return middle;
}

/// Each node with the free neighbour that it is linked to most strongly, or alone; returns how many pairs.
int pairUp(const LinkedNodes& nodes, std::vector<int>& pairOf) {
  pairOf.assign(size_t(nodes.count()), -1);
  int pairs = 0;
  for (int i = 0; i < nodes.count(); ++i) {
    if (pairOf[size_t(i)] >= 0) continue;
    float strongest = 0, best = 0;
    int partner = -1;
    for (int k = nodes.first[size_t(i)]; k < nodes.first[size_t(i) + 1]; ++k) {
      const float weight = nodes.weight[size_t(k)];
      strongest = std::max(strongest, weight);
      if (weight > best && pairOf[size_t(nodes.neighbour[size_t(k)])] < 0)
        best = weight, partner = nodes.neighbour[size_t(k)];
    }
    pairOf[size_t(i)] = pairs;
    if (partner >= 0 && best >= kStrong * strongest) pairOf[size_t(partner)] = pairs;
    ++pairs;
  }
  return pairs;
}

/// The nodes put together: links between two groups are added up, those within one are gone.
LinkedNodes together(const LinkedNodes& nodes, const std::vector<int>& groupOf, int groups) {
  std::vector<int> start(size_t(groups) + 1, 0), member(groupOf.size());
  for (const int group : groupOf) ++start[size_t(group) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<int> next(start.begin(), start.end() - 1);
  for (size_t i = 0; i < groupOf.size(); ++i) member[size_t(next[size_t(groupOf[i])]++)] = int(i);

  LinkedNodes coarse;
  coarse.anchor.assign(size_t(groups), 0);
  coarse.first.reserve(size_t(groups) + 1);
  std::vector<int> place(size_t(groups), -1);  // of a link to a group among those of the current one
  for (int group = 0; group < groups; ++group) {
    const int begin = coarse.first.back();
    for (int m = start[size_t(group)]; m < start[size_t(group) + 1]; ++m) {
      const auto i = size_t(member[size_t(m)]);
      coarse.anchor[size_t(group)] += nodes.anchor[i];
      for (int k = nodes.first[i]; k < nodes.first[i + 1]; ++k) {
        const int other = groupOf[size_t(nodes.neighbour[size_t(k)])];
        if (other == group) continue;
        int& at = place[size_t(other)];
        if (at < begin) {
          at = int(coarse.neighbour.size());
          coarse.neighbour.push_back(other);
          coarse.weight.push_back(0);
        }
        coarse.weight[size_t(at)] += nodes.weight[size_t(k)];
      }
    }
    coarse.first.push_back(int(coarse.neighbour.size()));
  }
  return coarse;
}

}  // namespace

void GraphSolver::Level::product(const std::vector<float>& x, std::vector<float>& out) const {
  for (size_t i = 0; i < x.size(); ++i) {
    float sum = nodes.anchor[i] * x[i];  // by differences: neighbours are nearly alike
    for (int k = nodes.first[i]; k < nodes.first[i + 1]; ++k)
      sum += nodes.weight[size_t(k)] * (x[i] - x[size_t(nodes.neighbour[size_t(k)])]);
    out[i] = sum;
  }
}

void GraphSolver::Level::sweepUp(const std::vector<float>& right, std::vector<float>& x) const {
  for (size_t i = x.size(); i-- > 0;)
    x[i] = (right[i] + given(nodes, nodes.first[i], nodes.first[i + 1], x)) * inverse[i];
}

void GraphSolver::Level::sweepDown(const std::vector<float>& right, std::vector<float>& x) const {
  for (size_t i = 0; i < x.size(); ++i)
    x[i] = (right[i] + given(nodes, nodes.first[i], nodes.first[i + 1], x)) * inverse[i];
}

/// Vectors of one level's length.
struct GraphSolver::Room {
  std::vector<float> right, x, left, direction, product, secondDirection, secondProduct;
  explicit Room(size_t size)
      : right(size),
        x(size),
        left(size),
        direction(size),
        product(size),
        secondDirection(size),
        secondProduct(size) {}
};

GraphSolver::GraphSolver(LinkedNodes nodes) {
  SWAPLIGHT_CHECK(nodes.first.size() == nodes.anchor.size() + 1);
  for (;;) {
    std::vector<float> inverse = diagonalOf(nodes);
    for (float& each : inverse) each = each > 0 ? 1 / each : 0;
    std::vector<int> middle = earlierFirst(nodes);
    m_levels.push_back({std::move(nodes), std::move(middle), std::move(inverse), {}});
    Level& level = m_levels.back();
    if (level.nodes.count() <= kFewNodes) return;
    level.coarse.resize(size_t(level.nodes.count()));
    std::iota(level.coarse.begin(), level.coarse.end(), 0);
    LinkedNodes grouped;
    for (int pairing = 0; pairing < kPairings; ++pairing) {
      const LinkedNodes& from = pairing ? grouped : level.nodes;
      std::vector<int> groupOf;
      const int groups = pairUp(from, groupOf);
      grouped = together(from, groupOf, groups);
      for (int& group : level.coarse) group = groupOf[size_t(group)];
    }
    if (grouped.count() > kStalled * level.nodes.count()) {
      level.coarse.clear();
      return;
    }
    nodes = std::move(grouped);
  }
}

/// An approximate solution for `right`, symmetric in it.
void GraphSolver::cycle(size_t index, const std::vector<float>& right, std::vector<float>& x,
                        std::vector<Room>& rooms) const {
  const Level& level = m_levels[index];
  const LinkedNodes& nodes = level.nodes;
  if (level.coarse.empty()) {
    std::fill(x.begin(), x.end(), 0.F);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      level.sweepDown(right, x);
      level.sweepUp(right, x);
    }
    return;
  }
  // A sweep down from nothing: no node after this one counts yet, and theirs is what it leaves.
  for (size_t i = 0; i < x.size(); ++i)
    x[i] = (right[i] + given(nodes, nodes.first[i], level.middle[i], x)) * level.inverse[i];
  Room& below = rooms[index + 1];
  std::fill(below.right.begin(), below.right.end(), 0.F);
  for (size_t i = 0; i < x.size(); ++i)
    below.right[size_t(level.coarse[i])] += given(nodes, level.middle[i], nodes.first[i + 1], x);
  coarseSolve(index + 1, rooms);
  for (size_t i = 0; i < x.size(); ++i) x[i] += below.x[size_t(level.coarse[i])];
  level.sweepUp(right, x);
}

/// The room's `x` for its `right` by one or two steps of conjugate gradients (Notay's K-cycle).
void GraphSolver::coarseSolve(size_t index, std::vector<Room>& rooms) const {
  const Level& level = m_levels[index];
  Room& room = rooms[index];
  if (level.coarse.empty()) return cycle(index, room.right, room.x, rooms);
  cycle(index, room.right, room.direction, rooms);
  level.product(room.direction, room.product);
  const double first = dot(room.direction, room.product), along = dot(room.direction, room.right);
  const double before = dot(room.right, room.right);
  std::fill(room.x.begin(), room.x.end(), 0.F);
  if (!(first > 0)) return;
  room.left = room.right;
  add(room.left, -along / first, room.product);
  if (dot(room.left, room.left) <= kGoodEnough * kGoodEnough * before) {
    add(room.x, along / first, room.direction);
    return;
  }
  cycle(index, room.left, room.secondDirection, rooms);
  level.product(room.secondDirection, room.secondProduct);
  const double mixed = dot(room.secondDirection, room.product);
  const double second = dot(room.secondDirection, room.secondProduct) - mixed * mixed / first;
  const double along2 = second > 0 ? dot(room.secondDirection, room.left) / second : 0;
  add(room.x, along / first - mixed * along2 / first, room.direction);
  add(room.x, along2, room.secondDirection);
}

int GraphSolver::solve(std::span<const float> pull, std::span<float> x, double tolerance) const {
  const Level& level = m_levels.front();
  const auto size = size_t(level.nodes.count());
  SWAPLIGHT_CHECK(pull.size() == size && x.size() == size);
  std::vector<Room> rooms;
  for (const Level& each : m_levels) rooms.emplace_back(size_t(each.nodes.count()));
  std::vector<float> solution(x.begin(), x.end()), left(size), step(size), image(size), towards(size);
  level.product(solution, left);
  double power = 0;
  for (size_t i = 0; i < size; ++i) {
    left[i] = pull[i] - left[i];
    power += double(pull[i]) * pull[i];
  }
  if (power == 0) {  // nothing pulls: all are 0
    std::fill(x.begin(), x.end(), 0.F);
    return 0;
  }
  const double enough = tolerance * tolerance * power;
  double scale = 0;  // of the last step
  int steps = 0;
  for (; steps < kMostSteps && dot(left, left) > enough; ++steps) {
    cycle(0, left, towards, rooms);
    // Flexible: the cycle is not quite the same each time.
    const double back = steps ? -dot(towards, image) / scale : 0;
    for (size_t i = 0; i < size; ++i) step[i] = towards[i] + float(back) * step[i];
    level.product(step, image);
    scale = dot(step, image);
    if (!(scale > 0)) break;
    const double along = dot(step, left) / scale;
    add(solution, along, step);
    add(left, -along, image);
  }
  std::copy(solution.begin(), solution.end(), x.begin());
  return steps;
}

}  // namespace swaplight
