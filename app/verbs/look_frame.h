#pragma once

#include <filesystem>

#include "app/verbs/look_actions.h"
#include "core/ocio/color_config.h"

namespace swaplight {

/// R, G, B, and A where it is wanted (the file's own, or 1). Floats and raw files hold light, others codes.
/// Throws InputError.
[[nodiscard]] FilteredImage readFrame(const std::filesystem::path& file, bool alpha);

/// How filters see this frame: by the view that the command line names, else sRGB. `config` must live as
/// long.
[[nodiscard]] PipelineOptions pipelineOptionsFor(const ColorConfig& config, const FilteredImage& frame,
                                                 const LookArguments& arguments);

/// Light as relight writes it; codes as they are, or decoded where the file holds light. Throws InputError.
void writeFiltered(const ColorConfig& config, FilteredImage frame, const std::filesystem::path& file,
                   const LookArguments& arguments);

}  // namespace swaplight
