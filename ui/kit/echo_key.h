#pragma once

namespace swaplight {

/// The key that no action has: a test presses it, and sees when all that it did before has been drawn.
constexpr const char* kEchoKey = "F24";

}  // namespace swaplight
