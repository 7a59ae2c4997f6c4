#include "ui/edits/edits_actions.h"

#include "ui/tools/edit_tool.h"
#include "ui/tools/selection_tool.h"

namespace swaplight {
namespace {

void askForStencilPicture(EditingContext& studio, FileChooser& chooser) {
  chooser.ask({"A picture as a stencil",
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
  const auto hasLights = [&studio] { return studio.set() && !studio.document().rig.lights.empty(); };
  const auto selected = [&studio] { return studio.set() && !studio.document().selection.empty(); };
  actions.add({"select.take", "Select a part of the picture", "Shift+L",
               "Select by lasso, rectangle, ellipse, likeness or shadow: edits then stay inside of it.",
               [&studio] { takeEditTool(studio, Tool::Select); }, hasLights,
               [&studio] { return studio.tool == Tool::Select; }});
  actions.add({"stencil.take", "Stencils and gradients", "Shift+T",
               "Lay light on through words, shapes, a picture, or as a gradient, by dragging.",
               [&studio] { takeEditTool(studio, Tool::Stencil); }, hasLights,
               [&studio] { return studio.tool == Tool::Stencil; }});
  actions.add({"stencil.choose_picture", "Picture as a stencil \u2026", "",
               "The picture whose brightness lets the light through.",
               [&studio, &chooser] { askForStencilPicture(studio, chooser); }, hasLights});
  actions.add({"select.clear", "Select nothing", "Ctrl+D", "Edits reach everywhere again.",
               [&studio] { changeSelection(studio, "Select nothing", {}); }, selected});
  actions.add({"select.invert", "Invert the selection", "Ctrl+Shift+I", "Select what was not selected.",
               [&studio] {
                 changeSelection(studio, "Invert the selection",
                                 invertedSelection(studio.document().selection));
               },
               selected});
}

}  // namespace swaplight
