#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/look/saved_look.h"

namespace swaplight {

/// The gallery as a session holds it under "looks". A version is a look with a "scene": its "edits",
/// "display" and "camera_look", which a program that knows looks only passes over and keeps.
[[nodiscard]] Json jsonFromGallery(const std::vector<SavedLook>& looks, const std::filesystem::path& folder);

/// Edits that a version has in common with the session (`edits`) or another version are shared with it.
/// `where` begins the messages. Throws InputError.
[[nodiscard]] std::vector<SavedLook> galleryFromJson(const Json& json, const std::filesystem::path& folder,
                                                     const EditStack& edits, const std::string& where);

}  // namespace swaplight
