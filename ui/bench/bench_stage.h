#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/set/solved_set.h"
#include "ui/kit/imgui_session.h"
#include "ui/shell/studio_window.h"

namespace swaplight {

// What measurements of the studio share.

using BenchClock = std::chrono::steady_clock;

[[nodiscard]] double milliseconds(BenchClock::duration time);
/// Median, p95 and worst.
[[nodiscard]] Json statisticsOf(std::vector<double> times);
/// Of the machine: over 1, 5 and 15 minutes.
[[nodiscard]] Json loadAverage();

/// Files of its own, so that nobody's recent files and panels are touched.
class TemporaryHome {
 public:
  TemporaryHome();
  TemporaryHome(const TemporaryHome&) = delete;
  TemporaryHome& operator=(const TemporaryHome&) = delete;
  ~TemporaryHome();
  [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }

 private:
  std::filesystem::path m_folder;
};

/// A studio to be measured: in a window; without a display in memory.
class BenchStage {
 public:
  explicit BenchStage(const StudioOptions& options);

  [[nodiscard]] StudioWindow& studio() { return *m_studio; }
  /// Opens the file's set, or the sample's, made as large as this by mirrored copies side by side.
  void openLarge(int width, int height);
  /// Opens it as it is: lamps are measured as they stood.
  void openAsItIs();
  /// One frame, until all of it is on the screen.
  void drawFrame();
  /// What the studio does while nothing is touched: sleeps until something happens, and draws a frame if one
  /// is wanted. Whether one was drawn.
  bool rest();
  /// Window, engine, lights, load.
  [[nodiscard]] Json circumstances() const;
  [[nodiscard]] const SolvedSet& small() const { return m_small; }
  [[nodiscard]] const TemporaryHome& home() const { return m_home; }

 private:
  TemporaryHome m_home;
  std::filesystem::path m_source;
  SolvedSet m_small;
  ImGuiSession m_imgui;
  std::string m_where;
  std::unique_ptr<Window> m_window;
  std::unique_ptr<StudioWindow> m_studio;
};

}  // namespace swaplight
