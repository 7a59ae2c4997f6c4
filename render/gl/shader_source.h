#pragma once

#include <filesystem>
#include <string>

namespace swaplight {

/// The folder with the shaders: share/swaplight/shaders beside an installed program, else the one in the
/// source. Throws ResourceError that names both where neither exists.
[[nodiscard]] std::filesystem::path shaderFolder();

/// A shader file with its lines `#include "other.glsl"` replaced by those files. Throws ResourceError where a
/// file is missing.
[[nodiscard]] std::string shaderSource(const std::string& file);

/// Every line with its number in front, as compilers count.
[[nodiscard]] std::string numberedSource(const std::string& source);

}  // namespace swaplight
