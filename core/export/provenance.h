#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/relight/rig.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// Where a picture comes from, as attributes of its header:
///   swaplight/capture  the capture's manifest (JSON)
///   swaplight/rig      the lighting (JSON)
///   swaplight/solver   the solver's own summary: message, model, solver, residual (JSON)
///   swaplight/source   [{"file", "sha256"}]: the solved file, or the photographs of the capture (JSON)
/// `source` is what was opened, a capture.json or a solved set. Files that are gone have no hash.
[[nodiscard]] std::map<std::string, std::string> provenanceOf(const SolvedSet& set, const Rig& rig,
                                                              const std::filesystem::path& source);

}  // namespace swaplight
