#include "core/linear/grid_poisson.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/base/parallel.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kCoarsest = 48;  // its longer side at most: solved directly
constexpr int kCycles = 2;
constexpr int kBand = 128;  // rows; what lies next to a band is smoothed with it and with the next one
constexpr int kSteps = 3;   // of smoothing, a cycle
constexpr int kReach = kSteps + 1;
// A step adds so much of the residual. The roots of Chebyshev's polynomial on the part of the spectrum that a
// coarser grid does not see, 1/2 to 2: the steps leave a thirteenth of it.
const std::array<float, kSteps> kPulls = [] {
  std::array<float, kSteps> pulls{};
  for (size_t s = 0; s < pulls.size(); ++s) {
    const double root = std::cos(std::numbers::pi * (2. * static_cast<double>(s) + 1) / (2. * kSteps));
    pulls[s] = static_cast<float>(1 / (1.25 + .75 * root) / 4);
  }
  return pulls;
}();

// A side of a level: cells of size 1, but for the last one, which may be smaller: half of an odd number.
struct Side {
  int cells;
  float last = 1;

  [[nodiscard]] Side halved() const { return {(cells + 1) / 2, (cells % 2 ? last : 1 + last) / 2}; }
  [[nodiscard]] float size(int cell) const { return cell == cells - 1 ? last : 1; }
  /// One over the distance of a cell's centre from that of the one before it.
  [[nodiscard]] float link(int cell) const { return cell == cells - 1 ? 2 / (1 + last) : 1; }
};

struct Level {
  Side across, down;
  std::vector<float> memory;  // empty: another's
  const float* wanted;
  float* values;

  [[nodiscard]] int width() const { return across.cells; }
  [[nodiscard]] int height() const { return down.cells; }
  [[nodiscard]] size_t at(int y) const { return static_cast<size_t>(y) * static_cast<size_t>(width()); }
};

// The last rows of a step, each with its first and last pixel repeated on its sides.
class Rows {
 public:
  explicit Rows(int width) : m_width(width), m_values(static_cast<size_t>(width + 2) * 4) {}
  float* at(int y) {
    return m_values.data() + static_cast<size_t>(y & 3) * static_cast<size_t>(m_width + 2) + 1;
  }
  void closeSides(int y) {
    float* row = at(y);
    row[-1] = row[0];
    row[m_width] = row[m_width - 1];
  }

 private:
  int m_width;
  std::vector<float> m_values;
};

// How much flows between neighbours in a row and to the rows beside it, times their difference.
struct Flows {
  float toSides, toUp, toDown;
};

// Out of a cell of size 1.
[[gnu::always_inline]] inline float flowAt(int x, const float* up, const float* here, const float* down,
                                           const Flows& flows) {
  return flows.toSides * (2 * here[x] - here[x - 1] - here[x + 1]) +
         (flows.toUp * (here[x] - up[x]) + flows.toDown * (here[x] - down[x]));
}

// Of cells of size 1: the residual, what is wanted less what flows out of a cell, plus `keep` times what is
// there.
SWAPLIGHT_SIMD(void, residualInside,
               (const float* wanted, const float* up, const float* here, const float* down, Flows flows,
                float keep, int count, float* __restrict out),
               (wanted, up, here, down, flows, keep, count, out)) {
  for (int x = 0; x < count; ++x) {
    out[x] = wanted[x] - flowAt(x, up, here, down, flows) + keep * out[x];
  }
}

SWAPLIGHT_SIMD(void, smoothInside,
               (const float* wanted, const float* up, const float* here, const float* down, Flows flows,
                float pull, int count, float* __restrict out),
               (wanted, up, here, down, flows, pull, count, out)) {
  for (int x = 0; x < count; ++x) {
    out[x] = here[x] + pull * (wanted[x] - flowAt(x, up, here, down, flows));
  }
}

SWAPLIGHT_SIMD(void, mixRows, (const float* near, const float* far, int count, float* __restrict out),
               (near, far, count, out)) {
  for (int x = 0; x < count; ++x) out[x] = .75F * near[x] + .25F * far[x];
}

// Two pixels from each of a row with one more on both sides.
SWAPLIGHT_SIMD(void, addTwice, (const float* row, int count, float* __restrict out), (row, count, out)) {
  for (int x = 0; x < count; ++x) {
    out[2 * x] += .75F * row[x] + .25F * row[x - 1];
    out[2 * x + 1] += .75F * row[x] + .25F * row[x + 1];
  }
}

// A row of a level, between two others; the last two of its cells may be of another size.
class RowResidual {
 public:
  RowResidual(const Level& level, Rows& rows, int y)
      : m_across(level.across),
        m_wanted(level.wanted + level.at(y)),
        m_up(rows.at(std::max(y - 1, 0))),
        m_here(rows.at(y)),
        m_down(rows.at(std::min(y + 1, level.height() - 1))),
        m_flows{level.down.size(y), level.down.link(y), level.down.link(y + 1)},
        m_scale(scaleOf(level.across) * scaleOf(level.down)) {}

  /// out = residual + keep * out.
  void write(float keep, float* out) const {
    residualInside(m_wanted, m_up, m_here, m_down, m_flows, keep, inside(), out);
    for (int x = inside(); x < m_across.cells; ++x) out[x] = atSide(x) + keep * out[x];
  }
  void smooth(float pull, float* out) const {
    pull *= m_scale;
    smoothInside(m_wanted, m_up, m_here, m_down, m_flows, pull, inside(), out);
    for (int x = inside(); x < m_across.cells; ++x) out[x] = m_here[x] + pull * atSide(x);
  }

 private:
  // Nothing flows across a single column or row: half as much to level, whatever its size.
  static float scaleOf(const Side& side) { return side.cells == 1 ? 2 / side.last : 1; }
  [[nodiscard]] int inside() const { return std::max(m_across.cells - 2, 0); }
  [[nodiscard]] float atSide(int x) const {
    const float across =
        m_across.link(x) * (m_here[x] - m_here[x - 1]) + m_across.link(x + 1) * (m_here[x] - m_here[x + 1]);
    const float down = m_flows.toUp * (m_here[x] - m_up[x]) + m_flows.toDown * (m_here[x] - m_down[x]);
    return m_wanted[x] - (m_flows.toSides * across + m_across.size(x) * down);
  }

  Side m_across;
  const float* m_wanted;
  const float* m_up;
  const float* m_here;
  const float* m_down;
  Flows m_flows;
  float m_scale;  // of a step, to what it is of cells with four neighbours
};

// The sums of neighbouring pairs; the last may be alone.
void sumPairs(const std::vector<float>& row, float* out) {
  const size_t pairs = row.size() / 2;
  for (size_t x = 0; x < pairs; ++x) out[x] = row[2 * x] + row[2 * x + 1];
  if (row.size() % 2) out[pairs] = row.back();
}

// Adds a coarser level's values at row y, interpolated: its cells' centres lie between four of this one's, or
// on the last one of an odd number. `between` has room for a coarser row and two more.
void addCoarser(const Level& coarser, const Level& level, int y, std::vector<float>& between, float* row) {
  const int half = coarser.width(), width = level.width(), last = level.height() - 1;
  const bool onCentre = y == last && y % 2 == 0;
  const int other = onCentre ? y / 2 : std::clamp(y / 2 + (y % 2 ? 1 : -1), 0, coarser.height() - 1);
  const float* near = coarser.values + coarser.at(y / 2);
  const float* far = coarser.values + coarser.at(other);
  float* mixed = between.data() + 1;
  mixRows(near, far, half, mixed);
  mixed[-1] = mixed[0];
  mixed[half] = mixed[half - 1];
  addTwice(mixed, width / 2, row);
  if (width % 2) row[width - 1] += mixed[half - 1];
}

// The differences along a side, in waves in which each cell's is a multiple of its value times its size.
struct Waves {
  Eigen::MatrixXd shapes;  // in columns
  Eigen::VectorXd multiples;

  explicit Waves(const Side& side) {
    Eigen::MatrixXd flows = Eigen::MatrixXd::Zero(side.cells, side.cells);
    Eigen::MatrixXd sizes = flows;
    for (int i = 0; i < side.cells; ++i) {
      sizes(i, i) = side.size(i);
      if (i == 0) continue;
      const double link = side.link(i);
      flows(i, i) += link;
      flows(i - 1, i - 1) += link;
      flows(i, i - 1) -= link;
      flows(i - 1, i) -= link;
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(flows, sizes);
    shapes = solver.eigenvectors();
    multiples = solver.eigenvalues();
  }
};

class Multigrid {
 public:
  Multigrid(int width, int height, const float* wanted, float* values)
      : m_levels(levels({width}, {height}, wanted, values)),
        m_across(m_levels.back().across),
        m_down(m_levels.back().down) {}

  void solve() {
    const size_t last = m_levels.size() - 1;
    for (size_t level = 0; level < last; ++level) handDownWanted(level);
    solveCoarsest();
    for (size_t level = last; level-- > 0;) {
      smooth(level, {.fromZero = true, .addCoarser = true, .handDown = true});
      for (int c = 1; c <= kCycles; ++c) {
        cycle(level + 1);
        smooth(level, {.addCoarser = true, .handDown = c < kCycles});
      }
    }
  }

 private:
  static std::vector<Level> levels(Side across, Side down, const float* wanted, float* values) {
    std::vector<Level> made;
    made.push_back({across, down, {}, wanted, values});
    while (std::max(across.cells, down.cells) > kCoarsest) {
      across = across.halved();
      down = down.halved();
      const size_t count = static_cast<size_t>(across.cells) * static_cast<size_t>(down.cells);
      Level level{across, down, std::vector<float>(2 * count), nullptr, nullptr};
      level.wanted = level.memory.data();
      level.values = level.memory.data() + count;
      made.push_back(std::move(level));
    }
    return made;
  }

  struct Pass {
    bool fromZero = false;
    bool addCoarser = false;  // what the coarser level has found, before the steps
    bool handDown = false;    // the residual, after them
  };

  // What takes off the residual that was handed down to a level.
  void cycle(size_t level) {
    if (level + 1 == m_levels.size()) return solveCoarsest();
    smooth(level, {.fromZero = true, .handDown = true});
    cycle(level + 1);
    smooth(level, {.addCoarser = true});
  }

  [[nodiscard]] float* wantedRow(size_t level, int y) {
    return m_levels[level].memory.data() + m_levels[level].at(y);
  }

  void handDownWanted(size_t number) {
    const Level& fine = m_levels[number];
    parallelRows(m_levels[number + 1].height(), kBand, [&](int begin, int end) {
      std::vector<float> sum(static_cast<size_t>(fine.width()));
      for (int y = begin; y < end; ++y) {
        const float* row = fine.wanted + fine.at(2 * y);
        const float* next = 2 * y + 1 < fine.height() ? row + fine.width() : nullptr;
        for (size_t x = 0; x < sum.size(); ++x) sum[x] = next ? row[x] + next[x] : row[x];
        sumPairs(sum, wantedRow(number + 1, y));
      }
    });
  }

  void smooth(size_t number, Pass pass);
  void solveCoarsest();

  std::vector<Level> m_levels;  // each half as wide and high as the one before
  Waves m_across, m_down;       // of the coarsest
};

// Row by row: as soon as a step has three rows, the next step makes one of them. The values are overwritten
// as the last step goes along; what other bands see of a band is kept aside before.
void Multigrid::smooth(size_t number, Pass pass) {
  Level& level = m_levels[number];
  const int width = level.width(), height = level.height();
  const int bands = (height + kBand - 1) / kBand;
  std::vector<float> seams(pass.fromZero ? 0 : static_cast<size_t>(bands * 2 * kReach * width));
  // Rows kReach before a band's begin to kReach after it.
  const auto seam = [&](int band, int y) {
    return seams.data() +
           static_cast<size_t>(band * 2 * kReach + y - (band * kBand - kReach)) * static_cast<size_t>(width);
  };
  if (!pass.fromZero)
    for (int band = 1; band < bands; ++band)
      for (int y = band * kBand - kReach; y < std::min(band * kBand + kReach, height); ++y)
        std::copy_n(level.values + level.at(y), width, seam(band, y));

  parallelEach(bands, [&](int band) {
    const int begin = band * kBand, end = std::min(begin + kBand, height);
    std::vector<Rows> steps(kSteps + 1, Rows(width));
    std::vector<float> between(static_cast<size_t>(width) / 2 + 3), left(static_cast<size_t>(width));
    const auto inReach = [&](int y, int reach) {
      return y >= std::max(begin - reach, 0) && y < std::min(end + reach, height);
    };
    for (int y = begin - kReach; y < end + kReach; ++y) {
      if (inReach(y, kReach)) {
        float* row = steps[0].at(y);
        if (pass.fromZero)
          std::fill_n(row, width, 0.F);
        else
          std::copy_n(y < begin  ? seam(band, y)
                      : y >= end ? seam(band + 1, y)
                                 : level.values + level.at(y),
                      width, row);
        if (pass.addCoarser) addCoarser(m_levels[number + 1], level, y, between, row);
        steps[0].closeSides(y);
      }
      for (int s = 1; s <= kSteps; ++s) {
        const int at = y - s;
        if (!inReach(at, kReach - s)) continue;
        Rows& made = steps[static_cast<size_t>(s)];
        const RowResidual residual(level, steps[static_cast<size_t>(s - 1)], at);
        float* out = made.at(at);
        residual.smooth(kPulls[static_cast<size_t>(s - 1)], out);
        made.closeSides(at);
        if (s == kSteps && inReach(at, 0)) std::copy_n(out, width, level.values + level.at(at));
      }
      const int at = y - kReach;
      if (!pass.handDown || !inReach(at, 0)) continue;
      const RowResidual residual(level, steps[kSteps], at);
      residual.write(at % 2 ? 1.F : 0.F, left.data());
      if (at % 2 || at == height - 1) sumPairs(left, wantedRow(number + 1, at / 2));
    }
  });
}

void Multigrid::solveCoarsest() {
  Level& level = m_levels.back();
  using Grid = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Grid> wanted(level.wanted, level.height(), level.width());
  Eigen::MatrixXd waves = m_down.shapes.transpose() * wanted.cast<double>() * m_across.shapes;
  for (int y = 0; y < level.height(); ++y)
    for (int x = 0; x < level.width(); ++x)
      waves(y, x) = x + y > 0 ? waves(y, x) / (m_across.multiples(x) + m_down.multiples(y)) : 0;
  Eigen::Map<Grid>(level.values, level.height(), level.width()) =
      (m_down.shapes * waves * m_across.shapes.transpose()).cast<float>();
}

}  // namespace

void solvePoisson(int width, int height, std::span<const float> wanted, std::span<float> solution) {
  if (wanted.empty()) return;
  Multigrid(width, height, wanted.data(), solution.data()).solve();
  const auto row = [&](int y) {
    return solution.subspan(static_cast<size_t>(y) * static_cast<size_t>(width), static_cast<size_t>(width));
  };
  std::vector<double> sums(static_cast<size_t>(height));
  parallelRows(height, kBand, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      sums[static_cast<size_t>(y)] = std::accumulate(row(y).begin(), row(y).end(), 0.);
  });
  const double sum = std::accumulate(sums.begin(), sums.end(), 0.);
  const auto mean = static_cast<float>(sum / static_cast<double>(solution.size()));
  parallelRows(height, kBand, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (float& value : row(y)) value -= mean;
  });
}

}  // namespace swaplight
