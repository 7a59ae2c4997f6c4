#include "core/base/parallel.h"

#include <OpenImageIO/imageio.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <opencv2/core/utility.hpp>
#include <thread>
#include <vector>

namespace swaplight {
namespace {

std::unique_ptr<tbb::global_control>& limit() {
  static std::unique_ptr<tbb::global_control> control;
  return control;
}

}  // namespace

#ifdef __SANITIZE_THREAD__

// TBB is not built with the sanitizer, which then does not see how its threads wait for each other, and takes
// everything that they share for a race.
void parallelRows(int height, int grain, const std::function<void(int begin, int end)>& work) {
  const int step = std::max(grain, 1);
  std::atomic<int> next = 0;
  std::exception_ptr thrown;
  std::mutex mutex;
  const auto workOn = [&] {
    for (int begin = next.fetch_add(step); begin < height; begin = next.fetch_add(step)) try {
        work(begin, std::min(height, begin + step));
      } catch (...) {
        const std::lock_guard lock(mutex);
        thrown = std::current_exception();
        next = height;
      }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < threadCount() && i * step < height; ++i) others.emplace_back(workOn);
    workOn();
  }
  if (thrown) std::rethrow_exception(thrown);
}

#else

void parallelRows(int height, int grain, const std::function<void(int begin, int end)>& work) {
  if (height <= 0) return;
  const tbb::blocked_range<int> rows(0, height, std::max(grain, 1));
  tbb::parallel_for(
      rows, [&](const tbb::blocked_range<int>& band) { work(band.begin(), band.end()); },
      tbb::simple_partitioner());
}

#endif

void parallelEach(int count, const std::function<void(int)>& work) {
  parallelRows(count, 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) work(i);
  });
}

void setThreads(int count) {
  const int threads = count > 0 ? count : tbb::info::default_concurrency();
  limit().reset();
  limit() = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<size_t>(threads));
  OIIO::attribute("threads", threads);
  OIIO::attribute("exr_threads", threads);
  cv::setNumThreads(threads);
}

int threadCount() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace swaplight
