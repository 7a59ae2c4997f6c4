#include "core/base/parallel.h"

#include <OpenImageIO/imageio.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <opencv2/core/utility.hpp>

namespace swaplight {
namespace {

std::unique_ptr<tbb::global_control>& limit() {
  static std::unique_ptr<tbb::global_control> control;
  return control;
}

}  // namespace

void parallelRows(int height, int grain, const std::function<void(int begin, int end)>& work) {
  if (height <= 0) return;
  const tbb::blocked_range<int> rows(0, height, std::max(grain, 1));
  tbb::parallel_for(
      rows, [&](const tbb::blocked_range<int>& band) { work(band.begin(), band.end()); },
      tbb::simple_partitioner());
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
