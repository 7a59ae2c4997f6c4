#include "core/base/version.h"

namespace swaplight {

// A function in a file of its own: a new version recompiles this and nothing else.
const char* version() {
  return SWAPLIGHT_VERSION;
}

}  // namespace swaplight
