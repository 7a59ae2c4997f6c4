#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>

// What the fuzz targets share. A target is one loader; scripts/fuzz builds and runs them.

namespace swaplight::fuzz {

inline std::string textOf(const uint8_t* data, size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Runs a loader as its callers do: bad input throws InputError or one of the machine's. Whatever else comes
/// out is a defect and ends the process. (That errors are one line is seen to where they are said.)
void load(const std::function<void()>& loader);

/// A file in memory with these bytes, for loaders that take paths; valid until the next.
std::filesystem::path fileOf(const uint8_t* data, size_t size);

}  // namespace swaplight::fuzz
