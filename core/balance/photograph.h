#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/capture/capture_pixels.h"
#include "core/ocio/color_config.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// The colour space of a photograph that no manifest describes: that of the configuration's file rules; else,
/// of files with code values (PNG, JPEG, TIFF), that which the shots of `capture` were coded in; else what
/// the file says or its format implies. Throws InputError that names the file where it cannot be read.
[[nodiscard]] std::string colorSpaceOfPhotograph(const ColorConfig& config, const Capture& capture,
                                                 const std::filesystem::path& file);

/// A photograph by itself, as the only shot, in linear light. `colorSpace` is that of the file; empty: see
/// colorSpaceOfPhotograph. Throws InputError that names the file: missing, broken, unknown colour space.
[[nodiscard]] CapturePixels loadPhotograph(const ColorConfig& config, const std::filesystem::path& file,
                                           const std::string& colorSpace, const Progress& progress = {});

/// Another photograph of a solved set, as its only shot: cropped and scaled as the set's own were, in linear
/// light in the set's primaries. `colorSpace` is that of the file; empty: see colorSpaceOfPhotograph. Throws
/// InputError that names the file: missing, broken, another size than the set (both said), unknown colour
/// space.
[[nodiscard]] CapturePixels loadPhotographOf(const ColorConfig& config, const SolvedSet& set,
                                             const std::filesystem::path& file, const std::string& colorSpace,
                                             const Progress& progress = {});

}  // namespace swaplight
