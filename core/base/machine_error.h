#pragma once

#include <cerrno>

#include "core/base/error.h"

namespace swaplight {

/// The machine could not: the disk is full, an I/O error, no more open files. A message as InputError's, and
/// caught where those are; but ends a verb with exit code 3.
class MachineError : public InputError {
 public:
  using InputError::InputError;
};

/// Whether an errno says that there is no room: on the disk, or in one's share of it.
[[nodiscard]] inline bool isFull(int error) {
  return error == ENOSPC || error == EDQUOT;
}

}  // namespace swaplight
