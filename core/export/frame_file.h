#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/export/still_tone.h"
#include "core/filter/frame_filter.h"
#include "core/image/image.h"
#include "core/image/io/image_io.h"
#include "core/ocio/color_config.h"
#include "core/ocio/display_choice.h"

namespace swaplight {

/// How a frame leaves the program.
struct FrameOptions {
  /// Scene-linear pixels, whatever the format. Without it and without a view: EXR and HDR are scene-linear,
  /// all other formats are plain sRGB.
  bool linear = false;
  DisplayChoice display;  ///< the view that it is seen through; where nothing of it is said: none
  WriteOptions write;
  /// Scene-linear pixels in these primaries, white adapted (Bradford): lin_rec709, acescg, aces2065_1, or
  /// another space of the configuration. Empty: the set's own.
  std::string colorSpace = {};
  /// Instead of a view: tone mapped by the whole picture, then plain sRGB. Not for EXR and HDR.
  std::optional<StillTone> tone = {};
  /// A camera look that frames are seen through before they are written; null: none. writeFrame does not ask
  /// for it, exportFrame does.
  std::shared_ptr<FrameFilter> cameraLook = {};
  int frameNumber = 0;  ///< from which the camera look's grain and flicker follow
  /// The view in which the camera look's filters for a display work where `display` says none. Its grade is
  /// put on what is written without a view, too, by exportFrame.
  DisplayChoice seenThrough = {};
};

/// True where a frame is scene-linear unless a view is asked for, by the file's extension. Throws InputError
/// that lists the formats.
[[nodiscard]] bool isSceneLinear(const std::filesystem::path& file);

/// Throws InputError where the file's format is not one for a contact sheet.
void checkSheetFile(const std::filesystem::path& file);

/// What can be said before the frame is there. Throws InputError, listing the known ones, where the file's
/// format, the display, the view or a look is unknown, and where more than one of linear, a view and a
/// tone mapping is asked for, or a tone mapping or a look alone for a scene-linear format.
void checkFrame(const ColorConfig& config, const std::filesystem::path& file, const FrameOptions& options);

/// What a frame so written holds, for people: "scene-linear light", or "seen through" its display and view,
/// where plain sRGB is "sRGB".
[[nodiscard]] std::string frameContents(const ColorConfig& config, const std::filesystem::path& file,
                                        const FrameOptions& options);

/// Writes codes of a display as they are, with its ICC profile or code points. `display` by the
/// configuration's own names (namedDisplay); empty: plain sRGB. Throws InputError as writeImage does;
/// Stopped.
void writeCodes(Image codes, const std::filesystem::path& file, const DisplayChoice& display,
                WriteOptions write, const Progress& progress = {});

/// Writes R G B (and A, which an EXR has multiplied in) of a scene-linear frame, in its colour space's
/// primaries, to a temporary name that is then renamed. Throws InputError as checkFrame and writeImage do;
/// Stopped.
void writeFrame(const ColorConfig& config, Image frame, const std::filesystem::path& file,
                FrameOptions options, const Progress& progress = {});

}  // namespace swaplight
