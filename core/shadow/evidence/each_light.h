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
  std::atomic<size_t> next = 0, done = 0;
  progress.update(0, what);
  // Whoever is done takes the next light: some have few shadows, and are done soon.
  parallelEach(2, [&](int) {
    for (size_t light = next++; light < count; light = next++) try {
        work(light);
        progress.update(static_cast<float>(++done) / static_cast<float>(count), what);
      } catch (...) {
        next = count;  // no other is begun
        throw;
      }
  });
}

}  // namespace swaplight
