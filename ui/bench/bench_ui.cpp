#include "ui/bench/bench_ui.h"

#include <sys/resource.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/json.h"
#include "ui/bench/bench_stage.h"
#include "ui/kit/layout_probe.h"

namespace swaplight {
namespace {

using Clock = BenchClock;

constexpr int kWarmUpFrames = 30;
constexpr int kFrames = 300;
constexpr int kMostFramesBehind = 10;

struct Case {
  const char* name;
  int width, height;
  bool oneToOne;
  bool scopes;
  bool filters = false;  ///< seen through a camera look of five
};
constexpr Case kCases[] = {{"1920x1080", 1920, 1080, false, false},
                           {"3840x2160, fitted", 3840, 2160, false, false},
                           {"3840x2160, 1:1", 3840, 2160, true, false},
                           {"1920x1080, with scopes", 1920, 1080, false, true},
                           {"1920x1080, five filters", 1920, 1080, false, false, true}};
constexpr const char* kFilters[] = {"halation", "film-grain", "vignette", "split-tone", "exposure"};
constexpr std::chrono::seconds kFilterPatience{20};

/// Of all threads together, so far.
double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void seeThroughFilters(DocumentEditor& editor) {
  Document next = editor.document();
  next.cameraLook = {"five filters", {}, {}, {}};
  for (const char* filter : kFilters) next.cameraLook.stages.push_back({filter, true, {}, {}});
  editor.edit("Camera look", std::move(next));
}

/// What the studio said last, for a measurement that cannot go on.
std::string lastMessage(StudioWindow& studio) {
  const auto& said = studio.messages().messages();
  return said.empty() ? "it is still being drawn" : said.back().text;
}

/// Until the filtered picture is the one that was asked for last, and on the screen.
void drawFiltered(BenchStage& stage, bool exact) {
  const LookPreview& seen = stage.studio().context().seen;
  const Clock::time_point end = Clock::now() + kFilterPatience;
  bool onScreen = true;  // what was there before the last frame
  while (!seen.follows(LookPreview::Side::A, exact)) {
    if (Clock::now() > end)
      throw InputError("--bench-ui: the camera look is not drawn: {}", lastMessage(stage.studio()));
    onScreen = stage.rest();
  }
  if (!onScreen) stage.drawFrame();
}

Json measure(BenchStage& stage, const Case& which) {
  StudioWindow& studio = stage.studio();
  ViewerContext& context = studio.context();
  stage.openLarge(which.width, which.height);
  context.layout.scopes = which.scopes;
  if (which.filters) seeThroughFilters(context.editor);
  for (int i = 0; i < kWarmUpFrames; ++i) stage.drawFrame();
  if (which.filters) drawFiltered(stage, true);
  if (which.oneToOne) context.actions.run("view.one_to_one");

  const std::string slider = "mixer." + stage.small().capture.lights.front().name + ".stops";
  const auto rect = itemRect(slider);
  if (!rect) throw InputError("--bench-ui: the window is too small to see a light's slider");
  const float y = (rect->y0 + rect->y1) / 2;
  const auto x = [&](int frame) {
    const double turn = 2 * std::numbers::pi * frame / 97;
    return static_cast<float>(std::round(rect->x0 + (0.5 + 0.2 * std::sin(turn)) * (rect->x1 - rect->x0)));
  };
  studio.window().pretendMouse(x(0), y, false);
  stage.drawFrame();
  studio.window().pretendMouse(x(0), y, true);
  for (int i = 0; i < 5; ++i) stage.drawFrame();

  std::vector<double> frames, latencies;
  const double busyBefore = processorSeconds();
  for (int frame = 1; frame <= kFrames; ++frame) {
    const uint64_t before = context.editor.revision();
    const Clock::time_point moved = Clock::now();
    studio.window().pretendMouse(x(frame), y, true);
    for (int behind = 0; behind < kMostFramesBehind; ++behind) {
      const Clock::time_point begin = Clock::now();
      stage.drawFrame();
      frames.push_back(milliseconds(Clock::now() - begin));
      const uint64_t now = context.editor.revision();
      if (now == before) break;  // the slider did not move this time
      if (context.shown.revision != now) continue;
      if (which.filters) drawFiltered(stage, false);
      latencies.push_back(milliseconds(Clock::now() - moved));
      break;
    }
  }
  const double busy = 1000 * (processorSeconds() - busyBefore) / static_cast<double>(frames.size());
  studio.window().pretendMouse(x(0), y, false);
  const Clock::time_point released = Clock::now();
  stage.drawFrame();
  if (latencies.empty()) throw InputError("--bench-ui: the slider did not move");
  Json result{{"case", which.name},
              {"frame_ms", statisticsOf(frames)},
              {"latency_ms", statisticsOf(latencies)},
              {"processor_ms_a_frame", busy}};
  if (which.filters) {
    drawFiltered(stage, true);
    result["exact_after_ms"] = milliseconds(Clock::now() - released);
  }
  return result;
}

}  // namespace

Json benchUi(const StudioOptions& options) {
  BenchStage stage(options);
  Json result = stage.circumstances();
  result["cases"] = Json::array();
  for (const Case& which : kCases) result["cases"].push_back(measure(stage, which));
  result["load_after"] = loadAverage();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  result["peak_memory_mb"] = usage.ru_maxrss / 1024;
  return result;
}

}  // namespace swaplight
