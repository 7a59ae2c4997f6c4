#pragma once

#include <filesystem>
#include <string>

#include "core/base/progress.h"
#include "core/image/io/image_io.h"
#include "core/set/solved_set.h"

namespace swaplight {

struct SolvedFileOptions {
  bool multipart = false;           ///< one part a light instead of one part with layers
  std::string compression = "zip";  ///< an OpenEXR compression
  /// Contributions as 32-bit float instead of half; done anyway where half cannot hold them (brighter than
  /// 65504, or darker than 1e-3 on the mean).
  bool floatPictures = false;
  bool halfSum = false;  ///< R G B as half instead of float, where that holds them to a thousandth
};

/// Throws InputError where a solved set cannot be written to a file of this name, for it is no EXR: to be
/// asked before the work.
void checkSolvedFile(const std::filesystem::path& file);

/// Writes a solved set as one multichannel OpenEXR (formats.md), to a temporary name that is then renamed.
/// Throws InputError where the file cannot be written (the disk is full, no permission).
void writeSolvedSet(const SolvedSet& set, const std::filesystem::path& file,
                    const SolvedFileOptions& options = {}, const Progress& progress = {});

/// For those who do not look at highlights: reading them takes up to a third of the memory and the time.
enum class HighlightReading { All, None };

/// Reads single-part and multi-part files. Throws InputError where a channel that docs/formats.md demands is
/// missing.
[[nodiscard]] SolvedSet readSolvedSet(const std::filesystem::path& file, const Progress& progress = {},
                                      HighlightReading highlights = HighlightReading::All);

/// Whether a solved set's file of these channels holds the light's highlights: all three channels of them.
[[nodiscard]] bool holdsHighlights(const ImageSpec& spec, const std::string& light);

/// What a solved set says of itself, without its pixels.
struct SolvedHeader {
  ImageSpec spec;
  ImageFileInfo info;
  Capture capture;
  std::optional<SolveReport> report;
};
/// Throws InputError where readSolvedSet would, for what stands in the header.
[[nodiscard]] SolvedHeader readSolvedHeader(const std::filesystem::path& file);

/// The header's text with what dynamicRange says of the set as JSON: for those who only look at the header.
inline constexpr const char* kSolvedRanges = "swaplight/dynamicRange";

/// True for an EXR that holds a solved set. Looks at the header only.
[[nodiscard]] bool isSolvedSet(const std::filesystem::path& file);

}  // namespace swaplight
