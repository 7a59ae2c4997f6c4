#include "ui/stencil_tool.h"

#include <algorithm>
#include <cmath>

#include "core/edit/selection.h"
#include "ui/brush_tool.h"
#include "ui/layout_probe.h"
#include "ui/theme.h"
#include "ui/viewer_mouse.h"

namespace swaplight {
namespace {

using Kind = ShapeKind::Kind;
using Point = std::array<float, 2>;

constexpr float kLeastDrag = 4;  // pixels of the screen: less places nothing

bool isInside(const PixelRect& box, const Point& at) {
  return at[0] >= static_cast<float>(box.x) && at[0] < static_cast<float>(box.right()) &&
         at[1] >= static_cast<float>(box.y) && at[1] < static_cast<float>(box.bottom());
}

const char* wordOf(Kind kind) {
  constexpr const char* kWords[] = {"text",    "ellipse",  "rectangle",     "pattern",
                                    "picture", "gradient", "round gradient"};
  return kWords[static_cast<size_t>(kind)];
}

void begin(StudioContext& studio, const Point& at) {
  StencilState& state = studio.editing.stencil;
  if (state.kind.kind == Kind::Picture && state.kind.file.empty()) {
    studio.messages.info("Choose the picture first.");
    return;
  }
  if (state.kind.kind == Kind::Text && state.kind.text.empty()) {
    studio.messages.info("Type the words first.");
    return;
  }
  StencilState::Going going;
  going.before = studio.document();
  going.from = at;
  const Edit* chosen = chosenStencil(studio);
  if (chosen && isInside(boxOf(chosen->mask.front()), at)) {
    going.moves = true;
    going.edit = static_cast<size_t>(studio.editing.chosen);
    going.base = *chosen;
  } else {
    going.edit = going.before.edits.edits.size();
    going.base = brushEdit(studio);
    going.base.name += std::string(": ") + wordOf(state.kind.kind);
  }
  state.going = std::move(going);
}

void show(StudioContext& studio, const Point& at) {
  const StencilState& state = studio.editing.stencil;
  const StencilState::Going& going = *state.going;
  Edit edit = going.base;
  if (going.moves) {
    edit.mask.front() = movedShape(edit.mask.front(), at[0] - going.from[0], at[1] - going.from[1]);
  } else {
    MaskShape shape = draggedShape(state.kind, going.from, at, ImGui::GetIO().KeyShift);
    shape.invert = state.invert;
    edit.mask = maskWithin({std::move(shape)}, going.before.selection);
  }
  Document next = going.before;
  if (going.edit < next.edits.edits.size())
    next.edits.replace(going.edit, std::move(edit));
  else
    next.edits.append(std::move(edit));
  studio.editing.chosen = static_cast<int>(going.edit);
  studio.editor.preview((going.moves ? "Move: " : "Stencil: ") + going.base.name, std::move(next));
}

}  // namespace

const Edit* chosenStencil(const StudioContext& studio) {
  const auto& edits = studio.document().edits.edits;
  const int chosen = studio.editing.chosen;
  if (chosen < 0 || chosen >= static_cast<int>(edits.size())) return nullptr;
  const Edit& edit = *edits[static_cast<size_t>(chosen)];
  return !edit.mask.empty() && isOfKind(edit.mask.front(), studio.editing.stencil.kind.kind) ? &edit
                                                                                             : nullptr;
}

void handleStencil(StudioContext& studio, const ViewWindow& window, ImVec2 origin) {
  StencilState& state = studio.editing.stencil;
  const bool hovered = ImGui::IsItemHovered();
  const Point at = pointAtMouse(window, origin);
  if (hovered && !state.going && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    begin(studio, at);
  } else if (state.going) {
    const float far = std::hypot(at[0] - state.going->from[0], at[1] - state.going->from[1]);
    if (far * static_cast<float>(window.zoom) >= kLeastDrag) show(studio, at);
    if (!ImGui::GetIO().MouseDown[ImGuiMouseButton_Left]) state.going.reset();
  }
  if (hovered) {
    const Edit* chosen = chosenStencil(studio);
    const bool over = chosen && isInside(boxOf(chosen->mask.front()), at);
    ImGui::SetMouseCursor(over ? ImGuiMouseCursor_ResizeAll : ImGuiMouseCursor_Arrow);
  }
}

void drawStencilFrame(StudioContext& studio, const ViewWindow& window, ImVec2 origin) {
  const Edit* chosen = chosenStencil(studio);
  if (!chosen) return;
  const auto at = [&](float x, float y) {
    return ImVec2(origin.x + static_cast<float>(window.windowX(x)),
                  origin.y + static_cast<float>(window.windowY(y)));
  };
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const MaskShape& shape = chosen->mask.front();
  if (const auto* line = std::get_if<LinearGradientShape>(&shape.shape)) {
    const ImVec2 from = at(line->x0, line->y0), to = at(line->x1, line->y1);
    draw->AddLine(from, to, IM_COL32(0, 0, 0, 180), px(3));
    draw->AddLine(from, to, kText, px(1));
    draw->AddCircleFilled(from, px(5), kText);
    draw->AddCircleFilled(to, px(5), IM_COL32(0, 0, 0, 255));
    draw->AddCircle(to, px(5), kText);
    return;
  }
  const PixelRect box = boxOf(shape);
  if (box.empty()) return;
  const ImVec2 low = at(static_cast<float>(box.x), static_cast<float>(box.y));
  const ImVec2 high = at(static_cast<float>(box.right()), static_cast<float>(box.bottom()));
  draw->AddRect(low, high, IM_COL32(0, 0, 0, 180), 0, 0, px(3));
  draw->AddRect(low, high, kText, 0, 0, std::max(1.0F, px(1)));
  markRect("stencil.frame", low.x, low.y, high.x, high.y);
}

}  // namespace swaplight
