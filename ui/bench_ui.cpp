#include "ui/bench_ui.h"

#include <imgui.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/error.h"
#include "core/session/open_source.h"
#include "core/view/tiled_set.h"
#include "render/screen.h"
#include "ui/imgui_session.h"
#include "ui/layout_probe.h"
#include "ui/studio_window.h"
#include "ui/theme.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWarmUpFrames = 30;
constexpr int kFrames = 300;
constexpr int kMostFramesBehind = 10;

struct Case {
  const char* name;
  int width, height;
  bool oneToOne;
  bool scopes;
};
constexpr Case kCases[] = {{"1920x1080", 1920, 1080, false, false},
                           {"3840x2160, fitted", 3840, 2160, false, false},
                           {"3840x2160, 1:1", 3840, 2160, true, false},
                           {"1920x1080, with scopes", 1920, 1080, false, true}};

double milliseconds(Clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

Json statisticsOf(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double part) {
    return times[std::min(times.size() - 1, static_cast<size_t>(part * static_cast<double>(times.size())))];
  };
  return Json{{"median", at(0.5)}, {"p95", at(0.95)}, {"worst", times.back()}};
}

/// Files of its own, so that nobody's recent files and panels are touched.
class TemporaryHome {
 public:
  TemporaryHome() : m_folder(fs::temp_directory_path() / fmt::format("swaplight-bench-{}", getpid())) {
    for (const char* name : {"XDG_STATE_HOME", "XDG_CONFIG_HOME"}) setenv(name, m_folder.c_str(), 1);
  }
  TemporaryHome(const TemporaryHome&) = delete;
  TemporaryHome& operator=(const TemporaryHome&) = delete;
  ~TemporaryHome() {
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
  }

 private:
  fs::path m_folder;
};

std::unique_ptr<Screen> openScreen(const StudioOptions& options, std::string& where) {
  try {
    where = "window";
    return openWindow("Swaplight", options.width, options.height);
  } catch (const ResourceError&) {
    where = "memory";
    return openOffscreen(options.width, options.height);
  }
}

void drawFrame(StudioWindow& studio) {
  studio.screen().wait(0);
  studio.update();
  studio.screen().requestFrames(1);
  studio.frame();
  finishScreen();
}

/// Of all threads together, so far.
double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Json measure(StudioWindow& studio, const Case& which, const SolvedSet& small, const fs::path& source) {
  StudioContext& context = studio.context();
  OpenSet set;
  set.source = source;
  set.solved = std::make_shared<SolvedSet>(tiledSet(small, which.width, which.height));
  set.pictures = std::make_shared<ViewPictures>(set.solved);
  context.session.openSet(std::move(set));
  context.layout.scopes = which.scopes;
  for (int i = 0; i < kWarmUpFrames; ++i) drawFrame(studio);
  if (which.oneToOne) context.actions.run("view.one_to_one");

  const std::string slider = "mixer." + small.capture.lights.front().name + ".stops";
  const auto rect = itemRect(slider);
  if (!rect) throw InputError("--bench-ui: the window is too small to see a light's slider");
  const float y = (rect->y0 + rect->y1) / 2;
  const auto x = [&](int frame) {
    const double turn = 2 * std::numbers::pi * frame / 97;
    return static_cast<float>(std::round(rect->x0 + (0.5 + 0.2 * std::sin(turn)) * (rect->x1 - rect->x0)));
  };
  studio.screen().pretendMouse(x(0), y, false);
  drawFrame(studio);
  studio.screen().pretendMouse(x(0), y, true);
  for (int i = 0; i < 5; ++i) drawFrame(studio);

  std::vector<double> frames, latencies;
  const double busyBefore = processorSeconds();
  for (int frame = 1; frame <= kFrames; ++frame) {
    const uint64_t before = context.editor.revision();
    const Clock::time_point moved = Clock::now();
    studio.screen().pretendMouse(x(frame), y, true);
    for (int behind = 0; behind < kMostFramesBehind; ++behind) {
      const Clock::time_point begin = Clock::now();
      drawFrame(studio);
      frames.push_back(milliseconds(Clock::now() - begin));
      const uint64_t now = context.editor.revision();
      if (now == before) break;  // the slider did not move this time
      if (context.shown.revision != now) continue;
      latencies.push_back(milliseconds(Clock::now() - moved));
      break;
    }
  }
  const double busy = 1000 * (processorSeconds() - busyBefore) / static_cast<double>(frames.size());
  studio.screen().pretendMouse(x(0), y, false);
  drawFrame(studio);
  if (latencies.empty()) throw InputError("--bench-ui: the slider did not move");
  return Json{{"case", which.name},
              {"frame_ms", statisticsOf(frames)},
              {"latency_ms", statisticsOf(latencies)},
              {"processor_ms_a_frame", busy}};
}

Json loadAverage() {
  double load[3] = {0, 0, 0};
  getloadavg(load, 3);
  return {load[0], load[1], load[2]};
}

}  // namespace

Json benchUi(const StudioOptions& options) {
  const TemporaryHome home;
  const fs::path source =
      options.file.empty() ? options.samplesFolder / "film_set" / "capture.json" : options.file;
  const SolvedSet small = openSource(source, {});
  const ImGuiSession imgui;
  std::string where;
  const std::unique_ptr<Screen> screen = openScreen(options, where);
  applyTheme(options.scale > 0 ? options.scale : screen->contentScale());
  rememberLayout();
  StudioWindow studio(*screen, options);
  Json result{{"window", {screen->width(), screen->height()}},
              {"in", where},
              {"lights", small.lightCount()},
              {"engine", studio.context().pictures.words()},
              {"load_before", loadAverage()},
              {"cases", Json::array()}};
  for (const Case& which : kCases) result["cases"].push_back(measure(studio, which, small, source));
  result["load_after"] = loadAverage();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  result["peak_memory_mb"] = usage.ru_maxrss / 1024;
  return result;
}

}  // namespace swaplight
