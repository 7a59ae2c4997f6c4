#include "ui/camera_look/filter_parameters.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/edit/mask/selection.h"
#include "core/relight/rig.h"
#include "ui/camera/camera_look_edit.h"
#include "ui/camera/key_matte.h"
#include "ui/curve/curve_widget.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kLabel = 92;
constexpr float kDot = 18;
constexpr float kCurveSide = 130;

/// A parameter of the filter in focus.
struct Parameter {
  ViewerContext& studio;
  size_t index;
  const FilterInput& input;
  const FilterValue& value;
  FileChooser& chooser;

  void set(const FilterValue& next, bool live) const {
    setFilterParameter(studio.editor, index, input, next, live);
  }
  [[nodiscard]] std::string mark(const char* part = "") const { return "look." + input.name + part; }
};

/// "%.3g stops"
std::string formatOf(const FilterInput& input) {
  std::string format = "%.3g";
  if (input.unit.empty()) return format;
  format += ' ';
  for (const char c : input.unit) format += c == '%' ? std::string("%%") : std::string(1, c);
  return format;
}

std::string tipOf(const FilterInput& input) {
  std::string tip = input.tooltip.empty() ? input.label : input.tooltip;
  if (input.low && input.high && input.type == FilterInputType::Float)
    tip += fmt::format("\n{} to {}{}", textFromFilterValue(*input.low), textFromFilterValue(*input.high),
                       input.unit.empty() ? "" : " " + input.unit);
  return tip;
}

float endOf(const std::optional<FilterValue>& end, size_t part, float otherwise) {
  if (!end) return otherwise;
  if (const auto* number = std::get_if<float>(&*end)) return *number;
  if (const auto* point = std::get_if<FilterPoint>(&*end)) return point->at(part);
  return otherwise;
}

bool slider(const Parameter& of, const char* part, float* value, size_t axis) {
  const float low = endOf(of.input.low, axis, std::min(0.0F, *value));
  const float high = endOf(of.input.high, axis, std::max(1.0F, *value));
  const bool changed = ImGui::SliderFloat((std::string("##") + part).c_str(), value, low, high,
                                          formatOf(of.input).c_str(), ImGuiSliderFlags_AlwaysClamp);
  markItem(of.mark(part));
  tooltip((tipOf(of.input) + "\nCtrl-click to type.").c_str());
  return changed;
}

void control(const Parameter& of, bool value) {
  bool next = value;
  if (ImGui::Checkbox("##on", &next)) of.set(next, false);
  markItem(of.mark());
  tooltip(tipOf(of.input).c_str());
}

void control(const Parameter& of, int value) {
  const std::vector<int>& values = of.input.values;
  const auto words = [&](size_t i) {
    return i < of.input.labels.size() ? of.input.labels[i] : std::to_string(values[i]);
  };
  const auto found = std::find(values.begin(), values.end(), value);
  const std::string shown =
      found == values.end() ? std::to_string(value) : words(static_cast<size_t>(found - values.begin()));
  const bool open = ImGui::BeginCombo("##choice", shown.c_str());
  markItem(of.mark());
  if (!open) return tooltip(tipOf(of.input).c_str());
  for (size_t i = 0; i < values.size(); ++i) {
    if (ImGui::Selectable(words(i).c_str(), values[i] == value)) of.set(values[i], false);
    markItem({of.mark("."), words(i)});
  }
  ImGui::EndCombo();
}

void control(const Parameter& of, float value) {
  if (slider(of, "", &value, 0)) of.set(value, true);
}

void control(const Parameter& of, FilterPoint value) {
  const float width = std::floor((ImGui::GetContentRegionAvail().x - px(kDot) - px(4)) / 2);
  bool changed = false;
  for (size_t axis = 0; axis < 2; ++axis) {
    if (axis == 1) ImGui::SameLine(0, px(4));
    ImGui::SetNextItemWidth(width);
    changed |= slider(of, axis == 0 ? ".x" : ".y", &value.at(axis), axis);
  }
  if (changed) of.set(value, true);
}

/// Numbers side by side in what is left of the line; whether one of them was changed.
bool numberRow(const Parameter& of, FilterVector& numbers, const std::string& mark) {
  const auto count = static_cast<float>(numbers.size());
  const float width = std::floor((ImGui::GetContentRegionAvail().x - px(kDot) - (count - 1) * px(4)) / count);
  bool changed = false;
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, px(4));
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(static_cast<int>(i));
    changed |= slider(of, (mark + '.' + std::to_string(i)).c_str(), &numbers[i], i);
    ImGui::PopID();
  }
  return changed;
}

void control(const Parameter& of, FilterVector value) {
  if (numberRow(of, value, "")) of.set(value, true);
}

void control(const Parameter& of, FilterMatrix value) {
  bool changed = false;
  for (size_t row = 0; row < value.size(); ++row) {
    if (row > 0) ImGui::SetCursorPosX(px(kLabel));
    ImGui::PushID(static_cast<int>(row));
    changed |= numberRow(of, value[row], '.' + std::to_string(row));
    ImGui::PopID();
  }
  if (changed) of.set(value, true);
}

void control(const Parameter& of, FilterCurve value) {
  const float width = ImGui::GetContentRegionAvail().x - px(kDot);
  const CurveLook look{ImVec2(width, px(kCurveSide)), {}, of.mark(), tipOf(of.input), kMostCurvePoints};
  if (curveWidget(value, of.studio.cameraLook.curves[of.input.name], look)) of.set(value, true);
}

/// In the numbers that the filter gets: of a filter of light they are linear.
void control(const Parameter& of, FilterColor value) {
  const bool changed =
      ImGui::ColorEdit3("##colour", value.data(), ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs);
  markItem(of.mark());
  tooltip((tipOf(of.input) + "\nClick to choose.").c_str());
  ImGui::SameLine();
  hint(fmt::format("{:.2g} {:.2g} {:.2g}", value[0], value[1], value[2]));
  if (changed) of.set(value, true);
}

/// The file of a picture.
void control(const Parameter& of, const std::string& value) {
  const std::filesystem::path file = value;
  const std::string words = value.empty() ? "Choose a picture \u2026" : file.filename().string();
  if (of.input.type != FilterInputType::Image) return hint("sound: not for pictures");
  if (ImGui::Button((words + "##picture").c_str(), ImVec2(ImGui::GetContentRegionAvail().x - px(kDot), 0)))
    of.chooser.ask({"A picture for " + of.input.label,
                    "Use",
                    {},
                    false,
                    "",
                    file.parent_path(),
                    [&editor = of.studio.editor, index = of.index,
                     input = of.input](const std::filesystem::path& chosen) {
                      if (index < editor.document().cameraLook.stages.size())
                        setFilterParameter(editor, index, input, std::filesystem::absolute(chosen).string(),
                                           false);
                    }});
  markItem(of.mark());
  tooltip((tipOf(of.input) + (value.empty() ? "" : "\n" + value)).c_str());
}

void drawParameter(const Parameter& of) {
  ImGui::PushID(of.input.name.c_str());
  ImGui::AlignTextToFramePadding();
  hint(of.input.label.empty() ? of.input.name : of.input.label);
  tooltip(tipOf(of.input).c_str());
  ImGui::SameLine(px(kLabel));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - px(kDot));
  std::visit([&](const auto& value) { control(of, value); }, of.value);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - px(kDot - 4));
  if (changedDot("##changed", of.value != of.input.standard, "Changed: click for the default."))
    of.set(of.input.standard, false);
  markItem(of.mark(".reset"));
  ImGui::PopID();
}

/// The picture through this filter and no other; what is exported stays the whole look.
void aloneButton(ViewerContext& studio, size_t index) {
  std::optional<size_t>& alone = studio.viewer.filterAlone;
  const bool on = alone == index;
  const float width = px(58);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  pushChosen(on);
  if (ImGui::Button("Alone", ImVec2(width, 0))) alone = on ? std::nullopt : std::optional(index);
  popChosen();
  markItem("camera_look.alone");
  tooltip("See the picture through this filter alone. Exports have the whole look all the same.");
}

/// Of a key filter: what it keeps becomes the selection, inside which edits of the lights stay.
void matteButton(ViewerContext& studio, const ResolvedStage& stage) {
  const Rig& rig = studio.document().rig;
  const std::optional<MaskShape> matte =
      keyMatteOf(stage, rig, rigFactors(*studio.colors.config(), rig, studio.set()->solved().colorSpace()));
  if (!matte) return;
  if (ImGui::Button("Select by this matte", ImVec2(ImGui::GetContentRegionAvail().x, 0))) {
    Document next = studio.document();
    next.selection = selectionWith({}, *matte, SelectHow::Replace);
    studio.editor.edit("Select by " + stage.filter->name, std::move(next));
  }
  markItem("camera_look.matte");
  tooltip(
      "What this key keeps becomes the selection: edits of the lights stay inside. It is taken of the set "
      "as it is lit now, in sRGB and before other filters, and stays when the lights change.");
}

}  // namespace

void drawFilterParameters(ViewerContext& studio, size_t index, FileChooser& chooser) {
  const FilterPipeline& look = studio.document().cameraLook;
  const FilterStage stage = look.stages.at(index);
  ResolvedStage resolved;
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(stageName(stage).c_str());
  ImGui::PopFont();
  aloneButton(studio, index);
  try {
    resolved = resolveStage(studio.seen.library(), stage, look.folder, look.name);
  } catch (const InputError& error) {
    ImGui::PushStyleColor(ImGuiCol_Text, kMute);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(error.what());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    return;
  }
  ImGui::PushTextWrapPos();
  hint(resolved.filter->description);
  ImGui::PopTextWrapPos();
  ImGui::PushID("parameters");
  for (size_t i = 0; i < resolved.values.size(); ++i)
    if (resolved.filter->inputs[i].type != FilterInputType::Event)
      drawParameter({studio, index, resolved.filter->inputs[i], resolved.values[i], chooser});
  ImGui::PopID();
  matteButton(studio, resolved);
}

}  // namespace swaplight
