#pragma once

#include <filesystem>
#include <string>

#include "core/base/json_fwd.h"
#include "core/edit/stack/edit.h"
#include "core/filter/filter_pipeline.h"
#include "core/ocio/display_choice.h"

namespace swaplight {

// Parts of a session file that stand in it in several places: of the document, and of each version in its
// gallery. `folder` is what paths are relative to; an empty one leaves them absolute. `where` begins the
// messages. What reads throws InputError.

inline constexpr const char* kCameraLookKey = "camera_look";

[[nodiscard]] std::string writtenPath(const std::filesystem::path& path, const std::filesystem::path& folder);
[[nodiscard]] std::filesystem::path readPath(const std::string& text, const std::filesystem::path& folder);

/// {"on", "slope": [R, G, B], "offset", "power", "saturation"}.
[[nodiscard]] Json jsonFromGrade(const ColorGrade& grade);
[[nodiscard]] ColorGrade gradeFromJson(const Json& json, const std::string& where);

[[nodiscard]] Json jsonFromDisplay(const DisplayChoice& display);
[[nodiscard]] DisplayChoice displayFromJson(const Json& json, const std::string& where);

[[nodiscard]] Json jsonFromEdits(const EditStack& edits, const std::filesystem::path& folder);
[[nodiscard]] EditStack editsFromJson(const Json& json, const std::filesystem::path& folder,
                                      const std::string& where);

/// As a .swaplook file has it, and the folder from which its files are named.
[[nodiscard]] Json jsonFromCameraLook(const FilterPipeline& look, const std::filesystem::path& folder);
[[nodiscard]] FilterPipeline cameraLookFromJson(Json json, const std::filesystem::path& folder,
                                                const std::string& where);

}  // namespace swaplight
