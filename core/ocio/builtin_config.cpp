#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "core/image/half.h"
#include "core/ocio/camera_spaces.h"
#include "core/ocio/color_config_impl.h"
#include "core/ocio/tone_curve.h"

namespace swaplight {
namespace {

OCIO::TransformRcPtr builtin(const char* style, bool inverse = false) {
  const auto transform = OCIO::BuiltinTransform::Create();
  transform->setStyle(style);
  if (inverse) transform->setDirection(OCIO::TRANSFORM_DIR_INVERSE);
  return transform;
}

OCIO::TransformRcPtr group(std::initializer_list<OCIO::TransformRcPtr> steps) {
  const auto transform = OCIO::GroupTransform::Create();
  for (const auto& step : steps) transform->appendTransform(step);
  return transform;
}

/// ACES2065-1 to linear Rec.709: AP0 to AP1, then Bradford from D60 to D65.
OCIO::TransformRcPtr rec709FromAces() {
  return group({builtin("ACEScg_to_ACES2065-1", true), builtin("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD")});
}

OCIO::TransformRcPtr acesFromRec709() {
  return group({builtin("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD", true), builtin("ACEScg_to_ACES2065-1")});
}

/// Rows of a 3 x 3 matrix.
OCIO::MatrixTransformRcPtr matrixOf(const std::array<double, 9>& rows) {
  double m[16] = {};
  for (size_t row = 0; row < 3; ++row) std::copy_n(rows.data() + 3 * row, 3, m + 4 * row);
  m[15] = 1;
  const auto matrix = OCIO::MatrixTransform::Create();
  matrix->setMatrix(m);
  return matrix;
}

OCIO::TransformRcPtr inverseOf(const OCIO::TransformRcPtr& transform) {
  transform->setDirection(OCIO::TRANSFORM_DIR_INVERSE);
  return transform;
}

/// Linear Rec.709 to CIE XYZ with white D65 (ITU-R BT.709-6).
OCIO::TransformRcPtr xyzFromRec709() {
  return matrixOf({0.41239079926595934, 0.357584339383878, 0.1804807884018343,   //
                   0.21263900587151027, 0.715168678767756, 0.07219231536073371,  //
                   0.01933081871559182, 0.11919477979462598, 0.9505321522496607});
}

/// Linear Rec.2020 to CIE XYZ with white D65 (ITU-R BT.2020-2).
OCIO::TransformRcPtr xyzFromRec2020() {
  return matrixOf({0.6369580483012914, 0.14461690358620832, 0.1688809751641721,  //
                   0.2627002120112671, 0.6779980715188708, 0.05930171646986196,  //
                   0, 0.028072693049087428, 1.060985057710791});
}

/// IEC 61966-2-1, encoded to linear; mirrored at zero it would be wrong for HDR, so negatives go on linearly.
OCIO::TransformRcPtr linearFromSrgb() {
  const auto curve = OCIO::ExponentWithLinearTransform::Create();
  const double gamma[4] = {2.4, 2.4, 2.4, 1};
  const double offset[4] = {0.055, 0.055, 0.055, 0};
  curve->setGamma(gamma);
  curve->setOffset(offset);
  curve->setNegativeStyle(OCIO::NEGATIVE_LINEAR);
  return curve;
}

struct Space {
  const char* name;
  const char* family;
  const char* description;
  OCIO::TransformRcPtr toReference;  ///< none: it is the reference, or data
  std::initializer_list<const char*> aliases;
};

void addSpace(const OCIO::ConfigRcPtr& config, const Space& space) {
  const auto colorSpace = OCIO::ColorSpace::Create(OCIO::REFERENCE_SPACE_SCENE);
  colorSpace->setName(space.name);
  colorSpace->setFamily(space.family);
  colorSpace->setDescription(space.description);
  colorSpace->setBitDepth(OCIO::BIT_DEPTH_F32);
  colorSpace->setIsData(std::string(space.name) == "raw");
  for (const char* alias : space.aliases) colorSpace->addAlias(alias);
  if (space.toReference) colorSpace->setTransform(space.toReference, OCIO::COLORSPACE_DIR_TO_REFERENCE);
  config->addColorSpace(colorSpace);
}

/// Scene-linear Rec.709 to the display's CIE XYZ.
void addViewTransform(const OCIO::ConfigRcPtr& config, const char* name,
                      const OCIO::TransformRcPtr& transform) {
  const auto view = OCIO::ViewTransform::Create(OCIO::REFERENCE_SPACE_SCENE);
  view->setName(name);
  view->setTransform(transform, OCIO::VIEWTRANSFORM_DIR_FROM_REFERENCE);
  config->addViewTransform(view);
}

/// A curve a channel, sampled at every half float: what lies between two of them is interpolated.
OCIO::TransformRcPtr curve(double (*function)(double)) {
  constexpr unsigned kHalves = 65536;
  constexpr float kLargest = 65504;
  const auto table = OCIO::Lut1DTransform::Create(kHalves, true);
  for (unsigned i = 0; i < kHalves; ++i) {
    const auto bits = static_cast<uint16_t>(i);
    float light = 0;
    floatFromHalf(&bits, &light, 1);
    light = std::isnan(light) ? 0 : std::clamp(light, -kLargest, kLargest);
    const auto value = static_cast<float>(function(light));
    table->setValue(i, value, value, value);
  }
  return table;
}

/// Light times a factor.
OCIO::TransformRcPtr scale(double factor) {
  return matrixOf({factor, 0, 0, 0, factor, 0, 0, 0, factor});
}

/// AgX, as Blender's (T. Sobotka; E. Chow, AgX_LUT_Gen, 2023): Rec.2020's primaries are drawn in towards
/// white and turned a little, so that a channel's curve takes bright saturated light to white without a break
/// of hue; after it they are drawn out again. Without its guard rail and its mix of hues, which need a table:
/// light that is outside the monitor's primaries afterwards is cut off (by less than 0.01 of what Rec.709
/// light gives).
OCIO::TransformRcPtr agx() {
  const auto inset = matrixOf({0.856627153315983, 0.0951212405381588, 0.0482516061458583,  //
                               0.137318972929847, 0.761241990602591, 0.101439036467562,    //
                               0.11189821299995, 0.0767994186031903, 0.811302368396859});
  const auto outset = matrixOf({1.1271005818144368, -0.11060664309660323, -0.016493938717834573,  //
                                -0.1413297634984383, 1.157823702216272, -0.016493938717834257,    //
                                -0.14132976349843826, -0.11060664309660294, 1.2519364065950405});
  return group(
      {xyzFromRec709(), inverseOf(xyzFromRec2020()), inset, curve(agxCurve), outset, xyzFromRec2020()});
}

/// What comes before a view: on light in ACES2065-1.
void addLook(const OCIO::ConfigRcPtr& config, const char* name, const char* style, const char* description) {
  const auto look = OCIO::Look::Create();
  look->setName(name);
  look->setProcessSpace("aces2065_1");
  look->setTransform(builtin(style));
  look->setDescription(description);
  config->addLook(look);
}

std::string addDisplaySpace(const OCIO::ConfigRcPtr& config, const std::string& name, const char* style) {
  const auto space = OCIO::ColorSpace::Create(OCIO::REFERENCE_SPACE_DISPLAY);
  std::string spaceName = name + " display";
  space->setName(spaceName.c_str());
  space->setFamily("Display");
  space->setTransform(builtin(style), OCIO::COLORSPACE_DIR_FROM_REFERENCE);
  config->addColorSpace(space);
  return spaceName;
}

/// A display with its plain view first: no tone mapping, only primaries and curve. `aces` is the view
/// transform of its ACES view.
void addDisplay(const OCIO::ConfigRcPtr& config, const char* name, const char* style, const char* aces) {
  const std::string space = addDisplaySpace(config, name, style);
  const auto add = [&](const char* view, const char* transform, const char* description) {
    config->addDisplayView(name, view, transform, space.c_str(), "", "", description);
  };
  add(name, "Plain", "No tone mapping: as measured");
  add(kRolledOffView, kRolledOffView,
      "Filmic, as Blender's AgX: middle grey stays, 6.5 stops above it roll off, bright colours go to white");
  add("ACES SDR", aces, "ACES 1.x output for video");
  for (const ToneCurve& tone : toneCurves()) add(tone.name, tone.name, tone.description);
  config->addDisplayView(name, "Log", "acescct", "");
  config->addDisplayView(name, "Raw", "raw", "");
}

/// A display of high dynamic range (ITU-R BT.2100): diffuse white at 203 cd/m2 (BT.2408), or ACES for 1000.
void addHdrDisplay(const OCIO::ConfigRcPtr& config, const char* name, const char* style) {
  const std::string space = addDisplaySpace(config, name, style);
  config->addDisplayView(name, "203 nit white", "203 nit white", space.c_str(), "", "",
                         "No tone mapping: full scale of a shot at 203 cd/m2 (BT.2408)");
  config->addDisplayView(name, "ACES HDR 1000 nit", "ACES HDR 1000 nit", space.c_str(), "", "",
                         "ACES 1.1 output for a monitor of 1000 cd/m2");
}

/// A variable of the environment that is not there while this lives.
class Unset {
 public:
  explicit Unset(const char* name) : m_name(name), m_value(OCIO::GetEnvVariable(name)) {
    OCIO::UnsetEnvVariable(name);
  }
  Unset(const Unset&) = delete;
  Unset& operator=(const Unset&) = delete;
  ~Unset() {
    if (!m_value.empty()) OCIO::SetEnvVariable(m_name, m_value.c_str());
  }

 private:
  const char* m_name;
  std::string m_value;
};

/// What the environment makes active is of the facility's configuration; a new one would take it over, and
/// end where it lacks a name.
OCIO::ConfigRcPtr emptyConfig() {
  const Unset displays("OCIO_ACTIVE_DISPLAYS"), views("OCIO_ACTIVE_VIEWS"),
      spaces("OCIO_INACTIVE_COLORSPACES");
  return OCIO::Config::Create();
}

}  // namespace

OCIO::ConstConfigRcPtr builtinConfig() {
  const auto config = emptyConfig();
  config->setVersion(2, 1);
  config->setName("swaplight built-in");
  addSpace(config, {"lin_rec709", "Scene", "Linear light, Rec.709 primaries, D65", {}, {"linear"}});
  addSpace(config, {"srgb", "Scene", "sRGB-encoded pictures (IEC 61966-2-1)", linearFromSrgb(), {"sRGB"}});
  addSpace(config, {"acescg",
                    "Scene",
                    "Linear light, ACES AP1 primaries",
                    builtin("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD"),
                    {"ACEScg"}});
  addSpace(config,
           {"aces2065_1", "Scene", "Linear light, ACES AP0 primaries", rec709FromAces(), {"ACES2065-1"}});
  addSpace(config, {"acescct",
                    "Scene",
                    "Logarithmic, ACES AP1 primaries",
                    group({builtin("ACEScct_to_ACES2065-1"), rec709FromAces()}),
                    {"ACEScct"}});
  for (const CameraSpace& camera : cameraSpaces())
    addSpace(config,
             {camera.name, "Camera", camera.description, rec709FromCamera(camera.name), {camera.alias}});
  addSpace(config, {"raw", "Data", "Numbers that are no colours: never converted", {}, {}});
  config->setRole("default", "raw");
  config->setRole("data", "raw");
  config->setRole("scene_linear", "lin_rec709");
  config->setRole("reference", "lin_rec709");
  config->setRole("aces_interchange", "aces2065_1");
  config->setRole("compositing_log", "acescct");
  config->setRole("color_timing", "acescct");

  addViewTransform(config, "Plain", xyzFromRec709());
  addViewTransform(
      config, "ACES SDR",
      group({acesFromRec709(), builtin("ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0")}));
  addViewTransform(
      config, "ACES SDR P3",
      group({acesFromRec709(), builtin("ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO-P3lim_1.1")}));
  addViewTransform(config, kRolledOffView, agx());
  for (const ToneCurve& tone : toneCurves())
    addViewTransform(config, tone.name, group({curve(tone.curve), xyzFromRec709()}));
  // The display's XYZ is in units of 100 cd/m2.
  addViewTransform(config, "203 nit white", group({scale(2.03), xyzFromRec709()}));
  addViewTransform(
      config, "ACES HDR 1000 nit",
      group({acesFromRec709(),
             builtin("ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - HDR-VIDEO-1000nit-15nit-REC2020lim_1.1")}));
  config->setDefaultViewTransformName("Plain");
  addLook(
      config, "Gamut compression", "ACES-LMT - ACES 1.3 Reference Gamut Compression",
      "Colours of LEDs and neon that are too pure for a monitor are brought within its reach softly (ACES "
      "1.3)");
  addLook(config, "Blue light fix", "ACES-LMT - BLUE_LIGHT_ARTIFACT_FIX",
          "Strong blue light stays blue where ACES would turn it to violet (ACES 1.0.3)");
  addDisplay(config, "sRGB", "DISPLAY - CIE-XYZ-D65_to_sRGB", "ACES SDR");
  addDisplay(config, "Rec.709", "DISPLAY - CIE-XYZ-D65_to_REC.1886-REC.709", "ACES SDR");
  addDisplay(config, "P3-D65", "DISPLAY - CIE-XYZ-D65_to_G2.6-P3-D65", "ACES SDR P3");
  addHdrDisplay(config, "Rec.2100 PQ", "DISPLAY - CIE-XYZ-D65_to_REC.2100-PQ");
  addHdrDisplay(config, "Rec.2100 HLG", "DISPLAY - CIE-XYZ-D65_to_REC.2100-HLG-1000nit");
  config->validate();
  return config;
}

}  // namespace swaplight
