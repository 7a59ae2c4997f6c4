#include "ui/bench/bench_paint.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/base/json.h"
#include "ui/bench/bench_stage.h"
#include "ui/kit/layout_probe.h"
#include "ui/tools/brush_tool.h"

namespace swaplight {
namespace {

constexpr int kPaintWidth = 3840, kPaintHeight = 2160;
constexpr int kStrokes = 200;
constexpr int kStrokeMoves = 16;  // of the mouse, a stroke
constexpr float kLeastStep = 2;   // pixels of the screen: the mouse moves by whole ones
constexpr int kPaintWarmUp = 30;

struct PaintCase {
  const char* name;
  int strokesAnEdit;
};
constexpr PaintCase kPaintCases[] = {{"25 strokes an edit", 25}, {"every stroke an edit", 1}};

/// The light and what the brush does to it, another one every few strokes.
void chooseBrush(ViewerContext& context, int turn) {
  using Mode = BrushState::Mode;
  constexpr Mode kModes[] = {Mode::Add, Mode::Remove, Mode::SetTo};
  BrushState& brush = context.editing.brush;
  brush.mode = kModes[turn % 3];
  brush.energy = turn % 2 == 0 ? EnergyMode::Add : EnergyMode::Redistribute;
  const int lights = static_cast<int>(context.document().rig.lights.size());
  context.view.selectedLight = turn % std::min(lights, 4);
}

/// A frame from the mouse's move to the picture that shows it.
double timedFrame(BenchStage& stage, float x, float y, bool down) {
  const auto begin = BenchClock::now();
  stage.studio().window().pretendMouse(x, y, down);
  stage.drawFrame();
  return milliseconds(BenchClock::now() - begin);
}

/// Returns the time of every frame in which the stroke grew.
void paintStroke(BenchStage& stage, std::mt19937& random, std::vector<double>& dabs) {
  const auto rect = itemRect("viewer.picture");
  if (!rect) throw InputError("--bench-paint: the picture is not visible");
  // Straight, a third of the picture long or less, somewhere inside.
  std::uniform_real_distribution<float> across(rect->x0 + 10, rect->x1 - 10);
  std::uniform_real_distribution<float> down(rect->y0 + 10, rect->y1 - 10);
  float x = across(random), y = down(random);
  float stepX = 0, stepY = 0;
  while (std::max(std::abs(stepX), std::abs(stepY)) < kLeastStep) {
    stepX = (across(random) - x) / (2 * kStrokeMoves);
    stepY = (down(random) - y) / (2 * kStrokeMoves);
  }
  timedFrame(stage, x, y, false);
  ViewerContext& context = stage.studio().context();
  for (int move = 0; move < kStrokeMoves; ++move) {
    const uint64_t before = context.editor.revision();
    const double time = timedFrame(stage, x, y, true);
    if (context.editor.revision() == before || context.shown.revision != context.editor.revision())
      throw InputError("--bench-paint: a dab did not reach the picture within its frame");
    dabs.push_back(time);
    x += stepX;
    y += stepY;
  }
  timedFrame(stage, x, y, false);
}

Json timedSteps(BenchStage& stage, const char* action, int count) {
  std::vector<double> times;
  for (int k = 0; k < count; ++k) {
    const auto begin = BenchClock::now();
    if (!stage.studio().context().actions.run(action))
      throw InputError("--bench-paint: {} had nothing to do after {} steps", action, k);
    stage.drawFrame();
    times.push_back(milliseconds(BenchClock::now() - begin));
  }
  return statisticsOf(times);
}

Json timedSave(BenchStage& stage) {
  SessionController& session = stage.studio().context().session;
  const std::filesystem::path file = stage.home().folder() / "painted.swaplight";
  const auto begin = BenchClock::now();
  session.saveAs(file);
  double worst = milliseconds(BenchClock::now() - begin);
  while (session.saving()) {
    const auto frame = BenchClock::now();
    stage.drawFrame();
    worst = std::max(worst, milliseconds(BenchClock::now() - frame));
  }
  return Json{{"until_saved_ms", milliseconds(BenchClock::now() - begin)},
              {"longest_frame_ms", worst},
              {"file_kb", std::filesystem::file_size(file) / 1024}};
}

Json measure(BenchStage& stage, const PaintCase& which) {
  ViewerContext& context = stage.studio().context();
  std::mt19937 random(7);
  std::vector<double> dabs;
  for (int stroke = 0; stroke < kStrokes; ++stroke) {
    chooseBrush(context, stroke / which.strokesAnEdit);
    paintStroke(stage, random, dabs);
  }
  Json result{{"case", which.name},
              {"edits", context.document().edits.edits.size()},
              {"dab_ms", statisticsOf(dabs)},
              {"history_mb", context.editor.history().bytes() >> 20}};
  result["save"] = timedSave(stage);
  result["undo_ms"] = timedSteps(stage, "edit.undo", kStrokes);
  result["redo_ms"] = timedSteps(stage, "edit.redo", kStrokes);
  context.editor.goTo(0);
  stage.drawFrame();
  return result;
}

}  // namespace

Json benchPaint(const StudioOptions& options) {
  BenchStage stage(options);
  ViewerContext& context = stage.studio().context();
  stage.openLarge(kPaintWidth, kPaintHeight);
  for (int i = 0; i < kPaintWarmUp; ++i) stage.drawFrame();
  context.actions.run("brush.take");
  while (stage.studio().busy()) stage.drawFrame();
  for (int i = 0; i < kPaintWarmUp; ++i) stage.drawFrame();

  Json result = stage.circumstances();
  result["cases"] = Json::array();
  for (const PaintCase& which : kPaintCases) result["cases"].push_back(measure(stage, which));
  result["load_after"] = loadAverage();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  result["peak_memory_mb"] = usage.ru_maxrss / 1024;
  return result;
}

}  // namespace swaplight
