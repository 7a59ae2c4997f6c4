#include "ui/state/view_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include "core/base/json.h"
#include "ui/state/enum_names.h"

namespace swaplight {
namespace {

constexpr double kMinZoom = 0.01;
constexpr double kMaxZoom = 64;

const std::array<const char*, 5> kChannelNames = {"color", "red", "green", "blue", "luminance"};
// A picture smaller than the viewer sits in its middle; a larger one fills it.
double clampedCenter(double center, double pictureSize, double seen) {
  if (pictureSize <= seen) return pictureSize / 2;
  return std::clamp(center, seen / 2, pictureSize - seen / 2);
}

}  // namespace

ViewWindow ViewState::window(int pictureWidth, int pictureHeight, int width, int height) const {
  const double shown = fit ? fitZoom(pictureWidth, pictureHeight, width, height) : zoom;
  const double seenX = width / shown;
  const double seenY = height / shown;
  const double x = clampedCenter(fit ? pictureWidth / 2.0 : centerX, pictureWidth, seenX);
  const double y = clampedCenter(fit ? pictureHeight / 2.0 : centerY, pictureHeight, seenY);
  return {x - seenX / 2, y - seenY / 2, shown, width, height};
}

void ViewState::keep(const ViewWindow& window) {
  fit = false;
  zoom = window.zoom;
  centerX = window.pictureX(window.width / 2.0);
  centerY = window.pictureY(window.height / 2.0);
}

void ViewState::zoomAt(const ViewWindow& window, double windowX, double windowY, double factor) {
  ViewWindow next = window;
  next.zoom = std::clamp(window.zoom * factor, kMinZoom, kMaxZoom);
  next.left = window.pictureX(windowX) - windowX / next.zoom;
  next.top = window.pictureY(windowY) - windowY / next.zoom;
  keep(next);
}

void ViewState::pan(const ViewWindow& window, double dx, double dy) {
  ViewWindow next = window;
  next.left -= dx / window.zoom;
  next.top -= dy / window.zoom;
  keep(next);
}

void ViewState::showAt(const ViewWindow& window, double newZoom) {
  zoomAt(window, window.width / 2.0, window.height / 2.0, newZoom / window.zoom);
}

Json jsonFromViewState(const ViewState& state) {
  const ViewSettings& settings = state.settings;
  return Json{
      {"fit", state.fit},
      {"zoom", state.zoom},
      {"center", {state.centerX, state.centerY}},
      {"exposure_stops", settings.exposureStops},
      {"gamma", settings.gamma},
      {"channel", nameOfEnum(kChannelNames, settings.channel)},
      {"false_color", settings.falseColor},
      {"zebra", {{"on", settings.zebra.on}, {"low", settings.zebra.low}, {"high", settings.zebra.high}}},
      {"subject", nameOfEnum(kSubjectNames, state.subject.kind)},
      {"subject_index", state.subject.index},
      {"compare", jsonFromCompareState(state.compare)},
      {"pools", state.pools},
      {"probe", {{"on", state.probe}, {"side", state.probeSide}}},
      {"selected_light", state.selectedLight},
  };
}

ViewState viewStateFromJson(const Json& json) {
  ViewState state;
  try {
    state.fit = json.value("fit", true);
    state.zoom = std::clamp(json.value("zoom", 1.0), kMinZoom, kMaxZoom);
    if (json.contains("center")) {
      state.centerX = json["center"].at(0);
      state.centerY = json["center"].at(1);
    }
    ViewSettings& settings = state.settings;
    settings.exposureStops = std::clamp(json.value("exposure_stops", 0.0F), -20.0F, 20.0F);
    settings.gamma = std::clamp(json.value("gamma", 1.0F), 0.1F, 10.0F);
    settings.channel = enumOfName(kChannelNames, json.value("channel", ""), ViewChannel::Color);
    settings.falseColor = json.value("false_color", false);
    if (json.contains("zebra")) {
      settings.zebra.on = json["zebra"].value("on", false);
      settings.zebra.low = json["zebra"].value("low", settings.zebra.low);
      settings.zebra.high = json["zebra"].value("high", settings.zebra.high);
    }
    state.subject.kind = enumOfName(kSubjectNames, json.value("subject", ""), ViewSubject::Kind::Relit);
    state.subject.index = std::max(0, json.value("subject_index", 0));
    if (json.contains("compare")) state.compare = compareStateFromJson(json["compare"]);
    state.pools = json.value("pools", false);
    if (json.contains("probe")) {
      state.probe = json["probe"].value("on", false);
      state.probeSide = std::clamp(json["probe"].value("side", 1), 1, 101);
    }
    state.selectedLight = std::max(0, json.value("selected_light", 0));
  } catch (const std::exception&) {
    return {};
  }
  return state;
}

}  // namespace swaplight
