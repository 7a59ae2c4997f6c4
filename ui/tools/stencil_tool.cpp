#include "ui/tools/stencil_tool.h"

#include <algorithm>
#include <cmath>

#include "core/edit/mask/selection.h"
#include "ui/tools/brush_tool.h"
#include "ui/tools/pointer.h"

namespace swaplight {
namespace {

constexpr float kLeastStencil = 4;  // pixels of the screen: less places nothing

void begin(EditingContext& studio, const Point& at) {
  StencilState& state = studio.editing.stencil;
  const StencilKind& kind = kindOf(state.stencil);
  if (kind.file && state.stencil.file.empty()) {
    studio.messages.info("Choose an image first.");
    return;
  }
  if (kind.text && state.stencil.text.empty()) {
    studio.messages.info("Type the text first.");
    return;
  }
  StencilState::Going going;
  going.before = studio.document();
  going.from = at;
  going.base = brushEdit(studio);
  going.base.name += std::string(": ") + kind.info.title;
  state.going = std::move(going);
}

void show(EditingContext& studio, const Point& at) {
  const StencilState& state = studio.editing.stencil;
  const StencilState::Going& going = *state.going;
  MaskShape shape = draggedShape(state.stencil, going.from, at, ImGui::GetIO().KeyShift);
  shape.invert = state.invert;
  Edit edit = going.base;
  edit.mask = maskWithin({std::move(shape)}, going.before.selection);
  Document next = going.before;
  next.edits.append(std::move(edit));
  studio.editing.chosen = static_cast<int>(going.before.edits.edits.size());
  studio.editor.preview("Gobo: " + going.base.name, std::move(next));
}

}  // namespace

const Edit* chosenStencil(const EditingContext& studio) {
  const auto& edits = studio.document().edits.edits;
  const int chosen = studio.editing.chosen;
  if (chosen < 0 || chosen >= static_cast<int>(edits.size())) return nullptr;
  const Edit& edit = *edits[static_cast<size_t>(chosen)];
  return !edit.mask.empty() && isOfKind(edit.mask.front(), studio.editing.stencil.stencil) ? &edit : nullptr;
}

namespace {

bool wantsStencil(const EditingContext& studio, const ToolInput& input) {
  return studio.editing.stencil.going || (studio.tool == &kStencil && !input.alt && !input.moves);
}

bool handleStencil(EditingContext& studio, const ToolInput& input) {
  StencilState& state = studio.editing.stencil;
  const Point at = pointAtMouse(input.window, input.origin);
  if (input.hovered && !state.going && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    begin(studio, at);
  } else if (state.going) {
    const float far = std::hypot(at[0] - state.going->from[0], at[1] - state.going->from[1]);
    if (far * static_cast<float>(input.window.zoom) >= kLeastStencil) show(studio, at);
    if (!ImGui::GetIO().MouseDown[ImGuiMouseButton_Left]) state.going.reset();
  }
  return true;
}

}  // namespace

const PictureTool kStencilTool = {{&kStencil}, wantsStencil, handleStencil};

}  // namespace swaplight
