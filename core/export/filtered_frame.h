#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/progress.h"
#include "core/export/frame_file.h"
#include "core/filter/filtered_image.h"

namespace swaplight {

/// How filters for a display see scene-linear light of this colour space: as the options' tone mapping, else
/// through their view, else through `seenThrough`, else as plain sRGB. `config` must live as long.
[[nodiscard]] std::function<void(ImageSpan)> displayFromScene(const ColorConfig& config,
                                                              std::string colorSpace,
                                                              const FrameOptions& options);

/// Scene-linear light that is written without a view, under the grade of `seenThrough`. Codes for a display
/// have it from their view, and so has what is still to go through one.
[[nodiscard]] FilteredImage gradedLight(const ColorConfig& config, FilteredImage frame,
                                        const FrameOptions& options);

/// The light of a filtered picture: scene-linear as it is; codes for a display decoded by sRGB's curve, into
/// lin_rec709.
[[nodiscard]] Image lightOf(FilteredImage frame);

/// Writes what a camera look has made of a frame. Scene-linear light as writeFrame does; codes for a display
/// as they are, with that display's profile, or decoded where the file holds light. Throws InputError;
/// Stopped.
void writeFilteredFrame(const ColorConfig& config, FilteredImage frame, const std::filesystem::path& file,
                        const FrameOptions& options, const Progress& progress = {});

}  // namespace swaplight
