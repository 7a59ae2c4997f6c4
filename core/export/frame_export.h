#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/export/frame_file.h"
#include "core/session/document.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// How a session's frame is written to this file: as asked for, and where neither linear, a view nor a tone
/// mapping is asked for, through the session's view (under the look asked for, if any) where the format is
/// made for the eye. The session's grade is on every frame, unless another one is asked for. Throws
/// InputError on an unknown format.
[[nodiscard]] FrameOptions frameOptionsFor(const DisplayChoice& display, const std::filesystem::path& file,
                                           FrameOptions asked = {});

/// Relights a set under a rig, puts camera look and grade on it and writes the frame, with all in its header:
/// the one way by which frames leave the studio and the command line, so that they are the same to the bit.
/// Throws InputError as writeFrame does.
void exportFrame(const ColorConfig& config, const SolvedSet& set, const Rig& rig,
                 const std::filesystem::path& file, FrameOptions options, const Progress& progress = {});

}  // namespace swaplight
