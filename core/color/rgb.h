#pragma once

#include <glm/vec3.hpp>

namespace swaplight {

/// A linear colour. Which primaries is said where it is used; linear Rec.709 unless named.
using Rgb = glm::vec3;

}  // namespace swaplight
