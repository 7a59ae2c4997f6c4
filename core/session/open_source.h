#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/edit/mask/mask_context.h"
#include "core/edit/stack/edit.h"
#include "core/ocio/color_config.h"
#include "core/session/document.h"
#include "core/set/solved_set.h"
#include "core/solve/model/solve_options.h"

namespace swaplight {

/// What a path that a person has chosen can be.
enum class SourceKind { Capture, SolvedSet, Session, Folder, Other };

/// By extension, and for EXR by the header. A folder with a capture.json is that capture.
[[nodiscard]] SourceKind sourceKind(const std::filesystem::path& path);

/// The file that is meant: the capture.json of a folder, else the path itself; absolute.
[[nodiscard]] std::filesystem::path sourceFile(const std::filesystem::path& path);

/// Every file that opening it reads: none of them may be replaced by what is made of them. What a manifest
/// lacks is for its reader to say. Throws InputError where it is no JSON.
[[nodiscard]] std::vector<std::filesystem::path> filesOfSource(const std::filesystem::path& path);

/// The same of all that a session's document reads: its set, its configuration, its edits, selection and
/// camera look, and those of its versions.
[[nodiscard]] std::vector<std::filesystem::path> filesOfDocument(const Document& document);

/// A set from a solved file or, solving it, from a capture, whose pictures may be in any colour space of the
/// configuration; without highlights where `options` say so. Throws InputError, which says what can be
/// opened, for anything else; Stopped when asked to.
[[nodiscard]] SolvedSet openSource(const ColorConfig& config, const std::filesystem::path& path,
                                   const SolveOptions& options, const Progress& progress = {});

/// A set with a session's edits: the one way in which frames with edits are made. Throws InputError as the
/// edits say.
[[nodiscard]] SolvedSet withEdits(const std::shared_ptr<const SolvedSet>& set, const EditStack& edits);
/// The same with shadows that were found before, as shadowOptionsOf() the stack says, and surfaces, as its
/// lampPlaces do.
[[nodiscard]] SolvedSet withEdits(const std::shared_ptr<const SolvedSet>& set, const EditStack& edits,
                                  const ShadowSource& shadows, const SurfaceSource& surfaces);

}  // namespace swaplight
