#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/capture/capture.h"

namespace swaplight {

/// What is said of a light that is not there. `where` begins it: the file or option that names the light;
/// nothing where the caller says so.
[[nodiscard]] InputError noSuchLight(const std::string& where, const std::string& name,
                                     const std::vector<std::string>& lights);

/// A light's place among the names. Throws noSuchLight().
[[nodiscard]] size_t placeOfLight(const std::vector<std::string>& lights, const std::string& name,
                                  const std::string& where);
/// The same in a capture.
[[nodiscard]] size_t placeOfLight(const Capture& capture, const std::string& name, const std::string& where);

}  // namespace swaplight
