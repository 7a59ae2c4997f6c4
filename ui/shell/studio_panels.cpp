#include <imgui.h>

#include <algorithm>

#include "ui/dialogs/welcome_panel.h"
#include "ui/edits/edits_panel.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/mixer/mixer_panel.h"
#include "ui/shell/message_list.h"
#include "ui/shell/progress_boxes.h"
#include "ui/shell/status_bar.h"
#include "ui/shell/studio_window.h"
#include "ui/viewer/viewer_panel.h"

namespace swaplight {
namespace {

constexpr float kToolbarWidth = 46;
constexpr float kEditsWidth = 248;
constexpr float kSplitter = 4;
constexpr float kLeastViewer = 160;  ///< height that the viewer keeps, however small the window

/// A panel of the window: Dear ImGui's child with a padding, in which items have their usual distance though
/// the panels have none.
template <typename Draw>
void panel(const char* id, ImVec2 size, ImVec2 padding, ImGuiWindowFlags flags, const Draw& draw) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild(id, size, false, flags | ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar(2);
  draw();
  ImGui::EndChild();
}

}  // namespace

void StudioWindow::drawToolbar() {
  const float side = px(34);
  const auto gap = [] { ImGui::Dummy(ImVec2(0, px(4))); };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), px(4)));
  actionButton(m_actions, "file.open", kIconOpen, side);
  actionButton(m_actions, "file.save", kIconSave, side);
  actionButton(m_actions, "file.export", kIconExport, side);
  gap();
  actionButton(m_actions, "edit.undo", kIconUndo, side);
  actionButton(m_actions, "edit.redo", kIconRedo, side);
  actionButton(m_actions, "edit.history", kIconHistory, side);
  gap();
  actionButton(m_actions, "view.fit", kIconFit, side);
  actionButton(m_actions, "view.one_to_one", "1:1", side);
  gap();
  actionButton(m_actions, "brush.take", kIconBrush, side);
  actionButton(m_actions, "light.neutral", kIconPicker, side);
  actionButton(m_actions, "view.probe", kIconInfo, side);
  actionButton(m_actions, "compare.wipe", kIconCompare, side);
  actionButton(m_actions, "view.photograph", kIconPhoto, side);
  actionButton(m_actions, "view.scopes", kIconScopes, side);
  actionButton(m_actions, "view.gallery", kIconGallery, side);
  gap();
  actionButton(m_actions, "help.keys", kIconHelp, side);
  ImGui::PopStyleVar();
}

void StudioWindow::drawPanels() {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool panels = !m_layout.hidden;
  const bool hasLights = !m_editor.document().rig.lights.empty();
  const bool mixer = panels && m_layout.mixer && hasLights;
  const bool scopes = panels && m_layout.scopes && m_session.set();
  const bool gallery = panels && m_layout.gallery && m_session.set();
  const float splitterWidth = px(kSplitter);
  const float status = panels ? ImGui::GetFrameHeight() + px(2) : 0;
  const float height = room.y - status;
  const float buttons = panels && m_layout.tools ? px(kToolbarWidth) : 0;
  const float edits = panels && m_layout.edits && m_session.set() && hasLights ? px(kEditsWidth) : 0;
  const float tools = buttons + edits;  // at the left of the viewer
  const float mixerWidth = mixer ? std::min(px(m_layout.mixerWidth), room.x * 0.6F) : 0;
  const float viewerWidth = room.x - tools - mixerWidth - (mixer ? splitterWidth : 0);
  const float galleryHeight = gallery ? px(GalleryPanel::kHeight) : 0;
  const float scopesHeight = scopes ? std::clamp(px(m_layout.scopesHeight), px(120),
                                                 std::max(px(120), height - galleryHeight - px(kLeastViewer)))
                                    : 0;
  const float viewerHeight = height - galleryHeight - scopesHeight - (scopes ? splitterWidth : 0);

  const auto place = [&](float x, float y) { ImGui::SetCursorScreenPos(ImVec2(at.x + x, at.y + y)); };
  if (buttons > 0)
    panel("##tools", ImVec2(buttons, height), ImVec2(px(6), px(8)), ImGuiWindowFlags_NoScrollbar,
          [&] { drawToolbar(); });
  // The lights come before the picture, so that it shows in the same frame what is done to them.
  if (mixer) {
    place(tools + viewerWidth, 0);
    splitter("##mixer width", true, splitterWidth, height, &m_layout.mixerWidth, 320, 900, -1);
    markItem("splitter.mixer");
    place(tools + viewerWidth + splitterWidth, 0);
    panel("##mixer", ImVec2(mixerWidth, height), ImVec2(px(10), px(10)), 0,
          [&] { drawMixerPanel(m_context); });
  }
  if (edits > 0) {
    place(buttons, 0);
    panel("##edits", ImVec2(edits, height), ImVec2(px(10), px(10)), 0, [&] { drawEditsPanel(m_context); });
  }
  place(tools, 0);
  panel("##viewer", ImVec2(viewerWidth, viewerHeight), ImVec2(0, 0),
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse, [&] {
          if (m_session.hasDocument() || m_sets.busy())
            drawViewerPanel(m_context);
          else
            drawWelcomePanel(m_context, m_samples);
        });
  if (scopes) {
    place(tools, viewerHeight);
    splitter("##scopes height", false, splitterWidth, viewerWidth, &m_layout.scopesHeight, 120, 900, -1);
    markItem("splitter.scopes");
    place(tools, viewerHeight + splitterWidth);
    panel("##scopes", ImVec2(viewerWidth, scopesHeight), ImVec2(px(8), px(6)), ImGuiWindowFlags_NoScrollbar,
          [&] { m_scopes.draw(m_context); });
  }
  if (gallery) {
    place(tools, height - galleryHeight);
    panel("##gallery", ImVec2(viewerWidth, galleryHeight), ImVec2(px(8), px(8)), ImGuiWindowFlags_NoScrollbar,
          [&] { m_gallery.draw(m_context); });
  }
  if (panels) {
    place(px(10), height);
    drawStatusBar(m_context);
  }
  drawSetProgress(m_sets, at.x + tools + viewerWidth / 2, at.y + viewerHeight / 2);
  drawExportProgress(m_exports, at.x + tools + viewerWidth - px(12), at.y + viewerHeight - px(12));
  drawMessages(m_messages, at.x + tools + px(12), at.y + viewerHeight - px(12), viewerWidth - px(60));
}

}  // namespace swaplight
