#include <fmt/core.h>
#include <imgui.h>

#include "core/intake/photograph_choice.h"
#include "ui/dialogs/capture_wizard.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {

/// What the answer depends on.
std::string CaptureWizard::typedColors() const {
  std::string all = m_exposures;
  for (const WizardRow& row : m_rows) {
    all += row.used ? "\n+" : "\n-";
    for (const WizardCell& cell : row.cells) all += "\n" + cell.text;
  }
  return all;
}

void CaptureWizard::testLight() {
  CaptureDraft whole = draft();
  whole.frame = {};
  m_tested = typedColors();
  m_linearity.reset();
  m_testing.start(
      [capture = captureOf(whole), all = m_found->pixels, used = usedPhotographs(m_rows)](
          const Progress& progress) { return linearityOf(capture, *pixelsOf(all, used), progress); },
      m_wake);
}

void CaptureWizard::drawLightTest(const std::string& wrong) {
  const char* words = m_testing.running() ? "Looking …" : "Do they hold light?";
  const float width = ImGui::CalcTextSize("Do they hold light?").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  ImGui::BeginDisabled(!wrong.empty() || m_testing.running());
  if (ImGui::Button(words, ImVec2(width, 0))) testLight();
  ImGui::EndDisabled();
  markItem("wizard.linear");
  tooltip(
      "Finds out whether the photographs hold light, as their colour space says, or a tone curve of the "
      "camera's as well: by what they show under these colours.");
}

const LinearityEvidence* CaptureWizard::linearity() const {
  return m_linearity && m_tested == typedColors() ? &*m_linearity : nullptr;
}

void CaptureWizard::drawLinearity() {
  const LinearityEvidence* evidence = linearity();
  markState("wizard.linear.words", evidence ? evidence->finding : "");
  if (!evidence) return;
  const bool linear = evidence->answer == LinearityEvidence::Answer::Linear;
  const ImVec4 color =
      linear ? ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled) : ImGui::ColorConvertU32ToFloat4(kChanged);
  ImGui::TextColored(color, "%s", linear ? kIconCheck : kIconWarning);
  ImGui::SameLine(0, px(6));
  ImGui::TextUnformatted(("Do the photographs hold light? " + evidence->finding).c_str());
  if (evidence->answer != LinearityEvidence::Answer::Curved) return;
  bool take = m_solve.correctTone == Remedy::On;
  if (ImGui::Checkbox("Take the curve off before solving", &take))
    m_solve.correctTone = take ? Remedy::On : Remedy::Sure;
  markItem("wizard.tone");
  tooltip(
      "Finds the tone curve once more by the whole picture and solves without it. The exposure stays open. "
      "Where no curve is surely seen, nothing is changed. Without the tick it is taken off where nothing "
      "else can be "
      "what is wrong.");
}

}  // namespace swaplight
