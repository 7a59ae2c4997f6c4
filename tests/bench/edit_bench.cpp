// Speed and memory of the edit stack: 50 edits at 3840 x 2160 with 4 lights. Prints a table.
//
// What it does not measure: the first touch of memory (every case runs once before), masks that are read from
// files, shadow detection, and drawing the result.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>

#include "core/base/parallel.h"
#include "core/edit/apply/edited_set.h"
#include "tests/support/small_set.h"

using namespace swaplight;  // NOLINT(google-build-using-namespace)

namespace {

constexpr int kWidth = 3840;
constexpr int kHeight = 2160;
constexpr int kLights = 4;
constexpr int kEdits = 50;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double residentMegabytes() {
  std::ifstream status("/proc/self/statm");
  double total = 0;
  double resident = 0;
  status >> total >> resident;
  return resident * 4096 / 1e6;
}

Stroke randomStroke(std::mt19937& random, float radius) {
  std::uniform_real_distribution<float> x(0, kWidth);
  std::uniform_real_distribution<float> y(0, kHeight);
  Stroke stroke;
  stroke.radius = radius;
  stroke.points = {{x(random), y(random), 1}, {x(random), y(random), 1}};
  return stroke;
}

/// Edits as a session has them: every kind, masks small and large, both energy modes. `local`: some look
/// around.
EditStack someEdits(bool lookAround) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(0, 1);
  EditStack stack;
  for (int k = 0; k < kEdits; ++k) {
    Edit edit;
    edit.name = fmt::format("edit {}", k);
    edit.lights = {fmt::format("light{}", k % kLights + 1)};
    edit.energy = k % 2 ? EnergyMode::Add : EnergyMode::Redistribute;
    edit.opacity = .5f + .5f * unit(random);
    const float x = unit(random) * kWidth;
    const float y = unit(random) * kHeight;
    switch (k % 5) {
      case 0:
        edit.operation = CurveOperation{{{0, 0}, {.5f, .3f}, {1, 1}}};
        break;
      case 1:
        edit.operation = GainOperation{.9f, .02f};
        break;
      case 2:
        edit.operation = FillOperation{unit(random)};
        break;
      case 3:
        edit.operation = InvertOperation{};
        break;
      default:
        edit.operation = GainOperation{1.1f, 0};
    }
    if (lookAround && k % 25 == 12) edit.operation = BlurOperation{8};
    switch (k % 4) {
      case 0:
        break;  // everywhere
      case 1:
        edit.mask = {{EllipseShape{x, y, 600, 400, 200}, false}};
        break;
      case 2:
        edit.mask = {{LinearGradientShape{x, y, x + 900, y + 300}, false}};
        break;
      default: {
        Painting painting(kWidth, kHeight);
        for (int s = 0; s < 4; ++s) painting.begin(randomStroke(random, 60));
        edit.mask = {{PaintShape{std::make_shared<const Painting>(painting)}, false}};
      }
    }
    stack.append(std::move(edit));
  }
  return stack;
}

/// Milliseconds from a dab to the updated set: median and 95th percentile over a stroke of many dabs in edit
/// `index`.
std::pair<double, double> dabMilliseconds(EditedSet& edited, EditStack stack, size_t index, float radius) {
  Painting painting(kWidth, kHeight);
  Stroke stroke;
  stroke.radius = radius;
  painting.begin(stroke);
  std::vector<double> times;
  for (int k = 0; k < 60; ++k) {
    const auto step = static_cast<float>(k);
    times.push_back(1e3 * seconds([&] {
                      painting.add({400 + radius / 4 * step, 700 + 3 * step, 1});
                      Edit edit = *stack.edits[index];
                      edit.mask = {{PaintShape{std::make_shared<const Painting>(painting)}, false}};
                      stack.replace(index, std::move(edit));
                      edited.setStack(stack);
                      edited.update();
                    }));
  }
  times.erase(times.begin());  // the mask of the edit became another one
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], times[times.size() * 95 / 100]};
}

void measure(const char* name, const std::shared_ptr<const SolvedSet>& set, const EditStack& stack) {
  EditedSet edited(set);
  edited.update();
  edited.setStack(stack);
  const double first = seconds([&] { edited.update(); });
  fmt::print("{}: full evaluation {:.0f} ms ({:.1f} Mpix/s an edit), resident {:.0f} MB\n", name, first * 1e3,
             kEdits * kWidth * kHeight / first / 1e6, residentMegabytes());
  for (const float radius : {25.f, 50.f, 100.f, 200.f})
    for (const size_t index : {size_t{kEdits - 1}, size_t{0}}) {
      const auto [median, p95] = dabMilliseconds(edited, stack, index, radius);
      fmt::print("  dab of radius {:3.0f} into the {} edit: median {:.2f} ms, 95 % {:.2f} ms\n", radius,
                 index == 0 ? "first" : "last ", median, p95);
      edited.setStack(stack);
      edited.update();
    }
}

}  // namespace

int main() {
  const auto set = std::make_shared<const SolvedSet>(test::smallSet(kLights, kWidth, kHeight));
  fmt::print("{} edits, {} x {}, {} lights, {} threads; the set alone: resident {:.0f} MB\n", kEdits, kWidth,
             kHeight, kLights, threadCount(), residentMegabytes());
  measure("without blur", set, someEdits(false));
  measure("two of them blur", set, someEdits(true));
  return 0;
}
