#include <cmath>
#include <cstdlib>

#include "core/lamp/gel.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fuzz::load([&] {
    for (const Gel& gel : gelsFromCsv(fuzz::textOf(data, size), "gels.csv"))
      if (!std::isfinite(gel.filter.x + gel.filter.y + gel.filter.z)) std::abort();
  });
  return 0;
}
