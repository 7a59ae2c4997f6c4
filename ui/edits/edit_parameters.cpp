#include "ui/edits/edit_parameters.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/color/srgb.h"
#include "core/edit/stack/beta_histogram.h"
#include "ui/control/light_edit.h"
#include "ui/edits/curve_widget.h"
#include "ui/edits/edit_list.h"
#include "ui/edits/edit_menu.h"
#include "ui/edits/edit_place.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/state/enum_names.h"

namespace swaplight {
namespace {

constexpr float kCurveHeight = 150;
constexpr int kHistogramBins = 64;

/// An edit being looked at and changed.
struct Parameters {
  EditingContext& studio;
  size_t index;
  const Edit& edit;

  void preview(const char* what, Edit next) const {
    const std::string name = next.name.empty() ? operationName(next.operation) : next.name;
    previewEdit(studio, index, name + ": " + what, std::move(next));
  }
  void preview(const char* what, const Operation& operation) const {
    Edit next = edit;
    next.operation = operation;
    preview(what, std::move(next));
  }
  void change(const std::string& step, Edit next) const { editEdit(studio, index, step, std::move(next)); }
};

void label(const char* words) {
  ImGui::AlignTextToFramePadding();
  hint(words);
  ImGui::SameLine(px(kLabelWidth));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - px(6));
}

bool percent(const char* words, const char* mark, float* part, float low, float high, const char* tip) {
  float shown = 100 * *part;
  if (!labelledSlider(words, mark, &shown, 100 * low, 100 * high, "%.0f %%", tip, 0)) return false;
  *part = shown / 100;
  return true;
}

bool radius(const char* mark, int* pixels, const char* tip) {
  auto shown = static_cast<float>(*pixels);
  if (!labelledSlider("Radius", mark, &shown, 1, 256, "%.0f px", tip, kLogarithmic)) return false;
  *pixels = static_cast<int>(std::round(shown));
  return true;
}

/// For which lights: all, or those that are ticked.
void lights(const Parameters& of) {
  const std::vector<LightSetting>& all = of.studio.document().rig.lights;
  label("Lights");
  const std::string shown =
      of.edit.lights.empty() ? "all lights" : fmt::format("{}", fmt::join(of.edit.lights, ", "));
  const bool open = ImGui::BeginCombo("##lights", shown.c_str());
  markItem("parameters.lights");
  if (!open) return tooltip("Whose light is changed.");
  if (ImGui::Selectable("all lights", of.edit.lights.empty())) {
    Edit next = of.edit;
    next.lights.clear();
    of.change("Edit of all lights", std::move(next));
  }
  markItem("parameters.lights.all");
  for (const LightSetting& light : all) {
    const auto found = std::find(of.edit.lights.begin(), of.edit.lights.end(), light.light);
    const bool on = found != of.edit.lights.end();
    if (ImGui::Selectable(light.title().c_str(), on, ImGuiSelectableFlags_DontClosePopups)) {
      Edit next = of.edit;
      if (on)
        next.lights.erase(next.lights.begin() + (found - of.edit.lights.begin()));
      else
        next.lights.push_back(light.light);
      of.change("Lights of an edit", std::move(next));
    }
    markItem({"parameters.lights.", light.light});
  }
  ImGui::EndCombo();
}

/// What happens to the other lights.
void meaning(const Parameters& of) {
  label("Others");
  const float width = std::floor((ImGui::GetContentRegionAvail().x - px(10)) / 2);
  const auto button = [&](const char* words, Meaning meaning, const char* mark, const char* tip) {
    if (choiceButton(words, of.edit.meaning == meaning, width, mark, tip) && of.edit.meaning != meaning) {
      Edit next = of.edit;
      next.meaning = meaning;
      of.change(std::string("The other lights ") + words, std::move(next));
    }
  };
  button("give way", Meaning::Share, "parameters.share",
         "Share: what the light gets, the other lights lose, and the other way round. Under white lights the "
         "picture stays.");
  ImGui::SameLine(0, px(4));
  button("stay", Meaning::Add, "parameters.add",
         "Add: light is added or taken away; the other lights stay as they are. The picture gets brighter or "
         "darker.");
}

/// Of the first light that the edit is for.
std::span<const float> histogramFor(const Parameters& of) {
  const SolvedSet& set = *of.studio.set()->original;
  const int light = of.edit.lights.size() == 1 ? set.capture.lightIndex(of.edit.lights.front()) : -1;
  std::map<int, std::vector<float>>& kept = of.studio.editing.histograms;
  if (!kept.contains(light)) kept[light] = betaHistogram(set, light, kHistogramBins);
  return kept[light];
}

void fields(const Parameters& of, FillOperation fill) {
  if (percent("Part", "parameters.fill", &fill.value, 0, 2,
              "The light's part of the picture under white lights; 0 % takes it away."))
    of.preview("part", fill);
}

void fields(const Parameters& of, GainOperation gain) {
  bool changed = labelledSlider("Gain", "parameters.gain", &gain.gain, 0, 4, "x %.2f",
                                "The light's part times this.", 0);
  gain.gain = std::max(gain.gain, 0.F);
  changed |= percent("Offset", "parameters.offset", &gain.offset, -1, 1, "And so much more or less.");
  if (changed) of.preview("gain", gain);
}

void fields(const Parameters& of, CurveOperation curve) {
  const float width = ImGui::GetContentRegionAvail().x - px(6);
  if (curveWidget(curve.points, of.studio.editing.curve, histogramFor(of), ImVec2(width, px(kCurveHeight))))
    of.preview("curve", curve);
  if (ImGui::Button("Straight again", ImVec2(width, 0)) && !(curve == CurveOperation{})) {
    Edit next = of.edit;
    next.operation = CurveOperation{};
    of.change("Curve: straight again", std::move(next));
  }
  markItem("curve.reset");
  tooltip("The curve that changes nothing.");
}

void fields(const Parameters& of, InvertOperation /*none*/) {
  hint(of.edit.lights.size() == 2 || (of.edit.lights.empty() && of.studio.document().rig.lights.size() == 2)
           ? "The two lights change places."
           : "1 \u2212 \u03b2 of each light.");
}

void fields(const Parameters& of, BlurOperation blur) {
  if (radius("parameters.radius", &blur.radius, "Over how many pixels of the picture."))
    of.preview("radius", blur);
}

void fields(const Parameters& of, SharpenOperation sharpen) {
  bool changed = radius("parameters.radius", &sharpen.radius, "Of the details that become stronger.");
  changed |= percent("Amount", "parameters.amount", &sharpen.amount, 0, 4, "How much stronger.");
  sharpen.amount = std::max(sharpen.amount, 0.F);
  if (changed) of.preview("sharpen", sharpen);
}

void fields(const Parameters& of, const PictureOperation& picture) {
  label("File");
  const std::string name = std::filesystem::path(picture.file).filename().string();
  const float again = px(28);
  const float width = ImGui::GetContentRegionAvail().x - px(6) - again - px(4);
  if (ImGui::Button((name + "##file").c_str(), ImVec2(width, 0)))
    of.studio.actions.run("edits.choose_picture");
  markItem("parameters.file");
  tooltip((picture.file + "\nClick to choose another.").c_str());
  ImGui::SameLine(0, px(4));
  if (toggleButton(kIconReset, false, kAccent, again, "Read the file again: it was changed elsewhere."))
    setPictureOfEdit(of.studio, of.index, picture.file);
  markItem("parameters.read_again");
}

void fields(const Parameters& of, ShadowOperation shadow) {
  using Kind = ShadowOperation::Kind;
  label("Shadows");
  const bool open = ImGui::BeginCombo("##kind", kShadowWords.at(static_cast<size_t>(shadow.kind)));
  markItem("parameters.kind");
  for (size_t i = 0; open && i < kShadowWords.size(); ++i) {
    if (ImGui::Selectable(kShadowWords.at(i), static_cast<size_t>(shadow.kind) == i)) {
      Edit next = of.edit;
      shadow.kind = static_cast<Kind>(i);
      next.operation = shadow;
      of.change(std::string("Shadows: ") + kShadowWords.at(i), std::move(next));
    }
    markItem({"parameters.kind.", kShadowWords.at(i)});
  }
  if (open) ImGui::EndCombo();
  bool changed = percent("Amount", "parameters.amount", &shadow.amount, 0, 1, "From nothing to all of it.");
  shadow.amount = std::clamp(shadow.amount, 0.F, 1.F);
  if (shadow.kind == Kind::Soften)
    changed |= radius("parameters.radius", &shadow.radius, "Over how many pixels of the picture.");
  if (shadow.kind == Kind::Recolor) {
    label("Colour");
    Rgb codes = srgbFromLinear(shadow.color);
    if (ImGui::ColorEdit3("##colour", &codes.x, ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel)) {
      shadow.color = linearFromSrgb(codes);
      changed = true;
    }
    markItem("parameters.colour");
  }
  if (changed) of.preview("shadows", shadow);
}

}  // namespace

void drawEditParameters(EditingContext& studio, size_t index, bool all) {
  const std::shared_ptr<const Edit> edit = studio.document().edits.edits[index];
  const Parameters parameters{studio, index, *edit};
  ImGui::PushID("parameters");
  float opacity = edit->opacity;
  if (percent("Opacity", "edits.opacity", &opacity, 0, 1, "How much of the edit is seen.")) {
    Edit next = *edit;
    next.opacity = std::clamp(opacity, 0.F, 1.F);
    parameters.preview("opacity", std::move(next));
  }
  if (!all) return ImGui::PopID();
  lights(parameters);
  if (!std::holds_alternative<ShadowOperation>(edit->operation)) meaning(parameters);
  std::visit([&](const auto& operation) { fields(parameters, operation); }, edit->operation);
  drawEditPlace(studio, index);
  ImGui::PopID();
}

}  // namespace swaplight
