#pragma once

#include "core/base/error.h"

namespace swaplight {

/// The machine could not: the disk is full, an I/O error, no more open files. A message as InputError's, and
/// caught where those are; but ends a verb with exit code 3.
class MachineError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace swaplight
