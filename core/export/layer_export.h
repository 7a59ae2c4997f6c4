#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/filter/frame_filter.h"
#include "core/image/pixel_pack.h"
#include "core/image/pixel_rect.h"
#include "core/ocio/display_choice.h"
#include "core/relight/rig.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// Under which names the layers stand.
enum class LayerNaming {
  Layers,   ///< R G B and <light>.R: what Nuke, Resolve, Natron and OpenImageIO read
  Blender,  ///< ViewLayer.Combined.R and ViewLayer.Combined_<light>.R, as Blender writes its light groups
};

/// How a set's lights are written for a compositor.
struct LayerOptions {
  LayerNaming naming = LayerNaming::Layers;
  bool multipart = false;                ///< one part a layer; not with Blender's names
  std::string compression = "zip";       ///< an OpenEXR compression
  PixelType pictures = PixelType::Half;  ///< of the colour layers: Half or Float
  PixelType data = PixelType::Float;     ///< of beta and quality: Half or Float
  /// Primaries of the colour layers, white adapted (Bradford): lin_rec709, acescg, aces2065_1 ... Empty: the
  /// set's.
  std::string colorSpace = {};
  bool beta = false;        ///< beta.<light> too
  bool highlights = false;  ///< <light>.spec too, a part of <light>, of a set that knows its highlights
  bool quality = false;     ///< quality.residual, .sigma, .flags too
  /// The part of the picture that is written; nothing: that of the photographs.
  std::optional<PixelRect> dataWindow;
  std::map<std::string, std::string> text;  ///< for the header: see provenanceOf
  /// Adds the layer camera_look: the sum as this look shows it, as light. No part of the sum. Null: none.
  std::shared_ptr<FrameFilter> cameraLook = {};
  DisplayChoice seenThrough = {};  ///< the view in which the look's filters for a display work; empty: sRGB
  int frameNumber = 0;             ///< from which the look's grain and flicker follow
};

/// Writes each light as it shines under the rig, and what no light explains, as layers of one EXR; R G B (or
/// Combined) is their sum: layers are rounded to their type first and added in their order, in float, so that
/// who adds them up gets it to the bit in float, and within half a step of its type in half. Scene-linear, in
/// the primaries asked for. Half becomes float where light is brighter than half can hold: of the lights, of
/// their highlights, of the sum, of the camera look, each by itself. What the photographs' files held beside
/// their colour goes along. Returns the type of the lights' layers. Throws
/// InputError where it cannot be written.
PixelType exportLayers(const ColorConfig& config, const SolvedSet& set, const Rig& rig,
                       const std::filesystem::path& file, const LayerOptions& options,
                       const Progress& progress = {});

/// The names of the layers in their order, ambient last where there is one: they add up to R G B.
[[nodiscard]] std::vector<std::string> exportedLayers(const SolvedSet& set, const LayerOptions& options);

}  // namespace swaplight
