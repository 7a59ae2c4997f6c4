#pragma once

#include <filesystem>
#include <string>

#include "core/filter/filter.h"
#include "core/image/image.h"

namespace swaplight {

/// A picture that a filter reads, R G B and alpha where it has one, in what the filter works on: floats hold
/// light, other formats sRGB codes, each decoded or encoded as needed. Light is brought to `primaries`, a
/// linear colour space that any configuration knows. A colour table (.cube, 3-D) becomes a
/// picture of N * N x N pixels: red and green across (green slowest), blue upwards. Throws InputError that
/// names the file.
[[nodiscard]] Image readFilterPicture(const std::filesystem::path& file, FilterSpace space,
                                      const std::string& primaries);

}  // namespace swaplight
