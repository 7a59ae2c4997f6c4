#include "ui/shell/solve_report_box.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

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

std::string timesText(double times) {
  return std::isfinite(times) ? fmt::format("{:.2f}", times) : "none";
}

void figures(const SolveReport& report) {
  const std::array<double, 3>& channels = report.conditioning.amplification;
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
  figure("R, G, B alone",
         fmt::format("{}, {}, {}", timesText(channels[0]), timesText(channels[1]), timesText(channels[2])),
         "The same where surfaces are not matte; none: this channel cannot tell the lights apart.");
  figure("Disagreement of the photographs", fmt::format("{:.1f} x their noise", report.residualMedian),
         "Of the median pixel. Above 3 something has moved, or the colours are others.");
  figure("Model, solver", report.model + ", " + report.solver, "How it was solved.");
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
  ImGui::TextUnformatted(withoutOptionHints(report.message).c_str());
  if (const std::string unseen = unseenWords(report.causes); !unseen.empty())
    ImGui::TextUnformatted(unseen.c_str());
  ImGui::Separator();
  figures(report);
  if (!report.warnings.empty()) ImGui::Separator();
  for (const std::string& warning : report.warnings)
    if (std::find(verdict.reasons.begin(), verdict.reasons.end(), warning) == verdict.reasons.end())
      ImGui::TextUnformatted(withoutOptionHints(warning).c_str());
  ImGui::PopTextWrapPos();
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
  if (!ImGui::BeginPopup("##solve report")) return;
  ImGui::PushStyleColor(ImGuiCol_Text, kText);  // the status bar's is faint
  drawReport(report, verdict);
  ImGui::PopStyleColor();
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  markRect("status.report", at.x, at.y, at.x + size.x, at.y + size.y);
  ImGui::EndPopup();
}

}  // namespace swaplight
