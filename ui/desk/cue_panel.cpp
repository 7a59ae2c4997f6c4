#include "ui/desk/cue_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "ui/desk/cue_edit.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kNumberWidth = 58;
constexpr float kSecondsWidth = 52;
constexpr float kMenuWidth = 26;
constexpr const char* kFadeTip =
    "Seconds until the cue stands. Lights go in a straight line in linear light, light edits by their "
    "opacity.";
constexpr const char* kFollowTip =
    "Seconds that this cue stands before the next one comes by itself. Empty: the next one waits for GO.";
constexpr const char* kNameTip = "Click: GO goes to this cue next. Double-click: go to it now.";

/// Runs what may be refused; then why is a message.
template <typename Work>
void trying(const LightsContext& studio, const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    studio.messages.warn(error.what());
  }
}

std::string markOf(const Cue& cue) {
  return "cue." + cueNumberText(cue.number);
}

void cueMenu(const LightsContext& studio, CuePlayer& cues, const Cue& cue) {
  const std::string number = cueNumberText(cue.number), mark = markOf(cue);
  if (ImGui::MenuItem("Go to this cue")) trying(studio, [&] { cues.go(studio, number); });
  markItem({mark, ".go"});
  if (ImGui::MenuItem("Record again")) trying(studio, [&] { cues.stand(recordCueLine(studio, number)); });
  markItem({mark, ".record"});
  tooltip("Keeps all there is now in the place of this cue; its times stay.");
  if (ImGui::BeginMenu("Look or version")) {
    const std::vector<SavedLook>& looks = studio.document().looks;
    for (size_t i = 0; i < looks.size(); ++i) {
      if (ImGui::MenuItem(looks[i].name.c_str(), nullptr, looks[i].name == cue.look))
        trying(studio, [&] { runCueLine(studio, fmt::format("{} look {}", number, i + 1)); });
      markItem({mark, ".look.", i});
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Remove")) trying(studio, [&] { runCueLine(studio, number + " remove"); });
  markItem({mark, ".remove"});
}

std::string secondsText(float seconds) {
  return fmt::format("{:g}", seconds);
}

/// What the show is doing, in words.
std::string stateWords(const LightsContext& studio, const CuePlayer& cues) {
  const CueList& list = studio.document().cues;
  if (list.empty()) return "No cues yet: light the set, then Record.";
  if (cues.waiting()) return fmt::format("next by itself in {:.0f} s", std::ceil(cues.waitSeconds()));
  const Cue* next = cues.next(list);
  return next ? fmt::format("next: {}  {}", cueNumberText(next->number), next->look) : "the last cue stands";
}

}  // namespace

void CuePanel::drawButtons(const LightsContext& studio, const CuePlayer& cues) {
  const float gap = px(6);
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  actionTextButton(studio.actions, "cues.record", "Record", width);
  ImGui::SameLine(0, gap);
  actionTextButton(studio.actions, "cues.back", "BACK", width);
  ImGui::SameLine(0, gap);
  ImGui::PushStyleColor(ImGuiCol_Button, kAccent);
  actionTextButton(studio.actions, "cues.go", "GO", width);
  ImGui::PopStyleColor();
  ImGui::ProgressBar(cues.amount(), ImVec2(-1, px(4)), "");
  const std::string words = stateWords(studio, cues);
  hint(words);
  markState("cues.words", words);
}

void CuePanel::drawSeconds(const LightsContext& studio, const Cue& cue, const char* words,
                           const std::string& shown, const char* tip) {
  const std::string field = fmt::format("{}.{}", markOf(cue), words);
  const auto kept = m_typed.find(field);
  std::string typed = kept == m_typed.end() ? shown : kept->second;
  ImGui::SetNextItemWidth(px(kSecondsWidth));
  ImGui::InputTextWithHint(("##" + field).c_str(), "\u2013", &typed, ImGuiInputTextFlags_AutoSelectAll);
  const bool active = ImGui::IsItemActive(), left = ImGui::IsItemDeactivatedAfterEdit();
  markItem(field);
  tooltip(tip);
  if (active)
    m_typed[field] = typed;
  else
    m_typed.erase(field);
  if (!left || typed == shown) return;
  std::erase(typed, '"');
  const std::string value = typed.empty() ? "off" : '"' + typed + '"';  // one word, whatever it is
  trying(studio,
         [&] { runCueLine(studio, fmt::format("{} {} {}", cueNumberText(cue.number), words, value)); });
}

void CuePanel::drawCue(const LightsContext& studio, CuePlayer& cues, const Cue& cue) {
  const std::string mark = markOf(cue);
  const Cue* next = cues.next(studio.document().cues);
  const bool stands = cues.current() == cue.number, isNext = next && next->number == cue.number;
  const bool known = findSavedLook(studio.document().looks, cue.look) != nullptr;
  ImGui::PushID(cue.number);
  ImGui::TableNextRow();
  if (stands) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, ImGui::GetColorU32(ImGuiCol_Header));
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  const std::string number = fmt::format("{} {}",
                                         stands   ? kIconCheck
                                         : isNext ? kIconRight
                                                  : "   ",
                                         cueNumberText(cue.number));
  if (isNext) ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
  ImGui::TextUnformatted(number.c_str());
  if (isNext) ImGui::PopStyleColor();
  tooltip(stands ? "This cue stands." : isNext ? "GO goes here." : "The cue's number; go 3 in a command.");
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  if (!known) ImGui::PushStyleColor(ImGuiCol_Text, kChanged);
  if (ImGui::Selectable(cue.look.c_str(), false, ImGuiSelectableFlags_AllowDoubleClick)) {
    cues.load(cue.number);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      trying(studio, [&] { cues.go(studio, cueNumberText(cue.number)); });
  }
  if (!known) ImGui::PopStyleColor();
  markItem(mark);
  markState((mark + ".state").c_str(), stands ? "stands" : isNext ? "next" : "");
  tooltip(known ? kNameTip : "The gallery has no look of this name: choose another one in the menu.");
  ImGui::TableNextColumn();
  drawSeconds(studio, cue, "time", secondsText(cue.fadeSeconds), kFadeTip);
  ImGui::TableNextColumn();
  drawSeconds(studio, cue, "follow", cue.followSeconds ? secondsText(*cue.followSeconds) : "", kFollowTip);
  ImGui::TableNextColumn();
  if (toggleButton(kIconMore, false, kAccent, px(kMenuWidth), "Go, record again, another look, remove"))
    ImGui::OpenPopup("##menu");
  markItem({mark, ".menu"});
  if (ImGui::BeginPopup("##menu")) {
    cueMenu(studio, cues, cue);
    ImGui::EndPopup();
  }
  ImGui::PopID();
}

void CuePanel::drawList(const LightsContext& studio, CuePlayer& cues) {
  const CueList list = studio.document().cues;  // a row may change it
  if (list.empty()) return;
  const float below = px(CueTrack::kHeight) + ImGui::GetStyle().ItemSpacing.y;
  const float room =
      std::max(ImGui::GetContentRegionAvail().y - below, 3 * ImGui::GetFrameHeightWithSpacing());
  const float rows = static_cast<float>(list.size() + 1) * (ImGui::GetFrameHeight() + px(6)) + px(8);
  if (!ImGui::BeginTable("##cues", 5, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg,
                         ImVec2(0, std::min(room, rows))))
    return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Cue", ImGuiTableColumnFlags_WidthFixed, px(kNumberWidth));
  ImGui::TableSetupColumn("Look", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("Fade s", ImGuiTableColumnFlags_WidthFixed, px(kSecondsWidth));
  ImGui::TableSetupColumn("Follow", ImGuiTableColumnFlags_WidthFixed, px(kSecondsWidth));
  ImGui::TableSetupColumn("##more", ImGuiTableColumnFlags_WidthFixed, px(kMenuWidth));
  ImGui::TableHeadersRow();
  for (const Cue& cue : list) drawCue(studio, cues, cue);
  ImGui::EndTable();
}

void CuePanel::draw(const LightsContext& studio, CuePlayer& cues) {
  ImGui::PushFont(fonts().strong);
  ImGui::TextUnformatted("Cues");
  ImGui::PopFont();
  drawButtons(studio, cues);
  drawList(studio, cues);
  m_track.draw(studio, cues);
}

}  // namespace swaplight
