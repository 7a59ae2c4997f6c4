#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/ocio/color_config.h"
#include "core/session/document.h"

namespace swaplight {

/// A document as it is for another set of the same lamps, photographed from elsewhere (wide and close).
struct OtherSetDocument {
  Document document;
  std::vector<std::string> notes;  ///< what could not come along, or is only in the other set; a line each
  bool complete = true;            ///< all came along
};

/// The lighting and the gallery of `from`, its cues, view and camera look, for the set `source`, whose lights
/// are those of `capture`: lights are found by their names, edits as placeFreeEdits has them. Throws
/// InputError for a set that has none of the lights.
[[nodiscard]] OtherSetDocument documentForSet(const Document& from, const std::filesystem::path& source,
                                              const Capture& capture);

/// The capture that a set's file describes, or that was solved to it; reads no pictures. Throws InputError
/// for what is neither.
[[nodiscard]] Capture captureOfSource(const ColorConfig& config, const std::filesystem::path& source);

}  // namespace swaplight
