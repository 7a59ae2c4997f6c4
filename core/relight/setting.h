#pragma once

#include <string>

#include "core/relight/rig.h"

namespace swaplight {

/// What a SETTING may be made of, for messages and help.
inline constexpr const char* kSettingGrammar =
    "off, on, white, #rrggbb, rgb:r/g/b, hsv:h/s/v, 3200K, green:+0.25, gel:L201, +1.5st, -2st, x1.7, 50%, "
    "@50, full";

/// Parses a SETTING (formats.md) onto a setting: a comma-joined list such as "3200K,+1st". Each part sets one
/// thing and leaves the others; of two parts for the same thing the later one holds.
///   off, on          whether the light is on
///   white            unit white
///   #rrggbb          sRGB-encoded
///   rgb:r/g/b        linear Rec.709, 0 or more
///   hsv:h/s/v        of the sRGB-encoded colour; h is 0..1 of a turn, or degrees above 1 (up to 360); s and
///   v
///                    are 0..1
///   3200K            white of that temperature, 1000..25000
///   green:+0.25      plus or minus green, -1..1, 1 = a full gel
///   gel:L201, L201   a gel in front of the lamp; gel:none takes it away
///   +1.5st, -2st     stops, -30..30
///   x1.7             multiplier, 0 or more
///   50%, @50         the whole level in per cent of the captured one: stops and multiplier
///   full, out        the level 100 % and 0
/// Throws InputError that quotes the part that is wrong and says what would be right.
void applySetting(LightSetting& setting, const std::string& text);

/// The shortest text that applySetting reads back to the same setting from a default one. Solo and mute are
/// no part of it.
[[nodiscard]] std::string settingText(const LightSetting& setting);

/// The part of it that is about the colour (with gel and green); "white" where there is none.
[[nodiscard]] std::string colorText(const LightColor& color);

}  // namespace swaplight
