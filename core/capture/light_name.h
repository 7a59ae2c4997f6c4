#pragma once

#include <span>
#include <string>

namespace swaplight {

/// Checks light names so that compositors keep them as EXR layers: [A-Za-z][A-Za-z0-9_]*, all different
/// whatever their case, none of the solved set's own layers (ambient, beta, quality). Throws InputError that
/// begins with `where`.
void checkLightNames(std::span<const std::string> names, const std::string& where);

}  // namespace swaplight
