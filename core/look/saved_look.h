#pragma once

#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/relight/rig.h"

namespace swaplight {

/// A lighting that a person has kept: of the gallery, saved in the session. Its picture is made again from
/// the set whenever it is shown.
struct SavedLook {
  std::string name;  ///< one of its kind in a session
  std::string note;
  Rig rig;
  bool operator==(const SavedLook&) const = default;
};

/// The first of "Look 1", "Look 2" ... that is free.
[[nodiscard]] std::string freeLookName(const std::vector<SavedLook>& looks);
/// The look of this name (see sameLookName), or nullptr.
[[nodiscard]] const SavedLook* findSavedLook(const std::vector<SavedLook>& looks, const std::string& name);

[[nodiscard]] Json jsonFromSavedLooks(const std::vector<SavedLook>& looks);
/// `where` begins the messages. Throws InputError.
[[nodiscard]] std::vector<SavedLook> savedLooksFromJson(const Json& json, const std::string& where);

}  // namespace swaplight
