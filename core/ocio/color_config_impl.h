#pragma once

// For those who need OpenColorIO itself, such as the renderer for its shaders. Everyone else: color_config.h.

#include <OpenColorIO/OpenColorIO.h>

#include <string>

#include "core/ocio/color_config.h"

namespace swaplight {

namespace OCIO = OCIO_NAMESPACE;

/// The configuration that needs no file: scene-linear Rec.709 as reference, ACES by OCIO's built-in
/// transforms.
[[nodiscard]] OCIO::ConstConfigRcPtr builtinConfig();

struct ColorConfig::Impl {
  OCIO::ConstConfigRcPtr config;
  std::string name;  ///< the file, or "built-in"
  /// The same colour space in the built-in configuration and in this one, through which this one is given the
  /// built-in's spaces that it lacks. Equal and empty where this one is the built-in.
  std::string bridgeBuiltin;
  std::string bridgeHere;

  [[nodiscard]] bool has(const std::string& colorSpace) const;
  /// Throws InputError on unknown names; OCIO::Exception never leaves.
  [[nodiscard]] OCIO::ConstProcessorRcPtr conversion(const std::string& from, const std::string& to) const;
  [[nodiscard]] OCIO::ConstProcessorRcPtr view(const std::string& from, const DisplayChoice& choice) const;
};

}  // namespace swaplight
