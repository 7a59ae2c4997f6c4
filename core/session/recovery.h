#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/session/session_file.h"

namespace swaplight {

/// A running studio's place in the recovery folder. Two files: `ID.lock`, locked as long as the process lives
/// and telling what it is opening, and `ID.swaplight`, the session as it was a few seconds ago. Both vanish
/// when the slot ends; a process that died leaves them, unlocked.
class RecoverySlot {
 public:
  /// Creates the folder. Throws InputError where it cannot be written.
  explicit RecoverySlot(const std::filesystem::path& folder);
  RecoverySlot(const RecoverySlot&) = delete;
  RecoverySlot& operator=(const RecoverySlot&) = delete;
  ~RecoverySlot();

  /// Saves what would be lost. `savedAs`: the session file that the person works on, or empty.
  void save(const Session& session, const std::filesystem::path& savedAs);
  /// Nothing would be lost any more.
  void forget();
  /// When the slot ends its files stay, as those of a process that died: the work is offered at the next
  /// start.
  void leave() { m_left = true; }

  /// From here until opened(), dying means that opening this file is what killed us.
  void opening(const std::filesystem::path& file);
  void opened();

  [[nodiscard]] const std::filesystem::path& sessionFile() const { return m_session; }

 private:
  std::filesystem::path m_session;
  std::filesystem::path m_lock;
  int m_handle = -1;
  bool m_left = false;
};

/// What a studio that died has left.
struct Recovered {
  std::filesystem::path lock;
  std::filesystem::path session;  ///< the unsaved work; empty where there was none
  std::filesystem::path savedAs;  ///< the session file it belongs to; empty where it was never saved
  std::filesystem::path opening;  ///< the file that it was opening when it died; empty where it was not
};

/// The remains in the folder, newest first. Locks of living processes are passed over. Never throws for what
/// it finds.
[[nodiscard]] std::vector<Recovered> findRecovered(const std::filesystem::path& folder);
/// Removes the remains: they were taken over, or are not wanted.
void discardRecovered(const Recovered& recovered);

}  // namespace swaplight
