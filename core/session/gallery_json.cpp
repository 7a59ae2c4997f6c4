#include "core/session/gallery_json.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/session/session_parts.h"

namespace swaplight {
namespace {

constexpr const char* kScene = "scene";
constexpr const char* kEdits = "edits";
constexpr const char* kDisplay = "display";

Json jsonFromScene(const VersionScene& scene, const std::filesystem::path& folder) {
  Json json{{kDisplay, jsonFromDisplay(scene.display)}};
  if (scene.edits != EditStack{}) json[kEdits] = jsonFromEdits(scene.edits, folder);
  if (!scene.cameraLook.stages.empty()) json[kCameraLookKey] = jsonFromCameraLook(scene.cameraLook, folder);
  return json;
}

VersionScene sceneFromJson(const Json& json, const std::filesystem::path& folder, const std::string& where) {
  JsonFields fields(json, where);
  VersionScene scene;
  if (const Json* edits = fields.find(kEdits)) scene.edits = editsFromJson(*edits, folder, where + ": edits");
  if (const Json* display = fields.find(kDisplay))
    scene.display = displayFromJson(*display, where + ": display");
  const Json* look = fields.find(kCameraLookKey);
  if (!look) return scene;
  const std::string ofLook = where + ": " + kCameraLookKey;
  const auto version = JsonFields(*look, ofLook).number("version", 1, 1e6);
  if (version.value_or(kPipelineVersion) <= kPipelineVersion)  // a newer one is kept, unread
    scene.cameraLook = cameraLookFromJson(*look, folder, ofLook);
  return scene;
}

/// What was read once is not held twice: strokes are large, and a fade need not compare them.
void shareEdits(EditStack& stack, std::vector<std::shared_ptr<const Edit>>& known) {
  for (auto& edit : stack.edits) {
    const auto same =
        std::find_if(known.begin(), known.end(), [&](const auto& other) { return *other == *edit; });
    if (same == known.end())
      known.push_back(edit);
    else
      edit = *same;
  }
}

}  // namespace

Json jsonFromGallery(const std::vector<SavedLook>& looks, const std::filesystem::path& folder) {
  Json json = jsonFromSavedLooks(looks);
  for (size_t i = 0; i < looks.size(); ++i)
    if (looks[i].scene) json[i][kScene] = jsonFromScene(*looks[i].scene, folder);
  return json;
}

std::vector<SavedLook> galleryFromJson(const Json& json, const std::filesystem::path& folder,
                                       const EditStack& edits, const std::string& where) {
  std::vector<SavedLook> looks = savedLooksFromJson(json, where);
  std::vector<std::shared_ptr<const Edit>> known = edits.edits;
  for (size_t i = 0; i < looks.size(); ++i) {
    const std::string which = fmt::format("{} {} ({})", where, i + 1, looks[i].name);
    const Json* scene = JsonFields(json[i], which).find(kScene);
    if (!scene) continue;
    looks[i].scene = sceneFromJson(*scene, folder, which);
    shareEdits(looks[i].scene->edits, known);
  }
  return looks;
}

}  // namespace swaplight
