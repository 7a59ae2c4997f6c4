#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/edit/stack/edit.h"
#include "core/filter/filter_pipeline.h"
#include "core/ocio/display_choice.h"
#include "core/relight/rig.h"

namespace swaplight {

/// What a version holds beside the lighting.
struct VersionScene {
  EditStack edits;
  DisplayChoice display;
  FilterPipeline cameraLook;
  bool operator==(const VersionScene&) const = default;
};

/// A lighting that a person has kept: of the gallery, saved in the session. Its picture is made again from
/// the set whenever it is shown.
struct SavedLook {
  std::string name;  ///< one of its kind in a session
  std::string note;
  Rig rig;
  std::optional<VersionScene> scene = {};  ///< of a version; without: a look, which is a lighting only
  bool operator==(const SavedLook&) const = default;
};

/// The first of "Look 1", "Look 2" ... that is free; or "Version 1" ...
[[nodiscard]] std::string freeLookName(const std::vector<SavedLook>& looks, const std::string& kind = "Look");
/// The look of this name (see sameLookName), or nullptr.
[[nodiscard]] const SavedLook* findSavedLook(const std::vector<SavedLook>& looks, const std::string& name);

/// What a session can be read with.
inline constexpr size_t kMostLooks = 256;
/// Throws InputError where there are that many already.
void addLook(std::vector<SavedLook>& looks, SavedLook look);

/// Names, notes and lightings; what versions hold beside them stands in files whose folder matters: see
/// core/session/gallery_json.h.
[[nodiscard]] Json jsonFromSavedLooks(const std::vector<SavedLook>& looks);
/// `where` begins the messages. Throws InputError.
[[nodiscard]] std::vector<SavedLook> savedLooksFromJson(const Json& json, const std::string& where);

}  // namespace swaplight
