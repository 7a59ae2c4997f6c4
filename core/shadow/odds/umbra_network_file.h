#pragma once

#include <span>

namespace swaplight {

/// The bytes of umbra_network.onnx, which are part of the program.
[[nodiscard]] std::span<const char> umbraNetworkFile();

}  // namespace swaplight
