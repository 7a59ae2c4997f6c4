#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/relight/rig.h"

namespace swaplight {

// The level of a light: a factor of the captured one, as people at a lighting desk say it.

/// In which unit a bare number is meant.
enum class LevelUnit { Stops, Percent, Multiplier };

/// The factor that a text says: 0, or 2^-30 .. 2^30.
///   50%, @50, @50%   in per cent of the captured level
///   full, out        100 % and 0
///   x2, 2x, ×2       times the captured level
///   -1st, +1.5 stops above or below it
///   50               in the unit `bare`, if there is one
/// Nothing where the text says no level. Throws InputError, which quotes it, where the level is out of range.
[[nodiscard]] std::optional<double> levelFromText(std::string_view text, std::optional<LevelUnit> bare = {});

/// The same for a text that has to be a level: throws InputError, which says what can be written.
[[nodiscard]] double wantedLevel(std::string_view text, LevelUnit bare);

/// 2^stops x multiplier.
[[nodiscard]] double levelOf(const LightSetting& setting);
/// All of the level in its stops, which sliders show; 0 in the multiplier, as it has no stops.
void setLevel(LightSetting& setting, double level);

/// Lights at a level, each of them; with one that is locked (ratioLock) all other locked lights keep their
/// ratio to it.
[[nodiscard]] Rig withLevel(Rig rig, std::span<const size_t> lights, double level);

}  // namespace swaplight
