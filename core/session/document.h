#pragma once

#include <filesystem>
#include <string>

#include "core/cue/cue_list.h"
#include "core/edit/stack/edit.h"
#include "core/filter/filter_pipeline.h"
#include "core/look/saved_look.h"
#include "core/ocio/display_choice.h"
#include "core/relight/rig.h"
#include "core/solve/model/solve_options.h"

namespace swaplight {

/// Everything of a session that is the person's work: saved, and undone by going back to an earlier value.
/// A value: cheap to copy, because what is heavy is shared and never changed in place. Where the person is
/// looking (zoom, panels) is no part of it.
struct Document {
  std::filesystem::path source;  ///< a capture or a solved set, absolute; empty where nothing is open
  SolveOptions solve;            ///< how a capture is solved; without meaning for a solved set
  EditStack edits;               ///< of the source's lights, before they are mixed
  Mask selection;                ///< what restricts new edits: see core/edit/mask/selection.h
  Rig rig;                       ///< in the source's order of lights, then those that the edits add
  /// Primaries in which lights are multiplied and added: see inColorSpace; empty: the source's own.
  std::string workingSpace;
  std::filesystem::path colorConfig;  ///< an OpenColorIO configuration, absolute; empty: none chosen
  DisplayChoice display;              ///< of the picture on the monitor
  FilterPipeline cameraLook;          ///< what the lit picture is seen through; without stages: nothing
  std::vector<SavedLook> looks;       ///< the gallery: looks and versions
  CueList cues;                       ///< a show made of them
  bool operator==(const Document&) const = default;
};

/// Bytes that `document` holds and `before` does not share: what keeping it in the history costs.
[[nodiscard]] size_t documentBytes(const Document& document, const Document& before);

/// The rig for exactly the lights of a capture, in its order: settings are taken from `rig` by name, lights
/// that it does not know are as captured, lights that the capture does not have are left out.
[[nodiscard]] Rig fitRig(const Rig& rig, const Capture& capture);
/// The capture with the lights that edits add to it.
[[nodiscard]] Capture withNewLights(Capture capture, const EditStack& edits);

}  // namespace swaplight
