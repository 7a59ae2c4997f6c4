#include <cmath>
#include <cstdlib>

#include "core/look/look.h"
#include "core/relight/rig.h"
#include "core/relight/setting.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

// A light's setting, as `3200K,+1st`; it comes back from its own text. Also read as a look's name and amount.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = fuzz::textOf(data, size);
  fuzz::load([&] {
    LightSetting setting;
    applySetting(setting, text);
    const Rgb factor = lightFactor(setting);
    if (!std::isfinite(factor.x + factor.y + factor.z)) std::abort();
    LightSetting again;
    applySetting(again, settingText(setting));
    if (settingText(again) != settingText(setting)) std::abort();
  });
  fuzz::load([&] { static_cast<void>(lookRequestFromText(text)); });
  return 0;
}
