#include "ui/dialogs/tour.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kTourWidth = 330, kTourHeight = 170, kTourGap = 14;

struct TourStep {
  /// What it is about, by its name in layout_probe.h; "LIGHT" stands for the first light's.
  const char* item;
  const char* title;
  const char* words;
};
constexpr std::array<TourStep, 5> kTourSteps = {{
    {"mixer.LIGHT.stops", "Every row is a lamp of the set",
     "Drag its slider: that lamp alone gets brighter or darker, as if it had been dimmed on the set. M mutes "
     "it, S shows it alone. Double-click the number to type 50% or -1st."},
    {"light.disc", "Its colour",
     "Drag in the disc, or give it a white below, say 3200 K, or a gel by its number. The field with the # "
     "takes words: 3200K, L201, +1st."},
    {"viewer.picture", "Look closely",
     "The wheel zooms, a drag pans, F fits. Hold Q and point: which light is this? O shows the photograph as "
     "it was taken, W wipes between two lightings."},
    {"button.brush.take", "Paint with light",
     "Shift+B paints with a lamp. F3 finds its shadows, to lighten or soften them; F4 lists every edit, each "
     "of which can be changed or switched off again. Ctrl+Z takes back anything."},
    {"menu.File", "Keep it, and take it along",
     "Shift+K keeps the lighting in the gallery (F8), Ctrl+S saves everything as a session, Ctrl+E exports "
     "the frame: EXR in light, or PNG as you see it."},
}};

std::optional<ItemRect> placeOf(const TourStep& step, const std::string& light) {
  std::string item = step.item;
  if (const size_t at = item.find("LIGHT"); at != std::string::npos) item.replace(at, 5, light);
  return itemRect(item);
}

/// Beside the thing; below what is at the top; inside of what is large; in the middle where it is not on the
/// screen.
ImVec2 cardCorner(const std::optional<ItemRect>& about, ImVec2 screen) {
  const float width = px(kTourWidth), gap = px(kTourGap);
  const float lowest = screen.y - px(kTourHeight) - gap;
  if (!about) return {(screen.x - width) / 2, lowest / 2};
  if (about->x1 - about->x0 > screen.x / 3)
    return {(about->x0 + about->x1 - width) / 2, std::clamp(about->y1 - px(kTourHeight) - gap, gap, lowest)};
  if (about->y0 < px(kTourGap)) return {about->x0 + gap, about->y1 + gap};
  const bool right = about->x0 > screen.x / 2;
  return {right ? about->x0 - width - gap : std::min(about->x1 + gap, screen.x - width - gap),
          std::clamp(about->y0, gap, lowest)};
}

void frameIt(const ItemRect& about) {
  const float rim = px(3);
  ImGui::GetForegroundDrawList()->AddRect(ImVec2(about.x0 - rim, about.y0 - rim),
                                          ImVec2(about.x1 + rim, about.y1 + rim), kAccent, px(5), 0, px(2));
}

bool isElsewhere(const ItemRect& a, const ItemRect& b) {
  return a.x0 != b.x0 || a.y0 != b.y0 || a.x1 != b.x1 || a.y1 != b.y1;
}

}  // namespace

void Tour::start() {
  m_step = 0;
  rememberLayout();
}

bool Tour::draw(const std::string& light) {
  markState("tour", m_step ? std::to_string(*m_step + 1) : "");
  if (!m_step || light.empty()) return false;
  const TourStep& step = kTourSteps[*m_step];
  const std::optional<ItemRect> about = placeOf(step, light);
  if (about) frameIt(*about);
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  ImGui::SetNextWindowPos(cardCorner(about, ImGui::GetIO().DisplaySize));
  ImGui::SetNextWindowSize(ImVec2(px(kTourWidth), 0));
  ImGui::PushStyleColor(ImGuiCol_Border, kAccent);
  if (ImGui::Begin("##tour", nullptr, flags)) {
    ImGui::PushFont(fonts().strong);
    ImGui::TextUnformatted(step.title);
    ImGui::PopFont();
    ImGui::SameLine(ImGui::GetContentRegionMax().x - px(34));
    hint(fmt::format("{} of {}", *m_step + 1, kTourSteps.size()));
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(step.words);
    ImGui::PopTextWrapPos();
    drawButtons();
    if (!ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup))
      ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  }
  ImGui::End();
  ImGui::PopStyleColor();
  const std::optional<ItemRect> before = std::exchange(m_about, about);
  return !before || !about ? before.has_value() != about.has_value() : isElsewhere(*before, *about);
}

void Tour::drawButtons() {
  const size_t now = *m_step;
  const bool last = now + 1 == kTourSteps.size();
  const float width = px(82);
  if (!last) {
    if (ImGui::Button("Skip the rest")) stop();
    markItem("tour.skip");
    tooltip("Escape. The tour is in the menu Help.");
    ImGui::SameLine();
  }
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2 * width - px(6));
  ImGui::BeginDisabled(now == 0);
  if (ImGui::Button("Back", ImVec2(width, 0))) --*m_step;
  ImGui::EndDisabled();
  markItem("tour.back");
  ImGui::SameLine(0, px(6));
  if (ImGui::Button(last ? "Done" : "Next", ImVec2(width, 0))) {
    if (last)
      stop();
    else
      ++*m_step;
  }
  markItem("tour.next");
}

}  // namespace swaplight
