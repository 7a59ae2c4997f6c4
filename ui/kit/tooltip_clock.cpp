#include "ui/kit/tooltip_clock.h"

#include <imgui_internal.h>

#include <limits>

namespace swaplight {
namespace {

constexpr double kDelay = 0.5;      // seconds
constexpr double kAMoment = 0.001;  // a timer must not end before what it waits for

struct Clock {
  ImGuiID item = 0;
  double since = 0;  ///< when the mouse came to rest over it, in Dear ImGui's time
  bool shown = false;
  bool clicked = false;
};

Clock& clock() {
  static Clock instance;  // one interface, as Dear ImGui has it
  return instance;
}

}  // namespace

void tooltipClockFrame() {
  const ImGuiContext& g = *GImGui;
  Clock& now = clock();
  const bool moved = g.IO.MouseDelta.x != 0 || g.IO.MouseDelta.y != 0;
  const bool other = g.HoveredIdPreviousFrame != now.item;
  // Text has no number of its own: there every movement may lead to another one.
  const bool elsewhere = other || (moved && (!now.shown || now.item == 0));
  if (elsewhere) now = {g.HoveredIdPreviousFrame, g.Time, false, now.clicked && !other && now.item != 0};
  if (ImGui::IsAnyMouseDown()) now.clicked = true;
  now.shown = !now.clicked && g.Time - now.since >= kDelay;
}

bool tooltipDue() {
  return clock().shown;
}

double secondsToTooltip() {
  const Clock& now = clock();
  if (now.shown || now.clicked || !ImGui::IsMousePosValid()) return std::numeric_limits<double>::infinity();
  return now.since + kDelay - ImGui::GetTime() + kAMoment;
}

}  // namespace swaplight
