#pragma once

namespace swaplight {

/// The program's version, as in "0.1.0".
[[nodiscard]] const char* version();

}  // namespace swaplight
