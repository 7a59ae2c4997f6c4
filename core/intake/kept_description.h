#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "core/capture/capture.h"

namespace swaplight {

/// A description that is made anew, with what the one that it replaces says and it does not: name, noise,
/// truth, roles, flat pictures, ambient and dark pictures, and what other programs wrote
/// there. Lights are found by their names, photographs by their files; what is told of others is dropped.
[[nodiscard]] Capture withKept(Capture made, const Capture& before);

/// The same with the capture.json that lies there; as it is where there is none. One that cannot
/// be read is kept beside it as capture.json.broken.
[[nodiscard]] Capture withKept(Capture made, const std::filesystem::path& file);

/// The files that the capture.json there says were taken through crossed polarisers; none where there is
/// none, or it cannot be read.
[[nodiscard]] std::set<std::string> crossedIn(const std::filesystem::path& file);

}  // namespace swaplight
