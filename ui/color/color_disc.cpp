#include "ui/color/color_disc.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include "core/color/hsv.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

const float kTurn = glm::two_pi<float>();
constexpr float kFine = 0.1F;
constexpr float kHandle = 6;  // radius
constexpr float kWhite = 3;   // around the middle: exact white, which nobody hits otherwise

/// Every sixth of a turn one channel goes straight from 0 to 1, and so do the corners of these triangles:
/// what is drawn is exact, but for the rim being a polygon.
constexpr int kSegments = 96;

glm::vec2 vec(const ImVec2& at) {
  return {at.x, at.y};
}

ImVec2 imVec(const glm::vec2& at) {
  return {at.x, at.y};
}

struct Disc {
  glm::vec2 middle;
  float radius;

  [[nodiscard]] glm::vec2 placeOf(const Rgb& hsv) const {
    return middle + hsv.y * radius * glm::vec2(std::cos(kTurn * hsv.x), std::sin(kTurn * hsv.x));
  }
  [[nodiscard]] bool holds(const glm::vec2& place) const {
    return glm::distance(place, middle) <= radius + px(kHandle);
  }
  /// The hue and saturation of a place. Beyond the rim they are those of the rim.
  void take(const glm::vec2& place, Rgb& hsv) const {
    const glm::vec2 from = place - middle;
    const float away = glm::length(from);
    hsv.y = away < px(kWhite) ? 0 : std::min(away / radius, 1.0F);
    if (hsv.y == 0) return;  // the hue stays as it was
    const float turn = std::atan2(from.y, from.x) / kTurn;
    hsv.x = turn < 0 ? turn + 1 : turn;
  }
};

void draw(const Disc& disc) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
  list->PrimReserve(3 * kSegments, kSegments + 1);
  const auto first = static_cast<ImDrawIdx>(list->_VtxCurrentIdx);
  list->PrimWriteVtx(imVec(disc.middle), uv, IM_COL32_WHITE);
  for (int i = 0; i < kSegments; ++i) {
    const float hue = static_cast<float>(i) / kSegments;
    list->PrimWriteVtx(imVec(disc.placeOf(Rgb(hue, 1, 1))), uv, colorU32(rgbFromHsv(Rgb(hue, 1, 1))));
    list->PrimWriteIdx(first);
    list->PrimWriteIdx(static_cast<ImDrawIdx>(first + 1 + i));
    list->PrimWriteIdx(static_cast<ImDrawIdx>(first + 1 + (i + 1) % kSegments));
  }
  list->AddCircle(imVec(disc.middle), disc.radius, IM_COL32(0, 0, 0, 170), kSegments, px(1.5F));
}

void drawHandle(const ImVec2& at, const Rgb& hsv, bool held) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float radius = px(held ? kHandle + 1.5F : kHandle);
  list->AddCircleFilled(at, radius, colorU32(rgbFromHsv(hsv)));
  list->AddCircle(at, radius, IM_COL32_WHITE, 0, px(2));
  list->AddCircle(at, radius + px(1.5F), IM_COL32(0, 0, 0, 200), 0, px(1));
}

/// Whether the mouse, which holds the item, has taken another place.
bool drag(const Disc& disc, Rgb& hsv) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!disc.holds(vec(io.MouseClickedPos[0]))) return false;
  const glm::vec2 move = vec(io.MouseDelta);
  if (move == glm::vec2(0) && !ImGui::IsItemActivated()) return false;
  const Rgb before = hsv;
  disc.take(io.KeyShift ? disc.placeOf(hsv) + kFine * move : vec(io.MousePos), hsv);
  if (hsv.z == 0) hsv.z = 1;
  return hsv != before;
}

}  // namespace

bool colorDisc(const char* id, Rgb& hsv, float side) {
  const glm::vec2 at = vec(ImGui::GetCursorScreenPos());
  ImGui::InvisibleButton(id, ImVec2(side, side));
  const Disc disc{at + side / 2, side / 2 - px(kHandle + 2)};
  const bool held = ImGui::IsItemActive();
  const bool changed = held && drag(disc, hsv);
  draw(disc);
  drawHandle(imVec(disc.placeOf(hsv)), hsv, held);
  return changed;
}

}  // namespace swaplight
