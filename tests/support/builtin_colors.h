#pragma once

#include "core/ocio/color_config.h"

namespace swaplight::test {

/// The built-in colour configuration, one for all tests.
inline const ColorConfig& builtinColors() {
  static const ColorConfig config("");
  return config;
}

}  // namespace swaplight::test
