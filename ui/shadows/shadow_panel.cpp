#include "ui/shadows/shadow_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/view/subject_image.h"
#include "ui/control/light_edit.h"
#include "ui/control/shadow_edit.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/shadows/shadow_histogram.h"
#include "ui/shadows/shadow_sliders.h"

namespace swaplight {
namespace {

using SubjectKind = ViewSubject::Kind;

constexpr float kGap = 4, kAutoWidth = 46, kSearchWidth = 74;
constexpr float kHistogramHeight = 92;
constexpr float kLowPanel = 760, kLowHistogramHeight = 44;  ///< the edits below need the room more
constexpr float kToldShare = .001F;                         // of the picture: less cannot be seen hatched

void lightCombo(EditingContext& studio) {
  const std::vector<LightSetting>& lights = studio.document().rig.lights;
  const size_t shown = shownLight(studio);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const bool open = ImGui::BeginCombo("##light", lights[shown].title().c_str());
  markItem("shadows.light");
  if (!open) return tooltip("The light whose shadows are shown. You can also select it in the mixer.");
  for (size_t i = 0; i < lights.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(lights[i].title().c_str(), i == shown)) {
      studio.view.selectedLight = static_cast<int>(i);
      studio.view.selectedLights.clear();
      ViewSubject& subject = studio.view.subject;  // a map of one light becomes that of the other
      if (subject.kind == SubjectKind::Contribution || subject.kind == SubjectKind::Beta ||
          subject.kind == SubjectKind::Visibility || ofHighlights(subject))
        subject.index = static_cast<int>(i);
    }
    markItem({"shadows.light.", lights[i].light});
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

/// What the viewer shows of the light.
void views(EditingContext& studio) {
  struct View {
    SubjectKind kind;
    const char* words;
    const char* mark;
    const char* tip;
  };
  constexpr std::array<View, 4> kViews{
      {{SubjectKind::Relit, "Picture", "shadows.view.picture", "The picture with all lights."},
       {SubjectKind::Beta, "Beta", "shadows.view.beta",
        "Beta, the light's share of each pixel at unit white: black is none, white is all."},
       {SubjectKind::Contribution, "Light", "shadows.view.light", "This light only."},
       {SubjectKind::Visibility, "Visibility", "shadows.view.reach",
        "How much of the light reaches a place: black is umbra, grey penumbra, white fully lit."}}};
  float words = 0;
  for (const View& view : kViews) words += ImGui::CalcTextSize(view.words).x;
  const float air = (ImGui::GetContentRegionAvail().x - 3 * px(kGap) - words) / kViews.size();
  const int light = static_cast<int>(shownLight(studio));
  for (size_t i = 0; i < kViews.size(); ++i) {
    const View& view = kViews.at(i);
    if (i > 0) ImGui::SameLine(0, px(kGap));
    const ViewSubject subject{view.kind, view.kind == SubjectKind::Relit ? 0 : light};
    ImGui::BeginDisabled(view.kind == SubjectKind::Visibility && shadowLight(studio, *studio.set()) < 0);
    const float width = std::floor(ImGui::CalcTextSize(view.words).x + air);
    if (choiceButton(view.words, studio.view.subject == subject, width, view.mark, view.tip))
      studio.view.subject = subject;
    ImGui::EndDisabled();
  }
}

void histogram(EditingContext& studio, const std::string& light, size_t index) {
  const ShadowPreview& preview = *studio.shadows.preview();
  const float now = shadowThresholdOf(studio.document(), light).value_or(preview.ownThreshold(index));
  const bool low = ImGui::GetWindowHeight() < px(kLowPanel);
  const ImVec2 size(ImGui::GetContentRegionAvail().x, px(low ? kLowHistogramHeight : kHistogramHeight));
  if (const auto moved = shadowHistogram(preview.histogram(index), now, size))
    previewShadowThreshold(studio, light, *moved);
}

void automaticThreshold(EditingContext& studio, const std::string& light) {
  const bool given = shadowThresholdOf(studio.document(), light).has_value();
  pushChosen(!given);
  const bool reset = ImGui::Button("Auto", ImVec2(px(kAutoWidth), 0));
  popChosen();
  markItem("shadows.auto");
  tooltip("Find this light's threshold automatically, from its shadows' edges.");
  if (reset && given) resetShadowThreshold(studio, light);
}

/// Where shadow begins, or where the search stands, with what can be done about it, in one line.
void thresholdLine(EditingContext& studio, const std::string& light, size_t index) {
  EditController& edits = studio.edits;
  const ShadowPreview* preview = studio.shadows.preview();
  const float buttonsAt = ImGui::GetContentRegionMax().x - px(kAutoWidth) - px(kGap) - px(kSearchWidth);
  const auto words = [&](const std::string& text, const char* tip) {
    ImGui::AlignTextToFramePadding();
    hint(text);
    tooltip(tip);
    ImGui::SameLine(buttonsAt);
  };
  const auto threshold = [&] {
    const float stops = stopsFromThreshold(
        shadowThresholdOf(studio.document(), light).value_or(preview->ownThreshold(index)));
    return stops < ShadowHistogram::kLowestStops ? std::string("no shadow")
                                                 : fmt::format("below {:+.1f} st", stops);
  };
  if (edits.findingShadows()) {
    words(fmt::format("{}finding {:.0f} %", preview ? threshold() + ": " : "", 100 * edits.findingFraction()),
          "The shadows are being found.");
    if (ImGui::Button("Stop", ImVec2(px(kSearchWidth), 0))) edits.stopFindingShadows();
    markItem("shadows.stop");
  } else if (edits.stoppedFindingShadows() && !edits.shadowsCurrent()) {
    words("preview only",
          "The search was stopped: outlines come from a small preview, and shadow edits wait.");
    if (ImGui::Button("Find", ImVec2(px(kSearchWidth), 0))) edits.findShadowsAgain();
    markItem("shadows.find");
  } else {
    if (!preview) {
      words("analysing …", "The light is being analysed.");
    } else {
      words(threshold(), "Darker places are in shadow: stops below fully lit.");
    }
    actionTextButton(studio.actions, "shadows.outlines", "Outlines", px(kSearchWidth));
  }
  ImGui::SameLine(0, px(kGap));
  ImGui::BeginDisabled(!preview);
  automaticThreshold(studio, light);
  ImGui::EndDisabled();
}

/// Says of places what they are, where the search cannot tell or is wrong.
void labels(EditingContext& studio, const std::string& light) {
  const float room = ImGui::GetContentRegionAvail().x;
  constexpr const char* kShadow = "This is shadow";
  constexpr const char* kLit = "This is lit";
  const float words = ImGui::CalcTextSize(kShadow).x + ImGui::CalcTextSize(kLit).x;
  const float air = (room - px(kGap) - words) / 2;  // each as wide as its words need
  const float shadow = std::floor(ImGui::CalcTextSize(kShadow).x + air);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(2), ImGui::GetStyle().FramePadding.y));
  actionTextButton(studio.actions, "shadows.mark_shadow", kShadow, shadow);
  ImGui::SameLine(0, px(kGap));
  actionTextButton(studio.actions, "shadows.mark_lit", kLit, room - shadow - px(kGap));
  ImGui::PopStyleVar();
  const ShadowController::Shown* shown = studio.shadows.shown();
  const float untold = shown ? shown->untold.share() : 0;
  const size_t made = shadowMarksOf(studio.document(), light).size();
  if (untold < kToldShare && made == 0) return;
  ImGui::AlignTextToFramePadding();
  hint(untold < kToldShare ? fmt::format("{} label{}", made, made == 1 ? "" : "s")
                           : fmt::format("{:.0f} % cannot be told", std::max(100 * untold, 1.F)));
  markState("shadows.untold", fmt::format("{:.4f}", untold));
  tooltip(
      "Hatched in the picture: the light is too weak there, or shadow and dim light look alike. Such places "
      "count as what is likelier. Take \"This is shadow\" or \"This is lit\" and click there.");
  if (made == 0) return;
  const float button = px(64);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
  actionTextButton(studio.actions, "shadows.clear_marks", "Clear", button);
}

}  // namespace

void drawShadowPanel(EditingContext& studio) {
  studio.shadows.show();
  lightCombo(studio);
  views(studio);
  const int index = shadowLight(studio, *studio.set());
  if (index < 0) {
    hint("Lights added by edits\nhave no shadows.");
    return;
  }
  const std::string light = shownShadowLight(studio);
  if (studio.shadows.preview()) histogram(studio, light, static_cast<size_t>(index));
  thresholdLine(studio, light, static_cast<size_t>(index));
  labels(studio, light);
  drawShadowSliders(studio, light);
}

}  // namespace swaplight
