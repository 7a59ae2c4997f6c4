#pragma once

// For those who need OpenColorIO itself; everyone else: color_grade.h.

#include <OpenColorIO/OpenColorIO.h>

#include <mutex>

#include "core/ocio/color_grade.h"

namespace swaplight {

namespace OCIO = OCIO_NAMESPACE;

/// The grade as a CDL file holds it.
[[nodiscard]] OCIO::CDLTransformRcPtr cdlOf(const ColorGrade& grade);
/// The grade on codes of the grading space. Codes above `highest` are held there, before the saturation and
/// behind it: no light becomes infinite.
[[nodiscard]] OCIO::ConstTransformRcPtr gradeTransform(const ColorGrade& grade, double highest);

/// Held while OpenColorIO reads a file or makes a processor: see color_config_impl.h.
[[nodiscard]] std::mutex& processorMutex();

}  // namespace swaplight
