#pragma once

#include <functional>

namespace swaplight {

/// Calls work(begin, end) on bands of the rows 0..height, on all threads that the process may use (see
/// setThreads). A band has at most `grain` rows. What work throws reaches the caller.
void parallelRows(int height, int grain, const std::function<void(int begin, int end)>& work);

/// Calls work(0), work(1) ... work(count - 1), on all those threads. What work throws reaches the caller.
void parallelEach(int count, const std::function<void(int)>& work);

/// How many threads the process uses, reading and writing pictures included; 0 or less: one a core. Lasts
/// until the next call.
void setThreads(int count);
[[nodiscard]] int threadCount();

}  // namespace swaplight
