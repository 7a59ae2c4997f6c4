#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <span>

namespace swaplight {

/// How a camera or a programme has coded its pictures.
struct CameraSpace {
  const char* name;         ///< as "color_space" of a capture names it
  const char* description;  ///< for people
  const char* alias;        ///< another name that is known for it
};

/// Codings that photographs come in beside sRGB and ACES, for the built-in configuration: plain powers, the
/// Rec.709 camera curve, linear light in the primaries of P3 and Rec.2020, and the logs of cinema cameras
/// that OpenColorIO 2.1 has built in.
[[nodiscard]] std::span<const CameraSpace> cameraSpaces();

/// From such a coding to linear light with Rec.709 primaries and white D65 (adapted by Bradford). Light of
/// primaries beyond Rec.709 is negative there. `name` is one of cameraSpaces() (checked).
[[nodiscard]] OCIO_NAMESPACE::TransformRcPtr rec709FromCamera(const char* name);

}  // namespace swaplight
