#pragma once

#include "core/edit/apply/prepared_edit.h"

namespace swaplight {

/// What an operation wants beta to be, for a row of pixels x.. of row y. `chosen` counts within edit.lights;
/// `blurred` is beta's blurred row, for operations that look around. Never below 0.
void targetRow(const PreparedEdit& edit, size_t chosen, int y, int x, const float* beta, const float* blurred,
               int count, float* target);

}  // namespace swaplight
