#pragma once

#include <atomic>
#include <functional>
#include <string_view>

#include "core/base/error.h"

namespace swaplight {

/// How long work tells its caller where it stands, and learns that it should stop. A default one is silent
/// and never stops. `update` may be called from several threads; `report` must cope with that.
struct Progress {
  std::function<void(float fraction, std::string_view what)> report;
  const std::atomic<bool>* stop = nullptr;

  /// Throws Stopped when the caller has asked to stop.
  void stopIfAsked() const {
    if (stop && stop->load(std::memory_order_relaxed)) throw Stopped();
  }

  /// fraction in 0..1. Throws Stopped when the caller has asked to stop.
  void update(float fraction, std::string_view what) const {
    stopIfAsked();
    if (report) report(fraction, what);
  }

  /// For a part of the work: its 0..1 is this one's from..to. Valid as long as this one.
  [[nodiscard]] Progress part(float from, float to) const {
    Progress progress;
    progress.stop = stop;
    if (report)
      progress.report = [this, from, to](float fraction, std::string_view what) {
        report(from + fraction * (to - from), what);
      };
    return progress;
  }
};

}  // namespace swaplight
