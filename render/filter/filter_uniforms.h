#pragma once

#include "core/filter/filter.h"
#include "render/gl/shader_program.h"

namespace swaplight {

/// Sets what a translated shader (core/filter/glsl/glsl_translation.h) reads of an input, if it does. The
/// program is in use. Pictures are bound as textures by who draws.
void setFilterInput(const ShaderProgram& program, const FilterInput& input, const FilterValue& value);

}  // namespace swaplight
