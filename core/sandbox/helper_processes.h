#pragma once

#include <sys/types.h>

#include <functional>

#include "core/sandbox/channel.h"
#include "core/sandbox/confinement.h"

namespace swaplight {

/// Processes that do one dangerous thing each, and of which each is confined (confinement.h). They are forks
/// of one that was itself forked while this program had one thread: later, with threads, nothing can be
/// forked safely, and starting a program anew costs more than decoding a photograph. They end with this
/// program.
class HelperProcesses {
 public:
  struct Work {
    std::function<void()>
        prepare;  ///< called once, in the first of them: loads what `serve` needs; no threads
    std::function<void(const Channel&)> serve;
    Confinement confinement;
  };

  /// Call it before any thread is started. Throws ResourceError where the system gives no process.
  explicit HelperProcesses(Work work);
  HelperProcesses(const HelperProcesses&) = delete;
  HelperProcesses& operator=(const HelperProcesses&) = delete;
  ~HelperProcesses();

  /// A new process that serves the other end. Any thread may ask. Throws ResourceError.
  [[nodiscard]] Channel start() const;

 private:
  Channel m_requests;
  pid_t m_process = -1;
};

}  // namespace swaplight
