#pragma once

#include <string>

#include "core/ocio/color_config_impl.h"

namespace swaplight {

/// Throws InputError for a pipe or a device, which would be read for ever. What is missing is left to
/// OpenColorIO.
void checkConfigFile(const std::string& file);

/// Finds what OpenColorIO 2.1 does not survive: colour spaces and looks that lead back to themselves (it
/// recurses until the stack is full; repaired upstream in pull request 2318), and tables that are no regular
/// files (a link to a device or a pipe is read for ever). Throws InputError that begins with `name`.
void checkConfig(const OCIO::ConstConfigRcPtr& config, const std::string& name);

}  // namespace swaplight
