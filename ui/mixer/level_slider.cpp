#include "ui/mixer/level_slider.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/kit/theme.h"

namespace swaplight {
namespace {

constexpr float kStep = 0.1F;  // stops
constexpr float kFine = 0.1F;  // of a step or a movement, with Shift
constexpr float kInset = 5, kHalfGrab = 4;
constexpr float kMiddle = 0.4F;  // of a stop that a straight slider would have there
constexpr int kRounds = 8;
constexpr float kMarks[] = {1, 2, 3, 6};  // stops, on either side

/// The ground of a slider: where its stops lie on the screen. Around 0, where lights are balanced, a pixel is
/// two and a half times as fine as if all pixels were alike; at the ends it is coarser.
struct Track {
  float left, right, range;

  /// -1 .. 1 on the slider; the ends' slope goes on beyond them.
  [[nodiscard]] float stopsAt(float place) const {
    const float inside = std::clamp(place, -1.0F, 1.0F);
    return range *
           (inside * (kMiddle + (1 - kMiddle) * inside * inside) + (3 - 2 * kMiddle) * (place - inside));
  }
  [[nodiscard]] float placeOf(float stops) const {
    const float part = stops / range;
    if (std::abs(part) > 1) return std::copysign(1 + (std::abs(part) - 1) / (3 - 2 * kMiddle), part);
    float place = std::cbrt(part);  // Newton: convex on either side of 0, so that it comes from beyond
    for (int round = 0; round < kRounds; ++round)
      place -= (place * (kMiddle + (1 - kMiddle) * place * place) - part) /
               (kMiddle + 3 * (1 - kMiddle) * place * place);
    return place;
  }
  [[nodiscard]] float x(float stops) const {
    return left + (right - left) * std::clamp(0.5F + 0.5F * placeOf(stops), 0.0F, 1.0F);
  }
  [[nodiscard]] float placeAt(float x) const { return 2 * (x - left) / (right - left) - 1; }
};

/// Where a drag has come to, also beyond the slider's ends: what comes back from there has the same way.
float dragged(ImGuiID id, const Track& track, float stops) {
  const ImGuiIO& io = ImGui::GetIO();
  ImGuiStorage* memory = ImGui::GetStateStorage();
  float place = memory->GetFloat(id, track.placeOf(stops));
  if (ImGui::IsItemActivated()) {
    const bool onHandle = std::abs(io.MousePos.x - track.x(stops)) <= px(kHalfGrab);
    place = onHandle || io.KeyShift ? track.placeOf(stops) : track.placeAt(io.MousePos.x);
    if (onHandle || io.KeyShift) return memory->SetFloat(id, place), stops;
  } else if (io.MouseDelta.x == 0) {
    return stops;  // what is held still keeps its level to the bit
  } else {
    place += 2 * io.MouseDelta.x / (track.right - track.left) * (io.KeyShift ? kFine : 1);
  }
  memory->SetFloat(id, place);
  return track.stopsAt(place);
}

/// Steps of the wheel and the arrow keys over it.
float steps(ImGuiID id) {
  const ImGuiContext& g = *GImGui;
  float count = 0;
  // A list that is being scrolled goes on when a slider comes under the mouse.
  if (!g.WheelingWindow) {
    ImGui::SetItemUsingMouseWheel();
    if (g.HoveredIdPreviousFrame == id) count += g.IO.MouseWheel;
  }
  if (g.IO.WantTextInput) return count;
  const auto pressed = [](ImGuiKey key) {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)) ? 1.0F : 0.0F;
  };
  return count + pressed(ImGuiKey_RightArrow) + pressed(ImGuiKey_UpArrow) - pressed(ImGuiKey_LeftArrow) -
         pressed(ImGuiKey_DownArrow);
}

void drawSlider(const Track& track, ImVec2 low, ImVec2 high, float stops) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float middle = track.x(0), x = track.x(stops);
  draw->AddRectFilled(low, high,
                      ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                      px(4));
  draw->AddRectFilled(ImVec2(std::min(middle, x), low.y), ImVec2(std::max(middle, x), high.y),
                      ImGui::GetColorU32(IM_COL32(96, 152, 224, 70)));
  draw->AddLine(ImVec2(middle, low.y + px(3)), ImVec2(middle, high.y - px(3)), ImGui::GetColorU32(kFaint),
                px(1));
  for (const float mark : kMarks)
    for (const float side : {-mark, mark})
      if (mark < track.range)
        draw->AddLine(ImVec2(track.x(side), high.y - px(6)), ImVec2(track.x(side), high.y - px(3)),
                      ImGui::GetColorU32(IM_COL32(120, 120, 120, 255)), px(1));
  const ImVec2 grabLow(x - px(kHalfGrab), low.y + px(1)), grabHigh(x + px(kHalfGrab), high.y - px(1));
  const ImU32 grab = ImGui::IsItemActive() ? kAccent : IM_COL32(214, 214, 214, 255);
  draw->AddRectFilled(grabLow, grabHigh, ImGui::GetColorU32(grab), px(3));
  draw->AddRect(grabLow, grabHigh, IM_COL32(0, 0, 0, 140), px(3));
}

}  // namespace

LevelSliding levelSlider(const char* id, float* stops, float range, float width) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + width, low.y + ImGui::GetFrameHeight());
  const Track track{low.x + px(kInset), high.x - px(kInset), range};
  ImGui::InvisibleButton(id, ImVec2(width, high.y - low.y));
  const ImGuiID item = ImGui::GetItemID();
  LevelSliding done;
  done.hovered = ImGui::IsItemHovered();
  const float before = *stops;
  // A level from elsewhere that lies beyond the slider stays as it is until the slider is moved.
  const auto take = [&](float to) { *stops = std::clamp(to, -range, range); };
  const bool clicked = done.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  done.toType = clicked && ImGui::GetIO().KeyCtrl;
  const bool resets = clicked && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (resets) *stops = 0;
  if (done.toType || resets)
    ImGui::GetStateStorage()->SetFloat(item, track.placeOf(*stops));  // from where a drag would go on
  else if (ImGui::IsItemActive())
    take(dragged(item, track, *stops));
  else if (const float count = done.hovered ? steps(item) : 0; count != 0) {
    take(*stops + count * kStep * (ImGui::GetIO().KeyShift ? kFine : 1));
    done.nudged = true;
  }
  done.changed = *stops != before;
  drawSlider(track, low, high, *stops);
  return done;
}

void keepNudges(MixerState& mixer, const std::string& row, const LevelSliding& sliding) {
  if (sliding.nudged) mixer.nudged = row;
  if (mixer.nudged != row) return;
  mixer.nudging = sliding.hovered;
  if (!sliding.hovered) mixer.nudged.clear();
}

}  // namespace swaplight
