#include <cmath>
#include <cstdlib>

#include "core/base/json.h"
#include "core/edit/stack/edit_file.h"
#include "core/session/open_source.h"
#include "core/set/solved_set.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

namespace {

std::shared_ptr<const SolvedSet> smallSet() {
  auto set = std::make_shared<SolvedSet>();
  for (const char* light : {"key", "fill"}) {
    set->contributions.emplace_back(ImageSpec::rgb(12, 8), 0.5F);
    set->capture.lights.push_back({light, Role::Other, {}});
  }
  updateBeta(*set);
  return set;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const std::shared_ptr<const SolvedSet> set = smallSet();
  fuzz::load([&] {
    const EditStack stack = readEdits(fuzz::fileOf(data, size), set->width(), set->height());
    static_cast<void>(jsonFromEditStack(stack).dump());
    const SolvedSet edited = withEdits(set, stack);
    for (const Image& light : edited.contributions)
      for (int c = 0; c < 3; ++c)
        for (size_t p = 0; p < light.pixelCount(); ++p)
          if (!std::isfinite(light.plane(c)[p])) std::abort();
  });
  return 0;
}
