#include "ui/edits/edits_actions.h"

#include "ui/tools/selection_tool.h"

namespace swaplight {
namespace {

void askForStencilPicture(EditingContext& studio, FileChooser& chooser) {
  chooser.ask({"Choose an image for the gobo",
               "Use",
               {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr"},
               false,
               "",
               studio.document().source.parent_path(),
               [&studio](const std::filesystem::path& file) {
                 studio.editing.stencil.stencil.shape = ImageShape::info.name;
                 studio.editing.stencil.stencil.file =
                     std::filesystem::absolute(file).lexically_normal().string();
               }});
}

}  // namespace

void addSelectionActions(ActionTable& actions, EditingContext& studio, FileChooser& chooser) {
  const auto hasLights = [&studio] { return studio.hasLights(); };
  const auto selected = [&studio] { return studio.set() && !studio.document().selection.empty(); };
  actions.add({"stencil.choose_picture", "Gobo from image \u2026", "",
               "Choose an image: bright parts let the light through.",
               [&studio, &chooser] { askForStencilPicture(studio, chooser); }, hasLights});
  actions.add({"select.clear", "Deselect", "Ctrl+D", "Clear the selection; edits reach everywhere again.",
               [&studio] { changeSelection(studio, "Deselect", {}); }, selected});
  actions.add({"select.invert", "Invert selection", "Ctrl+Shift+I",
               "Select everything that was not selected.",
               [&studio] {
                 changeSelection(studio, "Invert selection", invertedSelection(studio.document().selection));
               },
               selected});
}

}  // namespace swaplight
