#pragma once

#include <filesystem>
#include <string>

#include "core/image/image.h"
#include "core/solve/solved_set.h"

namespace swaplight {

/// Writes the beta maps of all lights for an image editor: an EXR with a channel beta.<light> each (float),
/// or, where the name ends in .png, a 16-bit grey PNG a light (name.<light>.png; 65535 is 1). Returns the
/// files written. Throws InputError where they cannot be written.
std::vector<std::filesystem::path> writeBetaMaps(const SolvedSet& set, const std::filesystem::path& file);

/// Reads one light's beta map: the channel named, or beta.<light>, or the file's only one, or the mean of its
/// R, G and B (an editor may have made a colour picture of it). Integer files are taken as 0..1, without a
/// transfer curve. Throws InputError: another size, no such channel, values that are not finite or outside
/// 0..1 by more than rounding (1/1000).
[[nodiscard]] Image readBetaMap(const std::filesystem::path& file, const std::string& channel,
                                const std::string& light, int width, int height);

}  // namespace swaplight
