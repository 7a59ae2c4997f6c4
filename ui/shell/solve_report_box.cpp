#include "ui/shell/solve_report_box.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/base/option_hints.h"
#include "core/set/solve_verdict.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kWidth = 520;
constexpr float kLabelAt = 276;

ImU32 inkOfWord(SolveVerdict::Word word) {
  switch (word) {
    case SolveVerdict::Word::Good:
      return kText;
    case SolveVerdict::Word::Fair:
      return kChanged;
    case SolveVerdict::Word::NotApart:
      break;
  }
  return kMute;
}

std::string statusWords(SolveVerdict::Word word) {
  return word == SolveVerdict::Word::NotApart ? "Lights not apart"
                                              : fmt::format("Lights told apart: {}", verdictWord(word));
}

void figure(const char* label, const std::string& value, const char* tip) {
  ImGui::TextDisabled("%s", label);
  tooltip(tip);
  ImGui::SameLine(px(kLabelAt));
  ImGui::TextUnformatted(value.c_str());
}

/// Of a contribution over a photograph; a channel that cannot tell the lights apart has none.
std::string timesText(double times) {
  return std::isfinite(times) ? fmt::format("{:.2f} times", times) : "lights not told apart";
}

std::string channelsText(const std::array<double, 3>& channels) {
  constexpr std::array<const char*, 3> kNames = {"red", "green", "blue"};
  std::string text;
  for (size_t c = 0; c < 3; ++c)
    if (std::isfinite(channels.at(c)))
      text += fmt::format("{}{} {:.2f}", text.empty() ? "" : ", ", kNames.at(c), channels.at(c));
  return text.empty() ? "lights not told apart" : text;
}

/// What a model takes surfaces to be.
std::string surfaceWords(const std::string& model) {
  constexpr std::array<std::pair<const char*, const char*>, 5> kWords = {
      {{"auto", "what each pixel shows them to be"},
       {"single", "lit by one light each"},
       {"lambert", "matte"},
       {"gloss", "matte, with highlights"},
       {"transport", "of any kind"}}};
  const auto* known =
      std::find_if(kWords.begin(), kWords.end(), [&](const auto& one) { return model == one.first; });
  return known == kWords.end() ? model : known->second;
}

void figures(const SolveReport& report) {
  const bool known = std::isfinite(report.sigmaMedian);
  figure("Error of a contribution",
         known ? fmt::format("{:.1f} % of the pixel", 100 * report.sigmaMedian) : "all of it",
         "Standard error of the median pixel: up to 12 % is good, up to 35 % fair.");
  figure("Colours may be wrong by",
         fmt::format("{:.0f} %", 100 * static_cast<double>(report.colorUncertainty)),
         "As the solver takes them: up to 18 % is good, up to 45 % fair, unless lamps shone one by one.");
  figure(
      "Left unexplained by the colours", fmt::format("{:.1f} %", 100 * report.colorDisagreement),
      "Of the light in bright pixels: up to 10 % is good, up to 20 % fair, unless lamps shone one by one.");
  figure("Noise amplified, all channels", timesText(report.conditioning.matteAmplification),
         "Noise of a contribution over that of a photograph, for matte surfaces.");
  figure("Noise amplified, one channel alone", channelsText(report.conditioning.amplification),
         "The same where surfaces are not matte. A channel that is not named cannot tell the lights apart by "
         "itself.");
  figure("Disagreement of the photographs", fmt::format("{:.1f} x their noise", report.residualMedian),
         "Of the median pixel. Above 3 something has moved, or the colours are others.");
  figure("Surfaces taken to be", surfaceWords(report.model), "How they reflect the lights, for the solve.");
}

bool isAmong(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

void takeOut(const std::string& part, std::string& words) {
  if (const size_t at = words.find(part); at != std::string::npos) words.erase(at, part.size());
}

/// The report's paragraph without what the reasons have said, and without names that the figures explain.
std::string paragraphOf(const SolveReport& report, const SolveVerdict& verdict) {
  std::string words = report.message;
  takeOut(fmt::format(" ({}, {})", report.model, report.solver), words);
  for (const std::string& reason : verdict.reasons) takeOut(" Note: " + reason + ".", words);
  return withoutOptionHints(words);
}

/// Warnings that nothing above has said.
std::vector<std::string> furtherWarnings(const SolveReport& report, const SolveVerdict& verdict) {
  std::vector<std::string> further;
  for (const std::string& warning : report.warnings)
    if (!isAmong(verdict.reasons, warning) && !isAmong(further, withoutOptionHints(warning)) &&
        report.message.find(warning) == std::string::npos)
      further.push_back(withoutOptionHints(warning));
  return further;
}

void drawReport(const SolveReport& report, const SolveVerdict& verdict) {
  ImGui::PushFont(fonts().strong);
  ImGui::PushStyleColor(ImGuiCol_Text, inkOfWord(verdict.word));
  ImGui::TextUnformatted(statusWords(verdict.word).c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::PushTextWrapPos(px(kWidth));
  for (const std::string& reason : verdict.reasons) {
    ImGui::Bullet();
    ImGui::TextUnformatted(withoutOptionHints(reason).c_str());
  }
  ImGui::Separator();
  ImGui::TextUnformatted(paragraphOf(report, verdict).c_str());
  if (const std::string unseen = unseenWords(report.causes); !unseen.empty())
    ImGui::TextUnformatted(unseen.c_str());
  const std::vector<std::string> further = furtherWarnings(report, verdict);
  if (!further.empty()) ImGui::Separator();
  for (const std::string& warning : further) {
    ImGui::Bullet();
    ImGui::TextUnformatted(warning.c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::Separator();
  const bool open = ImGui::TreeNodeEx("Figures", ImGuiTreeNodeFlags_NoTreePushOnOpen);
  markItem("status.figures");
  if (open) figures(report);
}

}  // namespace

void drawSolveWord(const SolveReport& report) {
  const SolveVerdict verdict = verdictOf(report);
  const std::string words = statusWords(verdict.word);
  const ImU32 ink = inkOfWord(verdict.word);
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  if (ImGui::SmallButton(words.c_str())) ImGui::OpenPopup("##solve report");
  ImGui::PopStyleColor(2);
  markItem("status.solve");
  markState("status.solve_word", verdictWord(verdict.word));
  tooltip((withoutOptionHints(verdictLine(verdict)) + "\nClick for the figures.").c_str());
  // Upwards from the word, whatever of it is unfolded.
  const ImVec2 word = ImGui::GetItemRectMin();
  const float most =
      ImGui::GetIO().DisplaySize.x - px(kWidth) - 2 * (ImGui::GetStyle().WindowPadding.x + px(4));
  ImGui::SetNextWindowPos(ImVec2(std::max(px(4), std::min(word.x, most)), word.y - px(4)), ImGuiCond_Always,
                          ImVec2(0, 1));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(FLT_MAX, word.y - px(8)));
  if (!ImGui::BeginPopup("##solve report")) return;
  ImGui::PushStyleColor(ImGuiCol_Text, kText);  // the status bar's is faint
  drawReport(report, verdict);
  ImGui::PopStyleColor();
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  markRect("status.report", at.x, at.y, at.x + size.x, at.y + size.y);
  ImGui::EndPopup();
}

}  // namespace swaplight
