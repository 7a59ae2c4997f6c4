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
  std::vector<std::string> notes;  ///< what could not come along, a line each
};

/// The lighting and the gallery of `from`, its cues, view and camera look, for the set `source`, whose lights
/// are those of `capture`: lights are found by their names, edits as placeFreeEdits has them.
[[nodiscard]] OtherSetDocument documentForSet(const Document& from, const std::filesystem::path& source,
                                              const Capture& capture);

/// The capture that a set's file describes, or that was solved to it; reads no pictures. Throws InputError
/// for what is neither.
[[nodiscard]] Capture captureOfSource(const ColorConfig& config, const std::filesystem::path& source);

}  // namespace swaplight
