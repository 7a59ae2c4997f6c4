#pragma once

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "core/session/document.h"

// Random values of the program's own types, within what their headers allow.

namespace swaplight::test {

inline int anyInt(int low, int high) {
  return *rc::gen::inRange(low, high + 1);
}
inline bool anyBool() {
  return anyInt(0, 1) == 1;
}
/// Of 2^20 steps; now and then an end of the range.
inline float anyFloat(float low, float high) {
  constexpr int kSteps = 1 << 20;
  const int step =
      *rc::gen::weightedOneOf<int>({{1, rc::gen::element(0, kSteps)}, {8, rc::gen::inRange(0, kSteps + 1)}});
  return low + (high - low) * (float(step) / kSteps);
}
inline Rgb anyRgb(float high) {
  return {anyFloat(0, high), anyFloat(0, high), anyFloat(0, high)};
}
/// Letters, quotes, a line's end, and characters of more than a byte.
inline std::string anyText(int longest = 12) {
  static const std::vector<std::string> kParts = {"a", "Z", "7", " ", "\"", "\\", "\n", "/", "é", "灯", "💡"};
  std::string text;
  for (int i = anyInt(0, longest); i > 0; --i) text += kParts[size_t(anyInt(0, int(kParts.size()) - 1))];
  return text;
}
template <typename Value, typename Make>
std::vector<Value> anyList(int longest, const Make& make) {
  std::vector<Value> list;
  for (int i = anyInt(0, longest); i > 0; --i) list.push_back(make());
  return list;
}

inline LightColor anyLightColor() {
  using Kind = LightColor::Kind;
  LightColor color;
  color.kind = Kind(anyInt(0, int(Kind::Kelvin)));
  if (color.kind == Kind::Hex)
    for (int c = 0; c < 3; ++c) color.value[c] = float(anyInt(0, 255)) / 255;
  if (color.kind == Kind::LinearRgb) color.value = anyRgb(8);
  if (color.kind == Kind::Hsv) color.value = anyRgb(1);
  if (color.kind == Kind::Kelvin) color.kelvin = anyFloat(1000, 25000);
  color.gel = *rc::gen::element<std::string>("", "L201", "L106", "R02");
  color.green = anyBool() ? anyFloat(-1, 1) : 0;
  return color;
}

inline LightSetting anyLightSetting(int number) {
  LightSetting light;
  light.light = "light" + std::to_string(number);
  light.color = anyLightColor();
  light.stops = anyFloat(-30, 30);
  light.multiplier = anyFloat(0, 100);
  light.on = anyBool(), light.solo = anyBool(), light.mute = anyBool(), light.ratioLock = anyBool();
  light.role = Role(anyInt(0, int(Role::Other)));
  light.label = anyText(), light.group = anyText(3);
  return light;
}

inline Rig anyRig() {
  Rig rig;
  const int lights = anyInt(0, 5);
  for (int i = 0; i < lights; ++i) rig.lights.push_back(anyLightSetting(i));
  rig.groups = anyList<LightGroup>(3, [] {
    return LightGroup{"g" + anyText(4), anyFloat(-30, 30), anyBool()};
  });
  rig.ambient = anyFloat(0, 10);
  return rig;
}

inline std::vector<std::array<float, 2>> anyPoints() {
  return anyList<std::array<float, 2>>(5, [] {
    return std::array<float, 2>{anyFloat(-100, 5000), anyFloat(-100, 5000)};
  });
}

inline MaskShape anyShape(int deep = 1) {
  const auto at = [] { return anyFloat(-1000, 9000); };
  const auto size = [] { return anyFloat(1, 4000); };
  MaskShape out;
  out.invert = anyBool();
  switch (anyInt(0, 10 + (deep > 0))) {
    case 0:
      out.shape = RectangleShape{at(), at(), size(), size(), size()};
      break;
    case 1:
      out.shape = EllipseShape{at(), at(), size(), size(), size()};
      break;
    case 2:
      out.shape = PolygonShape{anyPoints(), size()};
      break;
    case 3:
      out.shape = LinearGradientShape{at(), at(), at(), at()};
      break;
    case 4:
      out.shape = RadialGradientShape{at(), at(), size(), size()};
      break;
    case 5:
      out.shape = PatternShape{PatternShape::Kind(anyInt(0, 2)), size(), at(), anyFloat(0, 1), size()};
      break;
    case 6:
      out.shape = TextShape{anyText(), at(), at(), size(), size()};
      break;
    case 7:
      out.shape = ShadowShape{anyText(), false, 0, 0};
      break;
    case 8:
      out.shape = ShadowShape{anyText(), true, anyInt(0, 4000), anyInt(0, 4000)};
      break;
    case 9:
      out.shape = SimilarShape{SimilarShape::By(anyInt(0, 1)), anyInt(0, 4000), anyInt(0, 4000),
                               anyFloat(0, 1), anyBool()};
      break;
    case 10:
      out.shape = KeyShape{KeyShape::By(anyInt(0, 1)),
                           {anyFloat(0, 1), anyFloat(0, 1), anyFloat(0, 1)},
                           anyFloat(0, 1),
                           anyFloat(0, 1),
                           {{anyText(), {anyFloat(0, 10), anyFloat(0, 10), anyFloat(0, 10)}}},
                           anyFloat(0, 10)};
      break;
    default: {
      std::vector<SelectionPart> parts = anyList<SelectionPart>(3, [&] {
        return SelectionPart{anyShape(deep - 1), SelectionPart::Combine(anyInt(0, 2))};
      });
      out.shape =
          SelectionShape{std::make_shared<const std::vector<SelectionPart>>(std::move(parts)), size()};
    }
  }
  return out;
}

inline Operation anyOperation() {
  switch (anyInt(0, 10)) {
    case 0:
      return FillOperation{anyFloat(0, 100)};
    case 1:
      return GainOperation{anyFloat(0, 1000), anyFloat(-100, 100)};
    case 2:
      return CurveOperation{{{0, anyFloat(0, 4)}, {anyFloat(.1F, .9F), anyFloat(0, 4)}, {1, anyFloat(0, 4)}}};
    case 3:
      return InvertOperation{};
    case 4:
      return BlurOperation{anyInt(1, 256)};
    case 5:
      return SharpenOperation{anyInt(1, 256), anyFloat(0, 100)};
    case 9:
      return PlaceOperation{anyFloat(-180, 180), anyFloat(-90, 90), anyFloat(0, 1000), anyFloat(0, 4)};
    case 8:
      return ShineOperation{anyFloat(0, 3)};
    case 7:
      return UnknownGelOperation{anyFloat(0, 1), UnknownGelOperation::Lamps(anyInt(0, 1))};
    case 6:
      return RecolorOperation{RecolorOperation::Kind(anyInt(0, 1)),
                              anyFloat(-180, 180),
                              anyFloat(0, 4),
                              anyFloat(0, 16),
                              anyRgb(4),
                              anyRgb(4)};
    default:
      return ShadowOperation{ShadowOperation::Kind(anyInt(0, 4)), anyFloat(0, 1), anyInt(1, 256), anyRgb(4)};
  }
}

inline Edit anyEdit() {
  Edit edit;
  edit.name = anyText();
  edit.on = anyBool();
  edit.opacity = anyFloat(0, 1);
  edit.lights = anyList<std::string>(3, [] { return anyText(); });
  edit.energy = anyBool() ? EnergyMode::Redistribute : EnergyMode::Add;
  edit.operation = anyOperation();
  edit.mask = anyList<MaskShape>(3, [] { return anyShape(); });
  return edit;
}

inline EditStack anyEditStack() {
  EditStack stack;
  stack.width = anyInt(1, 9000), stack.height = anyInt(1, 9000);
  for (const char* name : {"Lamp", "moon_2"})  // what lights may be called
    if (anyBool()) stack.newLights.emplace_back(name);
  for (int i = anyInt(0, 4); i > 0; --i) stack.append(anyEdit());
  for (int i = anyInt(0, 2); i > 0; --i) stack.shadowThresholds[anyText()] = anyFloat(.01F, .99F);
  for (int i = anyInt(0, 3); i > 0; --i)
    stack.shadowMarks[anyText()].push_back(
        {ShadowMark::Kind(anyInt(0, 1)), anyInt(0, 9000), anyInt(0, 9000)});
  for (int i = anyInt(0, 3); i > 0; --i) {
    LampPlace& place = stack.lampPlaces[anyText()] = {anyFloat(-180, 180), anyFloat(-90, 90), {}, {}};
    if (anyBool()) place.distance = anyFloat(.1F, 1000);
    if (anyBool()) place.stops = anyFloat(-20, 20);
  }
  return stack;
}

inline SolveOptions anySolveOptions() {
  SolveOptions options;
  options.model = Model(anyInt(0, int(Model::Transport)));
  if (anyBool()) options.noise = SensorNoise{anyFloat(.0001F, .1F), anyFloat(100, 1e5F)};
  options.colorUncertainty = anyBool() ? -1 : anyFloat(0, 1);
  options.solveAmbient = anyBool(), options.refineColors = anyBool(), options.align = Remedy(anyInt(0, 2));
  return options;
}

/// What JSON keeps as it is: whole numbers of choices become their filter's when it is known.
inline FilterValue anyFilterValue() {
  const auto any = [] { return anyFloat(-4, 4); };
  switch (anyInt(0, 7)) {
    case 0:
      return anyBool();
    case 1:
      return anyFloat(-100, 100);
    case 2:
      return FilterPoint{anyFloat(0, 1), anyFloat(0, 1)};
    case 3:
      return FilterColor{anyFloat(0, 1), anyFloat(0, 1), anyFloat(0, 1), anyFloat(0, 1)};
    case 4:
      return FilterVector{any(), any(), any()};
    case 5:
      return FilterMatrix{{any(), any(), any()}, {any(), any(), any()}, {any(), any(), any()}};
    case 6:
      return FilterCurve{{0, any()}, {anyFloat(0.1F, 0.9F), any()}, {1, any()}};
    default:
      return anyText();
  }
}

/// Nothing, or at least one filter.
inline FilterPipeline anyCameraLook() {
  FilterPipeline look;
  look.stages = anyList<FilterStage>(4, [] {
    FilterStage stage{"f" + anyText(), anyBool(), {}, {}};
    for (int i = anyInt(0, 3); i > 0; --i) stage.parameters["p" + anyText(4)] = anyFilterValue();
    return stage;
  });
  if (look.stages.empty()) return look;
  look.name = "look " + anyText();
  if (anyBool()) look.folder = "/looks/warm";
  return look;
}

/// A document, but for files and what a colour configuration has names for.
inline Document anyDocument() {
  Document document;
  document.source = "/sets/" + std::string(1, char('a' + anyInt(0, 25))) + "/capture.json";
  document.solve = anySolveOptions();
  document.edits = anyEditStack();
  document.rig = anyRig();
  document.display = {anyText(), anyText(), anyBool() ? std::optional(anyText()) : std::nullopt};
  document.cameraLook = anyCameraLook();
  const int looks = anyInt(0, 2);
  for (int i = 0; i < looks; ++i)
    document.looks.push_back({"look " + std::to_string(i), anyText(), anyRig()});
  return document;
}

}  // namespace swaplight::test
