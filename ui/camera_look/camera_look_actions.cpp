#include "ui/camera_look/camera_look_actions.h"

#include "core/base/error.h"
#include "core/file/user_folders.h"
#include "core/filter/filter_names.h"
#include "ui/camera/camera_look_edit.h"
#include "ui/camera_look/filter_list.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

/// Where a look is listed by its name.
fs::path ownLooks() {
  const fs::path folder = dataFolder() / "camera-looks";
  std::error_code error;
  fs::create_directories(folder, error);
  return folder;
}

void saveLook(ViewerContext& studio, const fs::path& file) try {
  FilterPipeline look = standalone(studio.document().cameraLook, studio.seen.library());
  look.name = file.stem().string();
  writePipeline(look, file);
  studio.shelf.readAgain();
  studio.messages.info("Saved " + file.string());
  if (look.name == studio.document().cameraLook.name) return;
  useCameraLook(studio.editor, std::move(look));
} catch (const std::exception& error) {
  studio.messages.error(error.what());
}

}  // namespace

void loadCameraLook(ViewerContext& studio, const fs::path& file) {
  try {
    useCameraLook(studio.editor, standalone(readPipeline(fs::absolute(file)), studio.seen.library()));
    studio.cameraLook.chosen = -1;
    studio.layout.cameraLook = true;
  } catch (const InputError& error) {
    studio.messages.error(error.what());
  }
}

bool takeDroppedLook(ViewerContext& studio, const fs::path& file) {
  const bool filter = isFilterFile(file);
  if (!studio.set() || (!filter && !isLookFile(file))) return false;
  if (!filter) {
    loadCameraLook(studio, file);
    return true;
  }
  try {
    const fs::path whole = fs::absolute(file);
    studio.seen.library().load(whole);  // says what is wrong with it
    addToLook(studio, whole.string());
    studio.layout.cameraLook = true;
  } catch (const InputError& error) {
    studio.messages.error(error.what());
  }
  return true;
}

void addCameraLookActions(ActionTable& actions, ViewerContext& studio, FileChooser& chooser) {
  const auto open = [&studio] { return studio.set() != nullptr; };
  const auto has = [&studio] { return studio.set() && !studio.document().cameraLook.stages.empty(); };
  actions.add(
      {"camera_look.load", "Load a camera look \u2026", "", "See the picture through a .swaplook file.",
       [&studio, &chooser] {
         chooser.ask(
             {"A camera look", "Load", {kLookEnding}, false, "", ownLooks(), [&studio](const fs::path& file) {
                loadCameraLook(studio, file);
              }});
       },
       open});
  actions.add({"camera_look.save", "Save the camera look \u2026", "",
               "Write the filters to a .swaplook file; in the folder suggested it is listed by its name.",
               [&studio, &chooser] {
                 chooser.ask({"Save the camera look",
                              "Save",
                              {kLookEnding},
                              true,
                              studio.document().cameraLook.name + kLookEnding,
                              ownLooks(),
                              [&studio](const fs::path& file) { saveLook(studio, file); }});
               },
               has});
  actions.add({"camera_look.remove", "Remove the camera look", "",
               "See the plain picture. Undo brings the filters back.",
               [&studio] {
                 removeCameraLook(studio.editor);
                 studio.cameraLook.chosen = -1;
               },
               has});
}

}  // namespace swaplight
