#include "ui/edits/edit_parameters.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/color/srgb.h"
#include "core/edit/apply/edited_set.h"
#include "core/edit/apply/gel_mixing.h"
#include "core/edit/apply/lamp_limits.h"
#include "core/edit/fields/field.h"
#include "core/edit/stack/beta_histogram.h"
#include "core/relight/rig.h"
#include "ui/control/light_edit.h"
#include "ui/curve/curve_widget.h"
#include "ui/edits/edit_list.h"
#include "ui/edits/edit_menu.h"
#include "ui/edits/edit_place.h"
#include "ui/edits/lamp_places.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

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

bool percent(const char* words, const char* mark, float* part, float low, float high, const char* tip,
             const char* format = "%.0f %%") {
  float shown = 100 * *part;
  if (!labelledSlider(words, mark, &shown, 100 * low, 100 * high, format, tip, 0)) return false;
  *part = shown / 100;
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
  if (!open) return tooltip("The lights that the edit changes.");
  if (ImGui::Selectable("all lights", of.edit.lights.empty())) {
    Edit next = of.edit;
    next.lights.clear();
    of.change("Edit of all lights", std::move(next));
  }
  markItem("parameters.lights.all");
  for (const LightSetting& light : all) {
    const auto found = std::find(of.edit.lights.begin(), of.edit.lights.end(), light.light);
    const bool on = found != of.edit.lights.end();
    const bool last = on && of.edit.lights.size() == 1;  // an edit of none is one of all: that is said above
    if (ImGui::Selectable(light.title().c_str(), on, ImGuiSelectableFlags_DontClosePopups) && !last) {
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

/// The same comes out of every light: what one of them gives to another is not seen.
bool lightsAreAlike(const Rig& rig) {
  const std::vector<Rgb> factors = rigFactors(rig);
  return std::all_of(factors.begin(), factors.end(),
                     [&](const Rgb& factor) { return factor == factors.front(); });
}

/// What happens to the other lights.
void energyMode(const Parameters& of) {
  label("Mode");
  const float most = 2 * std::max(ImGui::CalcTextSize("Keep total").x, ImGui::CalcTextSize("Add light").x);
  // Beside a scroll bar they begin before the column that the other values stand in.
  if (ImGui::GetContentRegionAvail().x < most + px(4 + 8)) ImGui::SameLine(0, px(8));
  const float width = std::floor((ImGui::GetContentRegionAvail().x - px(4)) / 2);
  const auto button = [&](const char* words, EnergyMode energy, const char* mark, const char* tip) {
    if (choiceButton(words, of.edit.energy == energy, width, mark, tip) && of.edit.energy != energy) {
      Edit next = of.edit;
      next.energy = energy;
      of.change(std::string("Mode: ") + words, std::move(next));
    }
  };
  button("Keep total", EnergyMode::Redistribute, "parameters.share",
         "What the light gains, the other lights lose, and vice versa. With every light at unit white the "
         "picture does not change.");
  ImGui::SameLine(0, px(4));
  button("Add light", EnergyMode::Add, "parameters.add",
         "Adds or removes light; the other lights do not change. The picture gets brighter or darker.");
  if (of.edit.energy == EnergyMode::Redistribute && lightsAreAlike(of.studio.document().rig)) {
    ImGui::PushTextWrapPos(0);
    hint("Not seen now: all lights have one colour and level.");
    ImGui::PopTextWrapPos();
    markItem("parameters.not_seen");
  }
}

/// Of the first light that the edit is for.
std::span<const float> histogramFor(const Parameters& of) {
  const SolvedSet& set = *of.studio.set()->original;
  const int light = of.edit.lights.size() == 1 ? set.capture.lightIndex(of.edit.lights.front()) : -1;
  std::map<int, std::vector<float>>& kept = of.studio.editing.histograms;
  if (!kept.contains(light)) kept[light] = betaHistogram(set, light, kHistogramBins);
  return kept[light];
}

// A control for one value of an edit, as its field describes it. True where it was changed; steps of their
// own (a reset, a choice) are taken at once.

std::string markOf(const char* key) {
  return std::string("parameters.") + key;
}

const char* formatOf(Scale::Unit unit) {
  switch (unit) {
    case Scale::Unit::Factor:
      return "x %.2f";
    case Scale::Unit::Percent:
      return "%.0f %%";
    case Scale::Unit::Pixels:
      return "%.1f px";
    case Scale::Unit::Count:
      return "%.0f";
    case Scale::Unit::Degrees:
      return "%.0f\u00b0";
    case Scale::Unit::Widths:
      return "%.1f widths";
  }
  return "";
}

template <typename Owner>
bool control(const Parameters& /*of*/, const Field<Owner, float>& field, float& value) {
  const Scale& scale = field.scale;
  const bool percents = scale.unit == Scale::Unit::Percent;
  const char* format = scale.zero && value == 0 ? scale.zero : percents ? "%.0f %%" : formatOf(scale.unit);
  const std::string mark = markOf(field.key);
  const bool changed = percents ? percent(field.label, mark.c_str(), &value, scale.sliderLeast,
                                          scale.sliderMost, field.tip, format)
                                : labelledSlider(field.label, mark.c_str(), &value, scale.sliderLeast,
                                                 scale.sliderMost, format, field.tip, 0);
  value = std::clamp(value, static_cast<float>(scale.least), static_cast<float>(scale.most));
  return changed;
}

/// Whole numbers.
template <typename Owner>
bool control(const Parameters& /*of*/, const Field<Owner, int>& field, int& value) {
  auto shown = static_cast<float>(value);
  if (!labelledSlider(field.label, markOf(field.key).c_str(), &shown, field.scale.sliderLeast,
                      field.scale.sliderMost, field.scale.unit == Scale::Unit::Count ? "%.0f" : "%.0f px",
                      field.tip, kLogarithmic))
    return false;
  value = static_cast<int>(std::round(shown));
  return true;
}

template <typename Owner>
bool control(const Parameters& of, const Field<Owner, PointList>& field, PointList& points) {
  const float width = ImGui::GetContentRegionAvail().x - px(6);
  const bool changed = curveWidget(points, of.studio.editing.curve,
                                   {ImVec2(width, px(kCurveHeight)), histogramFor(of), "curve",
                                    "Horizontal: beta, the light's share of the pixel; vertical: the new "
                                    "beta. Behind: histogram of beta."});
  if (ImGui::Button("Reset curve", ImVec2(width, 0)) && points != Owner().*field.member) {
    Edit next = of.edit;
    std::get<Owner>(next.operation).*field.member = Owner().*field.member;
    of.change("Reset curve", std::move(next));
  }
  markItem("curve.reset");
  tooltip("A straight line: no change.");
  return changed;
}

template <typename Owner>
bool control(const Parameters& of, const Field<Owner, std::string>& field, const std::string& file) {
  label(field.label);
  const std::string name = std::filesystem::path(file).filename().string();
  const float again = px(28);
  const float width = ImGui::GetContentRegionAvail().x - px(6) - again - px(4);
  if (ImGui::Button((name + "##file").c_str(), ImVec2(width, 0)))
    of.studio.actions.run("edits.choose_picture");
  markItem({"parameters.", field.key});
  tooltip((file + "\nClick to choose another file.").c_str());
  ImGui::SameLine(0, px(4));
  if (toggleButton(kIconReset, false, kAccent, again, "Reload: the file was changed in another program."))
    setPictureOfEdit(of.studio, of.index, file);
  markItem("parameters.read_again");
  return false;
}

template <typename Owner>
bool control(const Parameters& /*of*/, const Field<Owner, Rgb>& field, Rgb& color) {
  label(field.label);
  Rgb codes = srgbFromLinear(color);
  const bool changed = ImGui::ColorEdit3((std::string("##") + field.key).c_str(), &codes.x,
                                         ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel);
  if (changed) color = linearFromSrgb(codes);
  markItem({"parameters.", field.key});
  tooltip(field.tip);
  return changed;
}

template <typename Owner, typename Choice>
requires std::is_enum_v<Choice>
bool control(const Parameters& of, const Field<Owner, Choice>& field, Choice& choice) {
  label(field.label);
  const bool open = ImGui::BeginCombo("##choice", field.titles[static_cast<size_t>(choice)]);
  markItem({"parameters.", field.key});
  if (!open) tooltip(field.tip);
  for (size_t i = 0; open && i < field.titles.size(); ++i) {
    if (ImGui::Selectable(field.titles[i], static_cast<size_t>(choice) == i)) {
      Edit next = of.edit;
      std::get<Owner>(next.operation).*field.member = choice = static_cast<Choice>(i);
      of.change(std::string(field.label) + ": " + field.titles[i], std::move(next));
    }
    markItem({"parameters.", field.key, ".", field.titles[i]});
  }
  if (open) ImGui::EndCombo();
  return false;
}

/// What nobody can know of what an edit of lamps makes.
void warnings(const Parameters& of, const PreparedEdit& prepared) {
  const EditStack& stack = of.studio.document().edits;
  const EditedLights all = editedLights(*of.studio.set()->original, stack);
  EarlierEdits earlier;
  for (size_t i = 0; i < of.index; ++i)
    if (auto edit = of.studio.edits.prepared(*stack.edits[i])) earlier.push_back(std::move(edit));
  for (const std::string& warning : lampWarnings(prepared, all, earlier)) {
    ImGui::PushStyleColor(ImGuiCol_Text, kChanged);
    ImGui::TextWrapped("%s", warning.c_str());
    ImGui::PopStyleColor();
    markItem("parameters.lamp.warning");
  }
}

/// Of a lamp that is placed: where the others stood, and what is missing.
void placeHints(const Parameters& of) {
  if (const auto prepared = of.studio.edits.prepared(of.edit)) {
    if (prepared->placed.size() == 1) hint("Or drag the lamp in the picture.");
    warnings(of, *prepared);
  }
  drawLampPlaces(of.studio, of.edit);
}

/// Of edits of lamps: what the hand can do in the picture, and what nobody can know.
template <LampOperation T>
void lampHints(const Parameters& of) {
  const auto prepared = of.studio.edits.prepared(of.edit);
  if (!prepared || prepared->lamps.empty()) return;
  if constexpr (RingOperation<T>)
    hint(prepared->lamps.size() == 1 ? "Or drag the ring in the picture."
                                     : "Of one light alone it is a ring in the picture, too.");
  else if constexpr (DraggedOperation<T>)
    hint(prepared->lamps.size() == 1 ? "Or drag the lamp in the picture."
                                     : "One light's lamp can be dragged in the picture, too.");
  warnings(of, *prepared);
}

template <LightOperation T>
void fields(const Parameters& of, T operation) {
  const char* changed = nullptr;
  forEachField(operation, [&](const auto& field, auto& value) {
    const bool shown = *field.label && (!field.applies || field.applies(operation));
    if (shown && control(of, field, value)) changed = field.label;
  });
  if (changed) of.preview(changed, operation);
  if constexpr (LampOperation<T>) lampHints<T>(of);
  if constexpr (std::is_same_v<T, PlaceOperation>) placeHints(of);
  if (!swapsTwoLights(operation)) return;
  const size_t all = of.studio.document().rig.lights.size();
  hint(of.edit.lights.size() == 2 || (of.edit.lights.empty() && all == 2) ? "The two lights change places."
                                                                          : "1 \u2212 beta of each light.");
}

/// Which end is which, and what it is now.
void unknownGel(const EditingContext& studio, UnknownGelOperation operation) {
  const SolvedSet& set = *studio.set()->original;
  if (!solvedGel(set)) return;
  const auto at = [&](float position) {
    operation.position = position;
    return gelMixing(set, operation).color;
  };
  const Rgb now = at(operation.position), nearest = at(0), farthest = at(1);
  const auto warmth = [](const Rgb& color) { return color.r / std::max(color.b, 1e-6F); };
  const bool warmer = warmth(farthest) > warmth(nearest);
  colorChip("##gel", srgbFromLinear(now / std::max({now.r, now.g, now.b, 1e-6F})),
            ImVec2(ImGui::GetFrameHeight(), ImGui::GetFrameHeight()), "The gel's colour");
  ImGui::SameLine(0, px(8));
  ImGui::PushTextWrapPos();
  hint(fmt::format("{} \u2026 {} lamp: the photographs fit equally well.", warmer ? "Cooler" : "Warmer",
                   warmer ? "warmer" : "cooler"));
  ImGui::PopTextWrapPos();
  markState("parameters.gel", fmt::format("{:.3f}/{:.3f}/{:.3f}", now.r, now.g, now.b));
}

}  // namespace

void drawEditParameters(EditingContext& studio, size_t index, bool all) {
  const std::shared_ptr<const Edit> edit = studio.document().edits.edits[index];
  const Parameters parameters{studio, index, *edit};
  ImGui::PushID("parameters");
  float opacity = edit->opacity;
  if (percent("Opacity", "edits.opacity", &opacity, 0, 1, "Strength of the edit.")) {
    Edit next = *edit;
    next.opacity = std::clamp(opacity, 0.F, 1.F);
    parameters.preview("opacity", std::move(next));
  }
  if (!all) return ImGui::PopID();
  if (!actsOnAllLights(edit->operation)) lights(parameters);
  if (std::holds_alternative<RecolorOperation>(edit->operation)) hint("The same under all lights.");
  if (const auto* gel = std::get_if<UnknownGelOperation>(&edit->operation)) unknownGel(studio, *gel);
  if (usesHighlights(edit->operation) && studio.set()->original->highlights.empty()) hint(kNoHighlights);
  if (actsOnBeta(edit->operation)) energyMode(parameters);
  std::visit([&](const auto& operation) { fields(parameters, operation); }, edit->operation);
  drawEditPlace(studio, index);
  ImGui::PopID();
}

}  // namespace swaplight
