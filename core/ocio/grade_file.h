#pragma once

#include <filesystem>
#include <string>

#include "core/ocio/color_grade.h"

namespace swaplight {

// Colour corrections as files, read and written by OpenColorIO.

/// True for .cc, .ccc and .cdl.
[[nodiscard]] bool isGradeFile(const std::filesystem::path& file);

/// Reads a correction: of a .ccc or .cdl the one with this id, or its first. Throws InputError that names the
/// file: not there, no correction, none of that id, values out of range.
[[nodiscard]] ColorGrade readGrade(const std::filesystem::path& file, const std::string& id = {});

/// Writes .cc, .ccc or .cdl by the file's extension, under a temporary name that is then renamed.
/// `description` stands in the file; plain words without < > &. Throws InputError.
void writeGrade(const ColorGrade& grade, const std::filesystem::path& file, const std::string& description);

/// Throws InputError where a value is out of the range that color_grade.h gives; `where` begins the message.
void checkGrade(const ColorGrade& grade, const std::string& where);

}  // namespace swaplight
