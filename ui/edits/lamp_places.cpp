#include "ui/edits/lamp_places.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/lower_case.h"
#include "ui/edits/edit_list.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kSliderDistance = 10;  // widths
constexpr float kSliderStops = 8;
// Where the first lamps that are told usually stand: key, fill, back, from above. Never two in one place, nor
// three in one line, which would tell nothing.
constexpr std::array<LampPlace, 4> kFirstPlaces{
    {{-45, 30, {}, {}}, {45, 15, {}, {}}, {160, 45, {}, {}}, {0, 75, {}, {}}}};

LampPlace firstPlace(const LampPlaces& told) {
  const auto isFree = [&](const LampPlace& place) {
    return std::none_of(told.begin(), told.end(), [&](const auto& other) {
      return other.second.azimuth == place.azimuth && other.second.elevation == place.elevation;
    });
  };
  if (const auto* free = std::find_if(kFirstPlaces.begin(), kFirstPlaces.end(), isFree);
      free != kFirstPlaces.end())
    return *free;
  LampPlace next = kFirstPlaces.front();
  while (!isFree(next)) next.azimuth += 20;  // ends before it has gone round: lamps are few
  return next;
}

bool isMetered(const LampPlaces& places) {
  return std::any_of(places.begin(), places.end(), [](const auto& told) { return told.second.stops; });
}

/// As the sliders show it: no digits that nobody has chosen.
double shown(float value, double steps) {
  return std::round(double{value} * steps) / steps;
}

/// The document's places, while one of them is being changed.
struct Telling {
  EditingContext& studio;
  const std::string& light;

  [[nodiscard]] const LampPlaces& places() const { return studio.document().edits.lampPlaces; }
  void preview(const char* what, const LampPlace& place) const {
    Document next = studio.document();
    next.edits.lampPlaces[light] = place;
    studio.editor.preview("The lamp of " + light + ": " + what, std::move(next));
  }
  void change(const std::string& step, LampPlaces places) const {
    EditStack edits = studio.document().edits;
    edits.lampPlaces = std::move(places);
    editEdits(studio, step, std::move(edits));
  }
};

/// Which light's lamp, and whether its place has been told.
void chooseLamp(EditingContext& studio, std::string& chosen) {
  const LampPlaces& told = studio.document().edits.lampPlaces;
  const auto words = [&](const std::string& light) {
    return light + (told.contains(light) ? "" : " (not told)");
  };
  ImGui::AlignTextToFramePadding();
  hint("Lamp of");
  ImGui::SameLine(px(kLabelWidth));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - px(6));
  const bool open = ImGui::BeginCombo("##lamp", words(chosen).c_str());
  markItem("places.lamp");
  if (!open) return tooltip("Whose lamp's place is told below.");
  for (const Light& light : studio.set()->original->capture.lights) {
    if (ImGui::Selectable(words(light.name).c_str(), light.name == chosen)) chosen = light.name;
    markItem({"places.lamp.", light.name});
  }
  ImGui::EndCombo();
}

void toldOrNot(const Telling& telling) {
  const bool told = telling.places().contains(telling.light);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - px(10)) / 2);
  LampPlaces places = telling.places();
  if (choiceButton("Not known", !told, width, "places.unknown",
                   "Nobody knows where this lamp stood: the surfaces are found by the others.") &&
      places.erase(telling.light) > 0)
    telling.change("The lamp of " + telling.light + ": not known", places);
  ImGui::SameLine(0, px(4));
  if (choiceButton("Stood there", told, width, "places.known", "Its place is told below.") && !told) {
    const LampPlace first = firstPlace(places);
    LampPlace& place = places[telling.light] = first;
    if (isMetered(telling.places())) place.stops = 0;
    telling.change("The lamp of " + telling.light + ": place", places);
  }
}

void placeSliders(const Telling& telling) {
  LampPlace place = telling.places().at(telling.light);
  auto side = static_cast<float>(place.azimuth);
  auto height = static_cast<float>(place.elevation);
  auto distance = static_cast<float>(place.distance.value_or(0));
  const char* changed = nullptr;
  if (labelledSlider(
          "Side", "places.side", &side, -180, 180, "%.0f\u00b0",
          "Degrees to the right of the camera, seen from the set: -90 is left, 180 behind the set."))
    changed = "side";
  if (labelledSlider("Height", "places.height", &height, -90, 90, "%.0f\u00b0",
                     "Degrees above the line from the set to the camera."))
    changed = "height";
  if (labelledSlider(
          "Distance", "places.distance", &distance, 0, kSliderDistance, distance == 0 ? "far" : "%.1f widths",
          "From the middle of the set, in widths of what the picture shows there: a set that is 3 m "
          "wide, a lamp 6 m away: 2. 0: far away, as the sun. A lamp nearer than 2 tells nothing of "
          "the surfaces."))
    changed = "distance";
  if (place.stops) {
    auto stops = static_cast<float>(*place.stops);
    if (labelledSlider(
            "Meter", "places.stops", &stops, -kSliderStops, kSliderStops, "%+.1f st",
            "What an incident meter with a flat disc reads in the middle of the set when it points "
            "to this lamp, over any level that all lamps share."))
      changed = "meter";
    place.stops = shown(stops, 10);
  }
  if (!changed) return;
  place.azimuth = shown(side, 1);
  place.elevation = shown(height, 1);
  place.distance.reset();
  if (const double widths = shown(distance, 10); widths > 0) place.distance = widths;
  telling.preview(changed, place);
}

void meterToggle(const Telling& telling) {
  bool metered = isMetered(telling.places());
  if (ImGui::Checkbox("Metered##places", &metered)) {
    LampPlaces places = telling.places();
    for (auto& [light, place] : places) place.stops = metered ? std::optional<double>(0) : std::nullopt;
    telling.change(metered ? "Lamps metered" : "Lamps not metered", places);
  }
  markItem("places.metered");
  tooltip(
      "Somebody has metered the lamps: that tells how surfaces are turned better than the lights' own bright "
      "pixels do.");
}

/// What is missing, or goes on.
void drawProgress(const EditingContext& studio, const Edit& edit) {
  if (const auto missing = studio.edits.whyNotPlaced(edit)) {
    ImGui::PushStyleColor(ImGuiCol_Text, kChanged);
    ImGui::TextWrapped("%s", withCapital(*missing).c_str());
    ImGui::PopStyleColor();
    markItem("places.missing");
  } else if (studio.edits.findingShadows() || studio.edits.findingSurfaces()) {
    hint(studio.edits.findingSurfaces() ? "Finding how surfaces are turned \u2026"
                                        : "Finding shadows \u2026");
    markItem("places.finding");
  }
}

}  // namespace

void drawLampPlaces(EditingContext& studio, const Edit& edit) {
  const auto& lights = studio.set()->original->capture.lights;
  std::string& chosen = studio.editing.placedLamp;
  if (std::none_of(lights.begin(), lights.end(), [&](const Light& light) { return light.name == chosen; }))
    chosen = lights.front().name;
  ImGui::PushID("places");
  ImGui::Separator();
  hint("Where the lamps stood");
  tooltip("How the surfaces are turned is found by the lights of three lamps or more whose places are told.");
  drawProgress(studio, edit);  // first: what is missing is to be seen without scrolling
  chooseLamp(studio, chosen);
  const Telling telling{studio, chosen};
  toldOrNot(telling);
  if (telling.places().contains(chosen)) placeSliders(telling);
  if (!telling.places().empty()) meterToggle(telling);
  ImGui::PopID();
}

}  // namespace swaplight
