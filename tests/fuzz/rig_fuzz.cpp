#include <cmath>
#include <cstdlib>

#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/look/light_ratios.h"
#include "core/look/look.h"
#include "core/look/saved_look.h"
#include "core/relight/rig.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

// A rig, or the list of a session's looks.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fuzz::load([&] {
    const Json json = parseJson(fuzz::textOf(data, size), "rig.json");
    if (json.is_array()) {
      static_cast<void>(jsonFromSavedLooks(savedLooksFromJson(json, "looks")).dump());
      return;
    }
    const Rig rig = rigFromJson(json);
    for (const Rgb& factor : rigFactors(rig))
      if (!std::isfinite(factor.x + factor.y + factor.z)) std::abort();
    if (!(rigFromJson(Json::parse(jsonFromRig(rig).dump())) == rig)) std::abort();
  });
  return 0;
}
