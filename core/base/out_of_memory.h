#pragma once

#include <exception>

namespace swaplight {

/// Whether it says that memory ran out, in the words of whichever library was asked for it.
[[nodiscard]] bool isOutOfMemory(const std::exception& error);

}  // namespace swaplight
