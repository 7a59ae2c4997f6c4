#include "core/shadow/odds/umbra_network_file.h"

// The assembler takes the file in as it is: a program has it wherever it is put, and no compiler reads a
// million numbers. SWAPLIGHT_UMBRA_NETWORK: its path (CMakeLists.txt).
#ifdef __APPLE__
#define SWAPLIGHT_CONSTANTS ".const_data\n"
#define SWAPLIGHT_LABEL(name) "_" name
#else
#define SWAPLIGHT_CONSTANTS ".section .rodata\n"
#define SWAPLIGHT_LABEL(name) name
#endif

extern "C" {
extern const char swaplightUmbraNetwork[];
extern const char swaplightUmbraNetworkEnd[];
}

// clang-format off
__asm__(SWAPLIGHT_CONSTANTS
        ".globl " SWAPLIGHT_LABEL("swaplightUmbraNetwork") "\n"
        ".globl " SWAPLIGHT_LABEL("swaplightUmbraNetworkEnd") "\n"
        ".balign 16\n"
        SWAPLIGHT_LABEL("swaplightUmbraNetwork") ":\n"
        ".incbin \"" SWAPLIGHT_UMBRA_NETWORK "\"\n"
        SWAPLIGHT_LABEL("swaplightUmbraNetworkEnd") ":\n"
        ".byte 0\n"
        ".text\n");
// clang-format on

namespace swaplight {

std::span<const char> umbraNetworkFile() {
  return {swaplightUmbraNetwork, swaplightUmbraNetworkEnd};
}

}  // namespace swaplight
