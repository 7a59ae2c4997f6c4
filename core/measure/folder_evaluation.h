#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/base/progress.h"
#include "core/measure/evaluate.h"

namespace swaplight {

/// How the pictures of a folder differ from those of the same name in another one.
struct FolderEvaluation {
  std::string test, reference;
  struct Picture {
    std::string name;  ///< relative to the folder, without extension
    Evaluation evaluation;
  };
  std::vector<Picture> pictures;       ///< by name
  std::vector<std::string> unmatched;  ///< files that only one of the folders has
};

/// Compares every picture below `test` with the one of the same path, whatever its extension, below
/// `reference`. `options.plot` gets a box a picture of the first metric, `options.histogram` the mean of
/// their luminance. The difference maps are not kept. Throws InputError as evaluate does, where the folders
/// have no picture in common, and where a map is asked for; Stopped.
[[nodiscard]] FolderEvaluation evaluateFolders(const std::filesystem::path& test,
                                               const std::filesystem::path& reference,
                                               const EvaluateOptions& options = {},
                                               const Progress& progress = {});

/// "pictures": an evaluation each with its name; "mean": of each metric's statistics over them; "unmatched".
[[nodiscard]] Json jsonFromFolders(const FolderEvaluation& evaluation);
/// A table a metric, for people; ends with a newline.
[[nodiscard]] std::string textFromFolders(const FolderEvaluation& evaluation);

}  // namespace swaplight
