#include "ui/tools/lamp_tool.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/edit/pool/lamp_gain.h"
#include "core/edit/pool/lamp_handle.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/over_picture.h"
#include "ui/kit/theme.h"
#include "ui/tools/chosen_edit.h"
#include "ui/tools/pointer.h"

namespace swaplight {
namespace {

constexpr float kLampReach = 14;  // pixels of the screen at scale 1
constexpr float kLampRadius = 11;
constexpr float kLeastLampDrag = 1;
constexpr float kCatchUp = 90;  // of a drag from the edge inwards, until the light's middle is at the hand
constexpr ImU32 kLampShade = IM_COL32(0, 0, 0, 190);
constexpr ImU32 kGuessInk = IM_COL32(240, 160, 64, 200);

bool isDragged(const Operation& operation) {
  return std::visit([]<typename T>(const T&) { return DraggedOperation<T>; }, operation);
}

bool isHeldByRing(const Operation& operation) {
  return std::visit([]<typename T>(const T&) { return RingOperation<T>; }, operation);
}

/// Of a lamp that is placed nothing is held but its direction.
LampInHand heldLamp(const PreparedEdit& prepared) {
  if (prepared.lamps.empty()) return {};
  return {prepared.lamps[0].pool->lamp, prepared.lamps[0].pool->width};
}

/// The chosen edit as it runs, or as it ran a moment ago, where it drags one light's lamp; nullptr: there is
/// nothing to drag.
const PreparedEdit* lampInHand(EditingContext& studio) {
  const Edit* edit = chosenEdit(studio);
  if (!handlesAreFree(studio) || !edit || !edit->on || !isDragged(edit->operation)) return nullptr;
  std::shared_ptr<const PreparedEdit>& shown = studio.editing.lamp.shown;
  if (auto now = studio.edits.prepared(*edit))
    shown = std::move(now);
  else if (!studio.editing.lamp.going && !studio.edits.busy())
    shown.reset();  // it cannot run
  const bool same = shown && shown->edit->lights == edit->lights &&
                    shown->edit->operation.index() == edit->operation.index();
  const bool one = same && (shown->placed.size() == 1 || (shown->lamps.size() == 1 && shown->lamps[0].pool));
  return one ? shown.get() : nullptr;
}

/// Places of the plane that stands for the set, as points of the picture, and back.
class LampView {
 public:
  LampView(const EditingContext& studio, const ViewWindow& window, ImVec2 origin)
      : m_width(studio.set()->original->width()),
        m_height(studio.set()->original->height()),
        m_window(window),
        m_origin(origin) {}
  [[nodiscard]] ImVec2 shown(const PlanePoint& at) const {
    return onScreen(m_window, m_origin, (at.x + .5) * m_width, .5 * m_height - at.y * m_width);
  }
  [[nodiscard]] PlanePoint onPlane(const std::array<float, 2>& pixel) const {
    return {pixel[0] / m_width - .5, (.5 * m_height - pixel[1]) / m_width};
  }
  /// The pixel of the picture at a point of the screen.
  [[nodiscard]] int column(float x) const {
    return static_cast<int>(std::floor(m_window.pictureX(double{x} - m_origin.x)));
  }
  [[nodiscard]] int row(float y) const {
    return static_cast<int>(std::floor(m_window.pictureY(double{y} - m_origin.y)));
  }
  [[nodiscard]] bool inPicture(int x, int y) const { return x >= 0 && y >= 0 && x < m_width && y < m_height; }

 private:
  int m_width, m_height;
  const ViewWindow& m_window;
  ImVec2 m_origin;
};

/// Where the lamp is held.
PlanePoint handleNow(const EditingContext& studio, const PreparedEdit& prepared) {
  return std::visit(
      [&]<typename T>(const T& operation) -> PlanePoint {
        if constexpr (DraggedOperation<T>) return operation.handle(heldLamp(prepared));
        return {};
      },
      chosenEdit(studio)->operation);
}

/// The middle of what the lamp lit as the set was photographed, on the screen.
ImVec2 middleOfPool(const PreparedEdit& prepared, const LampView& view) {
  const cv::Vec3d aim = heldLamp(prepared).lamp.aim;
  return view.shown({aim[0], aim[1]});
}

/// Where a handle is drawn: in its place, or, where that is out of the viewer, at the viewer's edge on the
/// way there from the middle of what the lamp lit.
ImVec2 withinViewer(ImVec2 middle, ImVec2 place, const ViewWindow& window, ImVec2 origin) {
  const float margin = px(kLampRadius + 3);
  const ImVec2 low(origin.x + margin, origin.y + margin);
  const ImVec2 high(std::max(low.x, origin.x + static_cast<float>(window.width) - margin),
                    std::max(low.y, origin.y + static_cast<float>(window.height) - margin));
  const auto partOfWay = [](float from, float to, float least, float most) {
    if (to < least && from > least) return (from - least) / (from - to);
    if (to > most && from < most) return (most - from) / (to - from);
    return 1.F;
  };
  const float part =
      std::min(partOfWay(middle.x, place.x, low.x, high.x), partOfWay(middle.y, place.y, low.y, high.y));
  return {std::clamp(middle.x + part * (place.x - middle.x), low.x, high.x),
          std::clamp(middle.y + part * (place.y - middle.y), low.y, high.y)};
}

/// Where a drag has brought the light's middle, pixels of the picture. A handle that waited at the edge is
/// not torn to the hand from far outside: it catches up while the hand goes inwards.
std::array<float, 2> draggedTo(const LampHandleState::Going& going, const std::array<float, 2>& mouse,
                               double zoom) {
  const std::array<float, 2> hand{mouse[0] - going.offset[0], mouse[1] - going.offset[1]};
  const float far = std::hypot(going.beyond[0], going.beyond[1]);
  if (far == 0) return hand;
  const float inward =
      ((going.shown[0] - hand[0]) * going.beyond[0] + (going.shown[1] - hand[1]) * going.beyond[1]) / far *
      static_cast<float>(zoom);
  const float left = std::clamp(1 - inward / px(kCatchUp), 0.F, 1.F);
  return {hand[0] + left * left * going.beyond[0], hand[1] + left * left * going.beyond[1]};
}

void previewLamp(EditingContext& studio, const PreparedEdit& prepared, const PlanePoint& to) {
  const LampHandleState::Going& going = *studio.editing.lamp.going;
  Edit edit = *going.before.edits.edits[going.edit];
  std::visit(
      [&]<typename T>(T& operation) {
        if constexpr (DraggedOperation<T>) operation.dragTo(heldLamp(prepared), to);
      },
      edit.operation);
  const std::string name = edit.name.empty() ? operationName(edit.operation) : edit.name;
  Document next = going.before;
  next.edits.replace(going.edit, std::move(edit));
  studio.editor.preview(name + ": dragged", std::move(next));
}

bool underMouse(ImVec2 handle) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return std::hypot(handle.x - mouse.x, handle.y - mouse.y) < px(kLampReach);
}

bool wantsLamp(const EditingContext& studio, const ToolInput& input) {
  return studio.editing.lamp.going || (!input.alt && !input.moves && !input.grabbed);
}

/// True where the mouse is busy with the lamp, or would be at a click.
bool dragLamp(EditingContext& studio, const ToolInput& input) {
  LampHandleState& state = studio.editing.lamp;
  const PreparedEdit* prepared = lampInHand(studio);
  if (!prepared) {
    state.going.reset();
    return false;
  }
  const LampView view(studio, input.window, input.origin);
  const std::array<float, 2> mouse = pointAtMouse(input.window, input.origin);
  if (state.going) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    const float far = ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left];
    if (far > kLeastLampDrag * kLeastLampDrag)
      previewLamp(studio, *prepared, view.onPlane(draggedTo(*state.going, mouse, input.window.zoom)));
    if (!ImGui::GetIO().MouseDown[ImGuiMouseButton_Left]) state.going.reset();
    return true;
  }
  if (!input.hovered || studio.editing.dragging()) return false;
  const ImVec2 place = view.shown(handleNow(studio, *prepared));
  const ImVec2 handle = withinViewer(middleOfPool(*prepared, view), place, input.window, input.origin);
  if (!underMouse(handle)) return false;
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const float x = static_cast<float>(input.window.pictureX(double{handle.x} - input.origin.x));
    const float y = static_cast<float>(input.window.pictureY(double{handle.y} - input.origin.y));
    const auto zoom = static_cast<float>(input.window.zoom);
    state.going = {studio.document(),
                   static_cast<size_t>(studio.editing.chosen),
                   {x, y},
                   {mouse[0] - x, mouse[1] - y},
                   {(place.x - handle.x) / zoom, (place.y - handle.y) / zoom}};
  }
  return true;
}

void hatchGuesses(const PreparedEdit& prepared, const LampView& view, const ViewWindow& window,
                  ImVec2 origin) {
  const LampGain* gain = prepared.lamps.empty() ? nullptr : prepared.lamps[0].gain.get();
  if (!gain && prepared.placed.empty()) return;
  const auto isGuess = [&](int column, int row) {
    return gain ? gain->guessAt(column, row) >= .5F : prepared.placed[0].guessAt(column, row);
  };
  const auto guessed = [&](float x, float y) {
    const int column = view.column(x);
    const int row = view.row(y);
    if (!view.inPicture(column, row) || !isGuess(column, row)) return false;
    float mask = 0;
    prepared.mask->row(column, row, 1, &mask);
    return mask >= .5F;
  };
  drawHatch(origin,
            ImVec2(origin.x + static_cast<float>(window.width), origin.y + static_cast<float>(window.height)),
            kGuessInk, guessed);
}

void drawLamp(EditingContext& studio, const ViewWindow& window, ImVec2 origin) {
  const PreparedEdit* prepared = lampInHand(studio);
  if (!prepared) return;
  const LampView view(studio, window, origin);
  hatchGuesses(*prepared, view, window, origin);
  const ImVec2 from = middleOfPool(*prepared, view);
  const ImVec2 place = view.shown(handleNow(studio, *prepared));
  const ImVec2 to = withinViewer(from, place, window, origin);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float radius = px(kLampRadius);
  if (isHeldByRing(chosenEdit(studio)->operation)) {
    const float around = std::hypot(place.x - from.x, place.y - from.y);
    draw->AddCircle(from, around, kLampShade, 0, px(3));
    draw->AddCircle(from, around, kText, 0, std::max(1.F, px(1)));
    markRect("lamp.middle", from.x - 1, from.y - 1, from.x + 1, from.y + 1);
  } else if (std::hypot(to.x - from.x, to.y - from.y) > radius) {
    draw->AddLine(from, to, kLampShade, px(3));
    draw->AddLine(from, to, kText, std::max(1.F, px(1)));
    draw->AddCircle(from, px(4), kLampShade, 0, px(3));
    draw->AddCircle(from, px(4), kText, 0, std::max(1.F, px(1)));
  }
  const bool lit = studio.editing.lamp.going || (studio.shown.hovered && underMouse(to));
  draw->AddCircleFilled(to, radius + px(1.5F), kLampShade);
  draw->AddCircle(to, radius, lit ? kAccent : kText, 0, px(1.5F));
  const ImVec2 size = ImGui::CalcTextSize(kIconLight);
  draw->AddText(ImVec2(to.x - size.x / 2, to.y - size.y / 2), lit ? kAccent : kText, kIconLight);
  markRect("lamp.handle", to.x - radius, to.y - radius, to.x + radius, to.y + radius);
}

}  // namespace

const PictureTool kLampTool = {{}, wantsLamp, dragLamp, drawLamp};

}  // namespace swaplight
