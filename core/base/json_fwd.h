#pragma once

#include <nlohmann/json_fwd.hpp>

namespace swaplight {

/// Keeps the order of keys, so that a file written back looks as the person wrote it. Only declared here,
/// which is enough for headers: sources that look into JSON include json.h, the whole of which takes a second
/// to compile.
using Json = nlohmann::ordered_json;

}  // namespace swaplight
