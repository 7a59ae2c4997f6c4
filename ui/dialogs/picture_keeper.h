#pragma once

#include <chrono>
#include <filesystem>
#include <functional>

#include "core/session/kept_pictures.h"
#include "ui/control/lights_context.h"
#include "ui/jobs/job.h"

namespace swaplight {

/// Keeps a small picture of what is open, for the page that the studio starts with, whenever nothing has
/// changed for a moment: it is there however the studio ends.
class PictureKeeper {
 public:
  PictureKeeper(std::filesystem::path folder, std::function<void()> wake)
      : m_kept(std::move(folder)), m_wake(std::move(wake)) {}

  /// To be called often.
  void update(const LightsContext& studio);
  [[nodiscard]] const KeptPictures& pictures() const { return m_kept; }
  /// Counts up with every picture that was written.
  [[nodiscard]] int written() const { return m_count; }

 private:
  /// What a picture is of.
  struct Shown {
    std::filesystem::path file;
    uint64_t set = 0, document = 0;
    bool operator==(const Shown&) const = default;
  };

  KeptPictures m_kept;
  std::function<void()> m_wake;
  Shown m_shown, m_written;
  std::chrono::steady_clock::time_point m_since;
  Job<bool> m_writing;
  int m_count = 0;
};

}  // namespace swaplight
