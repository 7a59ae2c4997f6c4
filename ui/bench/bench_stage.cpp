#include "ui/bench/bench_stage.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/bench/tiled_set.h"
#include "core/ocio/chosen_config.h"
#include "core/session/open_source.h"
#include "render/surface.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr double kLongestRest = 0.01;  // seconds

std::unique_ptr<Window> openSomeWindow(const StudioOptions& options, std::string& where) {
  try {
    where = "window";
    return openWindow("Swaplight", options.width, options.height);
  } catch (const ResourceError&) {
    where = "memory";
    return openOffscreen(options.width, options.height);
  }
}

}  // namespace

double milliseconds(BenchClock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

Json statisticsOf(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto at = [&](double part) {
    return times[std::min(times.size() - 1, static_cast<size_t>(part * static_cast<double>(times.size())))];
  };
  return Json{{"median", at(0.5)}, {"p95", at(0.95)}, {"worst", times.back()}};
}

Json loadAverage() {
  double load[3] = {0, 0, 0};
  getloadavg(load, 3);
  return {load[0], load[1], load[2]};
}

TemporaryHome::TemporaryHome()
    : m_folder(fs::temp_directory_path() / fmt::format("swaplight-bench-{}", getpid())) {
  for (const char* name : {"XDG_STATE_HOME", "XDG_CONFIG_HOME"}) setenv(name, m_folder.c_str(), 1);
}

TemporaryHome::~TemporaryHome() {
  std::error_code ignored;
  fs::remove_all(m_folder, ignored);
}

BenchStage::BenchStage(const StudioOptions& options)
    : m_source(options.file.empty() ? options.samplesFolder / "film_set" / "capture.json" : options.file),
      m_small(openSource(*programConfig(), m_source, {})),
      m_window(openSomeWindow(options, m_where)) {
  applyTheme(options.scale > 0 ? options.scale : m_window->contentScale());
  rememberLayout();
  m_studio = std::make_unique<StudioWindow>(*m_window, options);
}

void BenchStage::openLarge(int width, int height) {
  OpenSet set;
  set.source = m_source;
  set.original = set.found = std::make_shared<SolvedSet>(tiledSet(m_small, width, height));
  set.live = std::make_shared<LiveSet>(set.original);
  m_studio->context().session.openSet(std::move(set));
}

void BenchStage::openAsItIs() {
  openLarge(m_small.width(), m_small.height());
}

void BenchStage::drawFrame() {
  m_window->wait(0);
  m_studio->update();
  m_window->requestFrames(1);
  m_studio->frame();
  finishDrawing();
}

bool BenchStage::rest() {
  m_window->wait(std::min(m_studio->restSeconds(), kLongestRest));
  m_studio->update();
  if (!m_window->frameWanted()) return false;
  m_studio->frame();
  finishDrawing();
  return true;
}

Json BenchStage::circumstances() const {
  return Json{{"window", {m_window->width(), m_window->height()}},
              {"in", m_where},
              {"lights", m_small.lightCount()},
              {"engine", m_studio->context().renderer.words()},
              {"load_before", loadAverage()}};
}

}  // namespace swaplight
