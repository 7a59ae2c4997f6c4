#include "core/base/out_of_memory.h"

#include <new>
#include <opencv2/core.hpp>

namespace swaplight {

bool isOutOfMemory(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) return true;
  const auto* opencv = dynamic_cast<const cv::Exception*>(&error);
  return opencv && opencv->code == cv::Error::StsNoMem;
}

}  // namespace swaplight
