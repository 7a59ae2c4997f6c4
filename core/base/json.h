#pragma once

#include <nlohmann/json.hpp>

namespace swaplight {

/// Keeps the order of keys, so that a file written back looks as the person wrote it.
using Json = nlohmann::ordered_json;

}  // namespace swaplight
