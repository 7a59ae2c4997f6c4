#include "ui/mixer/gallery_panel.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/look/rig_blend.h"
#include "ui/control/look_edit.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/pictures/frame_picture.h"

namespace swaplight {
namespace {

constexpr float kFaderWidth = 214;
constexpr float kLeastLooks = 120;  ///< width; where there is less, the panel scrolls
constexpr float kTileGap = 6;
constexpr float kNameHeight = 20;

float aspectOf(const LightsContext& studio) {
  const ViewPictures& pictures = studio.set()->pictures();
  return static_cast<float>(pictures.width()) / static_cast<float>(pictures.height());
}

float cardWidth(const LightsContext& studio, float height) {
  return std::floor(std::clamp(height * aspectOf(studio), height / 2, 2.5F * height));
}

/// Whether recalling it would change nothing.
bool isCurrent(const Document& document, const SavedLook& look) {
  const bool lit = blendRigs(document.rig, look.rig, 1) == document.rig;
  return lit &&
         (!look.scene || *look.scene == VersionScene{document.edits, document.display, document.cameraLook});
}

void lookMenu(LightsContext& studio, size_t index) {
  const std::vector<SavedLook>& looks = studio.document().looks;
  LookState& state = studio.looks;
  if (ImGui::IsWindowAppearing()) {
    state.edited = index;
    state.name = looks[index].name;
    state.note = looks[index].note;
  }
  ImGui::SetNextItemWidth(px(220));
  if (ImGui::InputTextWithHint("##name", "Name", &state.name, ImGuiInputTextFlags_EnterReturnsTrue) &&
      !state.name.empty()) {
    const SavedLook* other = findSavedLook(looks, state.name);
    if (other && other != &looks[index])
      studio.messages.warn("There is a look \"" + other->name + "\" already.");
    else
      renameLook(studio, index, state.name);
    ImGui::CloseCurrentPopup();
  }
  markItem("gallery.name");
  ImGui::SetNextItemWidth(px(220));
  if (ImGui::InputTextWithHint("##note", "Note", &state.note, ImGuiInputTextFlags_EnterReturnsTrue)) {
    std::vector<SavedLook> next = looks;
    next[index].note = state.note;
    editLooks(studio, looks[index].name + ": note", std::move(next));
    ImGui::CloseCurrentPopup();
  }
  markItem("gallery.note");
  ImGui::Separator();
  if (ImGui::MenuItem(looks[index].scene ? "Update with all there is now" : "Update with current lighting"))
    replaceLook(studio, index);
  markItem("gallery.replace");
  if (ImGui::MenuItem("Use as A")) state.sideA = index;
  if (ImGui::MenuItem("Use as B")) state.sideB = index;
  ImGui::Separator();
  if (ImGui::MenuItem("Remove")) removeLook(studio, index);
  markItem("gallery.remove");
}

void sideCombo(LightsContext& studio, const char* side, size_t* chosen, float width) {
  const std::vector<SavedLook>& looks = studio.document().looks;
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo(fmt::format("##{}", side).c_str(),
                                      fmt::format("{}  {}", side, looks[*chosen].name).c_str());
  if (open) {
    for (size_t i = 0; i < looks.size(); ++i) {
      if (ImGui::Selectable(looks[i].name.c_str(), i == *chosen)) *chosen = i;
      markItem({"gallery.side.", i});
    }
    ImGui::EndCombo();
  }
  markItem({"gallery.side_", side});
}

/// From look to look in a time: see ui/desk/cue_player.h.
void goButtons(const ActionTable& actions, float width) {
  hint("Crossfade");
  const float button = px(46);
  ImGui::PushFont(fonts().small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(4), 0));
  ImGui::SameLine(width - 2 * button - px(4));
  actionTextButton(actions, "cues.back", "BACK", button);
  ImGui::SameLine(0, px(4));
  actionTextButton(actions, "cues.go", "GO", button);
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

/// The T-bar between two looks.
void crossfade(LightsContext& studio) {
  const std::vector<SavedLook>& looks = studio.document().looks;
  LookState& state = studio.looks;
  if (looks.size() < 2) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + px(kFaderWidth) - px(10));
    ImGui::TextDisabled("With two or more looks, a crossfader appears here.");
    ImGui::PopTextWrapPos();
    return;
  }
  state.sideA = std::min(state.sideA, looks.size() - 1);
  state.sideB = std::min(state.sideB, looks.size() - 1);
  const float width = ImGui::GetContentRegionAvail().x;
  goButtons(studio.actions, width);
  sideCombo(studio, "A", &state.sideA, width);
  float percent = 100 * state.fader;
  ImGui::SetNextItemWidth(width);
  if (ImGui::SliderFloat("##fader", &percent, 0, 100, "%.0f %%", ImGuiSliderFlags_AlwaysClamp)) {
    state.fader = percent / 100;
    previewCrossfade(studio, looks[state.sideA], looks[state.sideB], state.fader);
  }
  markItem("gallery.fader");
  tooltip("Fades from A to B as dimmers do. One undo step.");
  sideCombo(studio, "B", &state.sideB, width);
}

}  // namespace

unsigned GalleryPanel::thumbnail(LightsContext& studio, size_t index, int width, int height) {
  const OpenSet& set = *studio.set();
  const Document& document = studio.document();
  const SavedLook& look = document.looks[index];
  if (m_thumbnails.size() <= index) m_thumbnails.resize(index + 1);
  Thumbnail& made = m_thumbnails[index];
  // A view that is being changed is made for the picture alone.
  if (studio.editor.inGesture() && made.texture.id() != 0) return made.texture.id();
  const std::string& colorSpace = set.solved().colorSpace();
  const auto table = studio.table.table(studio.colors.config(), colorSpace, document.display);
  if (made.texture.id() != 0 && made.rig == look.rig && made.scene == look.scene &&
      made.set == studio.session.setRevision() && made.table == table)
    return made.texture.id();
  const std::optional<SmallPicture> picture =
      look.scene ? m_versions.picture(studio, look, table, width, height)
                 : framePicture(set.solved(), set.pictures(), *studio.colors.config(), *table, look.rig,
                                width, height);
  if (!picture) return made.texture.id();
  made.texture.update(width, height, picture->rgba.data());
  made.rig = look.rig;
  made.scene = look.scene;
  made.set = studio.session.setRevision();
  made.table = table;
  return made.texture.id();
}

void GalleryPanel::drawLook(LightsContext& studio, size_t index, float height) {
  const SavedLook look = studio.document().looks[index];
  const std::string mark = fmt::format("gallery.{}", index);
  const float aspect = aspectOf(studio);
  const ImVec2 size(cardWidth(studio, height), std::floor(height));
  // The picture inside the size, whole pixels of both.
  const int width = std::max(1, static_cast<int>(std::min(size.x, size.y * aspect)));
  const int rows = std::max(1, static_cast<int>(std::min(size.y, size.x / aspect)));
  const unsigned texture = thumbnail(studio, index, width, rows);
  ImGui::PushID(static_cast<int>(index));
  ImGui::BeginGroup();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("##look", size)) recallLook(studio, look);
  markItem(mark);
  tooltip((look.name + (look.note.empty() ? "" : "\n" + look.note) +
           (look.scene ? "\nVersion. Click to bring back lighting, light edits, view and camera look."
                       : "\nClick to apply this lighting. Light edits are not changed."))
              .c_str());
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 high(at.x + size.x, at.y + size.y);
  draw->AddRectFilled(at, high, kViewerGround);
  const ImVec2 corner(at.x + std::floor((size.x - static_cast<float>(width)) / 2),
                      at.y + std::floor((size.y - static_cast<float>(rows)) / 2));
  drawTexture(texture, corner,
              ImVec2(corner.x + static_cast<float>(width), corner.y + static_cast<float>(rows)));
  const bool current = isCurrent(studio.document(), look);
  if (current || ImGui::IsItemHovered()) draw->AddRect(at, high, current ? kAccent : kText, 0, 0, px(2));
  const float side = px(kNameHeight);
  const ImVec2 clip = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(clip, ImVec2(clip.x + size.x - 2 * side - px(6), clip.y + side), true);
  hint(fmt::format("{}  {}{}", index + 1, look.scene ? std::string(kIconLayers) + " " : "", look.name));
  ImGui::PopClipRect();
  ImGui::SetCursorScreenPos(ImVec2(clip.x + size.x - 2 * side - px(2), clip.y));
  const CompareState& compare = studio.view.compare;
  const bool wiping = compare.mode == CompareState::Mode::Wipe && compare.rig == look.rig;
  if (toggleButton(kIconCompare, wiping, kAccent, side, "Wipe against this look. Click again to stop.")) {
    if (wiping)
      studio.view.compare.mode = CompareState::Mode::Off;
    else
      wipeAgainstLook(studio, look);
  }
  markItem({mark, ".wipe"});
  ImGui::SameLine(0, px(2));
  if (toggleButton(kIconMore, false, kAccent, side, "Name, note, replace, remove"))
    ImGui::OpenPopup("##menu");
  markItem({mark, ".menu"});
  if (ImGui::BeginPopup("##menu")) {
    lookMenu(studio, index);
    ImGui::EndPopup();
  }
  ImGui::EndGroup();
  ImGui::PopID();
}

void GalleryPanel::drawKeepButtons(const LightsContext& studio, float width, float height) {
  const float gap = px(kTileGap);
  const ImVec2 size(width, std::floor((height - gap) / 2));
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
  if (ImGui::Button("+ Look", size)) studio.actions.run("looks.keep");
  markItem("gallery.keep");
  tooltip(
      "Save the current lighting as a look: colours, levels and switches. Light edits (F4) are not included. "
      "(Shift+K)");
  if (ImGui::Button("+ Version", size)) studio.actions.run("looks.keep_version");
  markItem("gallery.keep_version");
  tooltip("Save all there is now as a version: lighting, light edits, view and camera look. (Shift+V)");
  ImGui::PopStyleVar();
  ImGui::EndGroup();
}

void GalleryPanel::draw(LightsContext& studio) {
  if (m_thumbnails.size() > studio.document().looks.size())
    m_thumbnails.resize(studio.document().looks.size());
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float button = px(92);
  drawKeepButtons(studio, button, room.y);
  ImGui::SameLine(0, px(kTileGap));
  const float rest = room.x - button - px(kFaderWidth) - 2 * px(kTileGap);
  ImGui::BeginChild("##looks", ImVec2(std::max(rest, px(kLeastLooks)), room.y), false,
                    ImGuiWindowFlags_HorizontalScrollbar);
  const size_t count = studio.document().looks.size();
  if (count == 0) {
    ImGui::PushTextWrapPos(ImGui::GetWindowWidth());
    ImGui::TextDisabled(
        "Nothing is kept yet. + Look saves the current lighting: colours, levels and switches; + Version "
        "saves light edits, view and camera look, too.");
    ImGui::PopTextWrapPos();
  }
  // Pictures as high as there is room, less a bar where they do not fit side by side.
  float height = room.y - px(kNameHeight) - ImGui::GetStyle().ItemSpacing.y;
  const float wanted = static_cast<float>(count) * (cardWidth(studio, height) + px(kTileGap));
  if (wanted > ImGui::GetContentRegionAvail().x) height -= ImGui::GetStyle().ScrollbarSize;
  for (size_t i = 0; i < count && i < studio.document().looks.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, px(kTileGap));
    drawLook(studio, i, std::max(px(30), height));
  }
  ImGui::EndChild();
  ImGui::SameLine(0, px(kTileGap));
  ImGui::BeginChild("##crossfade", ImVec2(px(kFaderWidth), room.y), false, ImGuiWindowFlags_NoScrollbar);
  crossfade(studio);
  ImGui::EndChild();
}

}  // namespace swaplight
