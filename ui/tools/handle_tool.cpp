#include "ui/tools/handle_tool.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/edit/mask/drag_shape.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/over_picture.h"
#include "ui/kit/theme.h"
#include "ui/tools/chosen_edit.h"
#include "ui/tools/pointer.h"
#include "ui/tools/stencil_tool.h"

namespace swaplight {
namespace {

using What = ShapeHandle::What;
constexpr float kReach = 11;  // pixels of the screen at scale 1
constexpr float kRadius = 5;
constexpr float kLeastHandleDrag = 1;
constexpr ImU32 kHandleShade = IM_COL32(0, 0, 0, 190);

/// The handle under the mouse, or the shape itself.
std::optional<ShapeHandle> underMouse(const EditingContext& studio, const ViewWindow& window, ImVec2 origin) {
  const MaskShape& shape = chosenEdit(studio)->mask.front();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  std::optional<ShapeHandle> found;
  float nearest = px(kReach);
  std::vector<ShapeHandle> handles = handlesOf(shape);
  for (const ShapeHandle& handle : handles) {
    const ImVec2 at = onScreen(window, origin, handle.at[0], handle.at[1]);
    const float far = std::hypot(at.x - mouse.x, at.y - mouse.y);
    if (far >= nearest) continue;
    nearest = far;
    found = handle;
  }
  if (found || studio.tool != &kStencil || chosenStencil(studio) == nullptr) return found;
  const auto box = boxOf(shape);
  if (box && box->contains(pointAtMouse(window, origin))) found = handles.back();  // the middle
  return found;
}

ImGuiMouseCursor cursorOf(What what) {
  if (what == What::TopLeft || what == What::BottomRight) return ImGuiMouseCursor_ResizeNWSE;
  if (what == What::TopRight || what == What::BottomLeft) return ImGuiMouseCursor_ResizeNESW;
  return ImGuiMouseCursor_ResizeAll;
}

void preview(EditingContext& studio, const Point& mouse) {
  const HandleState::Going& going = *studio.editing.handle.going;
  Edit edit = *going.before.edits.edits[going.edit];
  const Point to{mouse[0] - going.offset[0], mouse[1] - going.offset[1]};
  edit.mask.front() = withHandleAt(edit.mask.front(), going.what, to, ImGui::GetIO().KeyShift);
  const std::string step = (going.what == What::Middle ? "Move: " : "Reshape: ") + edit.name;
  Document next = going.before;
  next.edits.replace(going.edit, std::move(edit));
  studio.editor.preview(step, std::move(next));
}

void drawOutline(const MaskShape& shape, const ViewWindow& window, ImVec2 origin) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float thin = std::max(1.0F, px(1)), thick = px(3);
  if (const auto* line = std::get_if<LinearGradientShape>(&shape.shape)) {
    const ImVec2 from = onScreen(window, origin, line->x0, line->y0);
    const ImVec2 to = onScreen(window, origin, line->x1, line->y1);
    draw->AddLine(from, to, kHandleShade, thick);
    draw->AddLine(from, to, kText, thin);
    return;
  }
  if (const auto* ring = std::get_if<RadialGradientShape>(&shape.shape)) {
    const ImVec2 middle = onScreen(window, origin, ring->x, ring->y);
    for (const float radius : {ring->inner, ring->outer}) {
      const float shown = radius * static_cast<float>(window.zoom);
      draw->AddCircle(middle, shown, kHandleShade, 0, thick);
      draw->AddCircle(middle, shown, kText, 0, thin);
    }
  }
  const auto box = boxOf(shape);
  if (!box) return;
  const ImVec2 low = onScreen(window, origin, box->x0, box->y0);
  const ImVec2 high = onScreen(window, origin, box->x1, box->y1);
  markRect("stencil.frame", low.x, low.y, high.x, high.y);
  if (std::holds_alternative<RadialGradientShape>(shape.shape)) return;
  draw->AddRect(low, high, kHandleShade, 0, 0, thick);
  draw->AddRect(low, high, kText, 0, 0, thin);
}

void drawHandle(const ShapeHandle& handle, ImVec2 at, bool lit) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float radius = px(lit ? kRadius + 1.5F : kRadius);
  draw->AddCircleFilled(at, radius + px(1.5F), kHandleShade);
  // Dark in the middle where nothing of the edit is left: a gradient's end tells its direction.
  draw->AddCircleFilled(at, radius, lit ? kAccent : kText);
  if (handle.what == What::To || handle.what == What::Outer)
    draw->AddCircleFilled(at, radius - px(2), IM_COL32(0, 0, 0, 255));
  if (handle.what == What::Middle) {
    const float arm = radius - px(1.5F);
    draw->AddLine(ImVec2(at.x - arm, at.y), ImVec2(at.x + arm, at.y), IM_COL32(0, 0, 0, 255), px(1.2F));
    draw->AddLine(ImVec2(at.x, at.y - arm), ImVec2(at.x, at.y + arm), IM_COL32(0, 0, 0, 255), px(1.2F));
  }
  markRect({"handle.", handleName(handle.what)}, at.x - radius, at.y - radius, at.x + radius, at.y + radius);
}

}  // namespace

bool handlesShown(const EditingContext& studio) {
  const bool placing = studio.tool == &kStencil && !studio.layout.hidden;
  if (!placing && !handlesAreFree(studio)) return false;
  const Edit* edit = chosenEdit(studio);
  return edit && !edit->mask.empty() && !handlesOf(edit->mask.front()).empty();
}

namespace {

bool wantsHandles(const EditingContext& studio, const ToolInput& input) {
  return studio.editing.handle.going || (!input.alt && !input.moves && !input.grabbed);
}

/// True where the mouse is busy with a handle, or would be at a click.
bool dragHandles(EditingContext& studio, const ToolInput& input) {
  HandleState& state = studio.editing.handle;
  if (state.going) {
    ImGui::SetMouseCursor(cursorOf(state.going->what));
    // A click alone changes nothing.
    const float far = ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left];
    if (far > kLeastHandleDrag * kLeastHandleDrag) preview(studio, pointAtMouse(input.window, input.origin));
    if (!ImGui::GetIO().MouseDown[ImGuiMouseButton_Left]) state.going.reset();
    return true;
  }
  if (!input.hovered || studio.editing.dragging() || !handlesShown(studio)) return false;
  const auto under = underMouse(studio, input.window, input.origin);
  if (!under) return false;
  ImGui::SetMouseCursor(cursorOf(under->what));
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const Point mouse = pointAtMouse(input.window, input.origin);
    state.going = {studio.document(),
                   static_cast<size_t>(studio.editing.chosen),
                   under->what,
                   {mouse[0] - under->at[0], mouse[1] - under->at[1]}};
  }
  return true;
}

void drawShapeHandles(EditingContext& studio, const ViewWindow& window, ImVec2 origin) {
  if (!handlesShown(studio)) return;
  const MaskShape& shape = chosenEdit(studio)->mask.front();
  const auto& going = studio.editing.handle.going;
  std::optional<What> lit;
  if (going)
    lit = going->what;
  else if (const auto under = studio.shown.hovered ? underMouse(studio, window, origin) : std::nullopt)
    lit = under->what;
  drawOutline(shape, window, origin);
  for (const ShapeHandle& handle : handlesOf(shape))
    drawHandle(handle, onScreen(window, origin, handle.at[0], handle.at[1]), lit == handle.what);
}

}  // namespace

const PictureTool kHandleTool = {{}, wantsHandles, dragHandles, drawShapeHandles};

}  // namespace swaplight
