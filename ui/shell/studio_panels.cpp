#include <imgui.h>

#include <algorithm>

#include "ui/camera_look/camera_look_panel.h"
#include "ui/edits/edits_panel.h"
#include "ui/grade/grade_panel.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/mixer/mixer_panel.h"
#include "ui/shell/message_list.h"
#include "ui/shell/progress_boxes.h"
#include "ui/shell/status_bar.h"
#include "ui/shell/studio_window.h"
#include "ui/shell/toolbar.h"
#include "ui/viewer/viewer_panel.h"

namespace swaplight {
namespace {

constexpr float kToolbarWidth = 46;
constexpr float kEditsWidth = 248;
constexpr float kCameraLookWidth = 268;
constexpr float kGradeWidth = 276;
constexpr float kSplitter = 4;
constexpr float kMostMixer = 0.6F;   ///< of the window's width
constexpr float kLeastViewer = 160;  ///< height that the viewer keeps, however small the window
constexpr float kLeastViewerWidth = 220;

/// A panel of the window: Dear ImGui's child with a padding, in which items have their usual distance though
/// the panels have none.
template <typename Draw>
void child(const char* id, ImVec2 size, ImVec2 padding, ImGuiWindowFlags flags, const Draw& draw) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(padding.x), px(padding.y)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild(id, size, false, flags | ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar(2);
  draw();
  ImGui::EndChild();
}

/// What is left of the window for the viewer while panels take their parts.
struct Room {
  float left, top, right, bottom;  ///< in pixels of the screen
  [[nodiscard]] float width() const { return right - left; }
  [[nodiscard]] float height() const { return bottom - top; }
};

/// A rectangle of the room for a panel, whose length is across the side at which it stands.
Room takeRoom(Room& room, Dock dock, float length) {
  Room taken = room;
  if (dock == Dock::Left) taken.right = room.left += length;
  if (dock == Dock::Right) taken.left = room.right -= length;
  if (dock == Dock::Bottom) taken.top = room.bottom -= length;
  return taken;
}

bool isAtSide(const PanelInfo& panel) {
  return panel.dock == Dock::Left || panel.dock == Dock::Right;
}

/// The least that a panel takes of the room, with its splitter.
float leastLength(const PanelInfo& panel) {
  return panel.ownSize.length ? px(panel.ownSize.least + kSplitter) : px(panel.size);
}

/// `others`: what panels at the sides take that are drawn after it.
float lengthOf(const PanelInfo& panel, const PanelLayout& layout, const Room& room, float others = 0) {
  if (!panel.ownSize.length) return px(panel.size);
  const float wanted = px(layout.*panel.ownSize.length), least = px(panel.ownSize.least);
  if (panel.dock == Dock::Bottom)
    return std::clamp(wanted, least, std::max(least, room.height() - px(kLeastViewer)));
  const float most = std::min(room.width() - others - px(kSplitter + kLeastViewerWidth),
                              ImGui::GetIO().DisplaySize.x * kMostMixer);
  return std::min(wanted, std::max(most, least));
}

/// The bar between the panel and what is left of the room, which it makes smaller.
void drawSplitter(const PanelInfo& panel, PanelLayout& layout, Room& room) {
  const bool upright = panel.dock != Dock::Bottom;
  const Room bar = takeRoom(room, panel.dock, px(kSplitter));
  ImGui::SetCursorScreenPos(ImVec2(bar.left, bar.top));
  splitter(("##size of " + panel.shortName()).c_str(), upright, px(kSplitter),
           upright ? bar.height() : bar.width(), &(layout.*panel.ownSize.length), panel.ownSize.least,
           panel.ownSize.most, panel.dock == Dock::Left ? 1.F : -1.F);
  markItem({"splitter.", panel.shortName()});
}

void drawPanel(const PanelInfo& panel, PanelLayout& layout, Room& room, float others = 0) {
  const Room place = takeRoom(room, panel.dock, lengthOf(panel, layout, room, others));
  if (panel.ownSize.length) drawSplitter(panel, layout, room);
  ImGui::SetCursorScreenPos(ImVec2(place.left, place.top));
  child(("##" + panel.shortName()).c_str(), ImVec2(place.width(), place.height()), panel.padding, panel.flags,
        panel.draw);
}

}  // namespace

std::vector<PanelInfo> StudioWindow::allPanels() {
  constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoScrollbar;
  const auto hasSet = [this] { return m_session.set() != nullptr; };
  const auto hasLights = [this] { return !m_editor.document().rig.lights.empty(); };
  const auto canEdit = [hasSet, hasLights] { return hasSet() && hasLights(); };
  using Layout = PanelLayout;
  // At a side the first stands outermost.
  return {
      {.id = "view.mixer",
       .name = "Mixer",
       .keys = "F5",
       .tooltip = "Show or hide the light mixer.",
       .open = &Layout::mixer,
       .dock = Dock::Right,
       .ownSize = {&Layout::mixerWidth, 320, 900},
       .padding = {10, 10},
       .available = hasLights,
       .draw = [this] { drawMixerPanel(m_lights); }},
      {.id = "view.three_point",
       .name = "Three-point lighting",
       .keys = "F9",
       .tooltip = "Key, fill and back light, their ratios and preset looks, in place of the colour controls. "
                  "Press again for colour.",
       .open = &Layout::threePoint},
      {.id = "view.command_line",
       .name = "Command line",
       .keys = "F12",
       .tooltip = "Show or hide the line for commands in words, as at a lighting desk.",
       .open = &Layout::commandLine,
       .dock = Dock::Bottom,
       .size = CommandLine::kHeight,
       .padding = {10, 8},
       .flags = fixed,
       .available = hasLights,
       .draw = [this] { m_commandLine.draw(m_lights, m_cues); }},
      {.id = "view.gallery",
       .name = "Gallery",
       .keys = "F8",
       .tooltip = "Show or hide saved looks.",
       .open = &Layout::gallery,
       .dock = Dock::Bottom,
       .size = GalleryPanel::kHeight,
       .padding = {8, 8},
       .flags = ImGuiWindowFlags_HorizontalScrollbar,
       .available = hasSet,
       .draw = [this] { m_gallery.draw(m_lights); }},
      {.id = "view.scopes",
       .name = "Scopes",
       .keys = "F6",
       .tooltip = "Show or hide waveform, vectorscope, histogram and chromaticities.",
       .open = &Layout::scopes,
       .dock = Dock::Bottom,
       .ownSize = {&Layout::scopesHeight, 120, 900},
       .padding = {8, 6},
       .flags = fixed,
       .available = hasSet,
       .draw = [this] { m_scopes.draw(m_context, m_layout.scopeOptions, m_actions); }},
      {.id = "view.tools",
       .name = "Tools",
       .keys = "F7",
       .tooltip = "Show or hide the toolbar.",
       .open = &Layout::tools,
       .dock = Dock::Left,
       .size = kToolbarWidth,
       .padding = {6, 8},
       .flags = fixed,
       .draw = [this] { drawToolbar(m_actions); }},
      {.id = "view.edits",
       .name = "Edits",
       .keys = "F4",
       .tooltip = "Show or hide the list of light edits.",
       .open = &Layout::edits,
       .dock = Dock::Left,
       .size = kEditsWidth,
       .padding = {10, 10},
       .available = canEdit,
       .draw = [this] { drawEditsPanel(m_context); }},
      {.id = "view.camera_look",
       .name = "Camera look",
       .keys = "F10",
       .tooltip = "Show or hide the camera look: filters that the lit picture is seen through.",
       .open = &Layout::cameraLook,
       .dock = Dock::Left,
       .size = kCameraLookWidth,
       .padding = {10, 10},
       .available = hasSet,
       .draw = [this] { drawCameraLookPanel(m_context, m_chooser); }},
      {.id = "view.grade",
       .name = "Grade",
       .keys = "Shift+F10",
       .tooltip = "Show or hide the grade of the finished frame: lift, gamma, gain, saturation.",
       .open = &Layout::grade,
       .dock = Dock::Left,
       .size = kGradeWidth,
       .padding = {10, 10},
       .available = hasSet,
       .draw = [this] { drawGradePanel(m_context); }},
      {.id = "view.cues",
       .name = "Cues",
       .keys = "Shift+F8",
       .tooltip = "Show or hide the cue list: versions that fade in one after the other.",
       .open = &Layout::cues,
       .dock = Dock::Left,
       .size = CuePanel::kWidth,
       .padding = {10, 10},
       .available = canEdit,
       .draw = [this] { m_cuePanel.draw(m_lights, m_cues); }},
  };
}

void StudioWindow::drawViewer(ImVec2 size) {
  child("##viewer", size, ImVec2(0, 0), ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse,
        [this] {
          if (m_session.hasDocument() || m_sets.busy())
            drawViewerPanel(m_context);
          else
            m_start.draw(m_session, m_actions, m_keeper.written());
        });
}

/// Those at the sides that are drawn, in the order of the list: where there is no room for all, the toolbar
/// and what was opened last. The others come back with the room.
std::vector<const PanelInfo*> StudioWindow::sidePanels(float width) {
  const auto isOpen = [&](const PanelInfo& panel) { return isAtSide(panel) && panel.isShown(m_layout); };
  std::erase_if(m_sides, [&](const PanelInfo* panel) { return !isOpen(*panel); });
  for (const PanelInfo& panel : m_panels)
    if (isOpen(panel) && std::find(m_sides.begin(), m_sides.end(), &panel) == m_sides.end())
      m_sides.push_back(&panel);
  std::vector<const PanelInfo*> drawn, left;
  float room = width - px(kLeastViewerWidth);
  for (const PanelInfo* panel : m_sides)
    if (panel->open == &PanelLayout::tools) room -= leastLength(*panel), drawn.push_back(panel);
  for (auto panel = m_sides.rbegin(); panel != m_sides.rend(); ++panel) {
    if ((*panel)->open == &PanelLayout::tools) continue;
    const bool fits = leastLength(**panel) <= room || (left.empty() && panel == m_sides.rbegin());
    if (fits) room -= leastLength(**panel);
    (fits ? drawn : left).push_back(*panel);
  }
  for (const PanelInfo* panel : left)
    if (std::find(m_sidesLeft.begin(), m_sidesLeft.end(), panel) == m_sidesLeft.end())
      m_messages.info(
          std::string(panel->name) +
          " is not shown: there is no room for it. Close another panel, or make the window larger.");
  m_sidesLeft = left;
  std::sort(drawn.begin(), drawn.end());  // as in m_panels
  return drawn;
}

void StudioWindow::drawPanels() {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  Room room{at.x, at.y, at.x + size.x, at.y + size.y};
  if (!m_layout.hidden) room.bottom -= ImGui::GetFrameHeight() + px(2);
  const float status = room.bottom;
  // The lights come before the picture, so that it shows in the same frame what is done to them; what stands
  // below it, and tells about it, comes after. But its room is taken before.
  const std::vector<const PanelInfo*> sides = sidePanels(size.x);
  float others = 0;
  for (const PanelInfo* panel : sides) others += leastLength(*panel);
  for (const PanelInfo* panel : sides) {
    others -= leastLength(*panel);
    drawPanel(*panel, m_layout, room, others);
  }
  Room viewer = room;
  for (const PanelInfo& panel : m_panels)
    if (panel.dock == Dock::Bottom && panel.isShown(m_layout)) {
      takeRoom(viewer, panel.dock, lengthOf(panel, m_layout, viewer));
      if (panel.ownSize.length) takeRoom(viewer, panel.dock, px(kSplitter));
    }
  ImGui::SetCursorScreenPos(ImVec2(viewer.left, viewer.top));
  drawViewer(ImVec2(viewer.width(), viewer.height()));
  for (const PanelInfo& panel : m_panels)
    if (panel.dock == Dock::Bottom && panel.isShown(m_layout)) drawPanel(panel, m_layout, room);
  if (!m_layout.hidden) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + px(10), status));
    drawStatusBar(m_session, m_shown, m_colors);
  }
  drawSetProgress(m_sets, (viewer.left + viewer.right) / 2, (viewer.top + viewer.bottom) / 2);
  drawExportProgress(m_exports, viewer.right - px(12), viewer.bottom - px(12));
  drawMessages(m_messages, viewer.left + px(12), viewer.bottom - px(12), viewer.width() - px(60));
}

}  // namespace swaplight
