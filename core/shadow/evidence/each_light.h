#pragma once

#include <atomic>
#include <string_view>

#include "core/base/parallel.h"
#include "core/base/progress.h"

namespace swaplight {

/// work(light) for every light, two at a time: each takes the memory of dozens of pictures. Says after each
/// how many of them are done.
template <typename Work>
void forEachLight(size_t count, const Progress& progress, std::string_view what, const Work& work) {
  std::atomic<size_t> done = 0;
  progress.update(0, what);
  const int lights = static_cast<int>(count);
  parallelRows(lights, (lights + 1) / 2, [&](int begin, int end) {
    for (int light = begin; light < end; ++light) {
      work(static_cast<size_t>(light));
      progress.update(static_cast<float>(++done) / static_cast<float>(count), what);
    }
  });
}

}  // namespace swaplight
