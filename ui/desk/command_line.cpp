#include "ui/desk/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "ui/desk/studio_command.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr size_t kMostLines = 200;
constexpr float kPart = 0.42F;  ///< of the panel's width, for the field
constexpr const char* kHint = "1 thru 3 @ 50   key gel L201   all - back 3200K   look 2";
constexpr const char* kTip =
    "Commands in words: which lights, then what becomes of them. Lights by number, name or group, joined by "
    "+, - "
    "and thru; levels after @ in per cent; any light setting. Tab completes, Up and Down bring earlier "
    "lines, Enter "
    "runs, Escape leaves.";

/// The beginning that all of them have, in the first one's case.
std::string commonBeginning(const std::vector<std::string>& words) {
  std::string common = words.front();
  for (const std::string& word : words) {
    const auto differs = std::mismatch(common.begin(), common.end(), word.begin(), word.end(),
                                       [](char a, char b) { return lowerCase(a) == lowerCase(b); });
    common.erase(differs.first, common.end());
  }
  return common;
}

void replaceAll(ImGuiInputTextCallbackData& data, int from, const std::string& text) {
  data.DeleteChars(from, data.BufTextLen - from);
  data.InsertChars(from, text.c_str());
}

/// What has no room in the panel, over the picture above it: a refusal is to be read whole.
void drawAbove(const std::string& words, ImVec2 bottom, float width) {
  ImDrawList& over = *ImGui::GetForegroundDrawList();
  const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, width);
  const float rim = px(8);
  const ImVec2 low(bottom.x, bottom.y - size.y - rim);
  over.AddRectFilled(ImVec2(low.x - rim, low.y - rim), ImVec2(low.x + size.x + rim, bottom.y), kCard, px(4));
  over.AddText(ImGui::GetFont(), ImGui::GetFontSize(), low, kChanged, words.c_str(), nullptr, width);
}

}  // namespace

struct CommandLine::Asked {
  CommandLine& line;
  const LightsContext& studio;
};

int CommandLine::onKey(ImGuiInputTextCallbackData* data) {
  const auto& asked = *static_cast<Asked*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion)
    complete(asked.studio, *data);
  else
    asked.line.recall(*data);
  return 0;
}

void CommandLine::complete(const LightsContext& studio, ImGuiInputTextCallbackData& data) {
  if (data.CursorPos != data.BufTextLen) return;
  const StudioCommandEnds ends = studioCommandEnds(studio, data.Buf);
  if (ends.words.empty()) return;
  const std::string word = commonBeginning(ends.words);
  if (ends.from + word.size() >= static_cast<size_t>(data.BufTextLen))
    replaceAll(data, static_cast<int>(ends.from), ends.words.size() == 1 ? word + " " : word);
}

void CommandLine::recall(ImGuiInputTextCallbackData& data) {
  if (data.EventKey == ImGuiKey_UpArrow && m_line > 0)
    --m_line;
  else if (data.EventKey == ImGuiKey_DownArrow && m_line < m_lines.size())
    ++m_line;
  else
    return;
  replaceAll(data, 0, m_line < m_lines.size() ? m_lines[m_line] : "");
}

void CommandLine::run(const LightsContext& studio, CuePlayer& cues) {
  m_focus = true;
  if (m_text.find_first_not_of(' ') == std::string::npos) return;
  if (m_lines.empty() || m_lines.back() != m_text) m_lines.push_back(m_text);
  if (m_lines.size() > kMostLines) m_lines.erase(m_lines.begin());
  m_line = m_lines.size();
  try {
    m_answer = runStudioCommand(studio, cues, m_text);
    m_wrong = false;
    m_text.clear();
  } catch (const InputError& error) {  // the line stays, to be put right
    m_answer = error.what();
    m_wrong = true;
  }
}

/// The line is empty, or is the one that was refused.
bool CommandLine::answers() const {
  return m_text.empty() || (m_wrong && !m_lines.empty() && m_lines.back() == m_text);
}

void CommandLine::drawAnswer(const LightsContext& studio) const {
  std::string words = m_answer;
  ImU32 ink = m_wrong ? kChanged : kText;
  if (!answers() || words.empty()) ink = kFaint;
  if (!answers()) words = fmt::format("{}", fmt::join(studioCommandEnds(studio, m_text).words, "   "));
  if (words.empty() && m_text.empty()) words = kHint;
  ImGui::PushFont(fonts().small);
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  ImGui::PushTextWrapPos(0);
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const bool refused = m_wrong && answers();
  if (refused && ImGui::CalcTextSize(words.c_str(), nullptr, false, room.x).y > room.y) {
    drawAbove(words, ImVec2(at.x, ImGui::GetWindowPos().y - px(4)), room.x);
    ImGui::TextUnformatted("Refused: see above.");
  } else {
    ImGui::TextUnformatted(words.c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::PopFont();
  markItem("desk.answer");
  if (!words.empty()) tooltip(words.c_str());
  markState("desk.answer_words", words);
}

void CommandLine::draw(const LightsContext& studio, CuePlayer& cues) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Command");
  ImGui::SameLine(0, px(8));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * kPart);
  if (std::exchange(m_focus, false)) ImGui::SetKeyboardFocusHere();
  constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue |
                                        ImGuiInputTextFlags_CallbackCompletion |
                                        ImGuiInputTextFlags_CallbackHistory;
  Asked asked{*this, studio};
  const bool entered = ImGui::InputText("##line", &m_text, flags, onKey, &asked);
  m_emptyAndActive = ImGui::IsItemActive() && m_text.empty();
  markItem("desk.line");
  tooltip(kTip);
  if (entered) run(studio, cues);
  ImGui::SameLine(0, px(12));
  drawAnswer(studio);
}

}  // namespace swaplight
