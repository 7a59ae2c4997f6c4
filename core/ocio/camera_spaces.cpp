#include "core/ocio/camera_spaces.h"

#include <array>
#include <string_view>

#include "core/base/check.h"

namespace swaplight {

namespace OCIO = OCIO_NAMESPACE;

namespace {

constexpr std::array<CameraSpace, 15> kSpaces = {{
    {"gamma22", "A power of 2.2, Rec.709 primaries: linear = code^2.2", "Gamma 2.2"},
    {"gamma24", "A power of 2.4, Rec.709 primaries (BT.1886)", "Gamma 2.4"},
    {"rec709", "The Rec.709 camera curve (BT.709-6), as HD video codes light", "Rec.709"},
    {"lin_p3d65", "Linear light, P3 primaries, D65", "Linear P3-D65"},
    {"lin_rec2020", "Linear light, Rec.2020 primaries, D65", "Linear Rec.2020"},
    {"arri_logc_ei800_awg", "ARRI LogC (EI 800), ALEXA Wide Gamut", "ARRI LogC"},
    {"sony_slog3_sgamut3", "Sony S-Log3, S-Gamut3", "S-Log3 S-Gamut3"},
    {"sony_slog3_sgamut3cine", "Sony S-Log3, S-Gamut3.Cine", "S-Log3 S-Gamut3.Cine"},
    {"sony_slog3_sgamut3_venice", "Sony S-Log3, S-Gamut3 of the Venice", "S-Log3 Venice S-Gamut3"},
    {"sony_slog3_sgamut3cine_venice", "Sony S-Log3, S-Gamut3.Cine of the Venice",
     "S-Log3 Venice S-Gamut3.Cine"},
    {"canon_clog2_cgamut", "Canon Log 2, Cinema Gamut", "C-Log2"},
    {"canon_clog3_cgamut", "Canon Log 3, Cinema Gamut", "C-Log3"},
    {"panasonic_vlog_vgamut", "Panasonic V-Log, V-Gamut", "V-Log"},
    {"red_log3g10_rwg", "RED Log3G10, REDWideGamutRGB", "Log3G10"},
    {"red_logfilm_rwg", "RED REDlogFilm, REDWideGamutRGB", "REDlogFilm"},
}};

/// The style of OpenColorIO's transform to ACES2065-1.
constexpr std::pair<std::string_view, const char*> kStyles[] = {
    {"arri_logc_ei800_awg", "ARRI_ALEXA-LOGC-EI800-AWG_to_ACES2065-1"},
    {"sony_slog3_sgamut3", "SONY_SLOG3-SGAMUT3_to_ACES2065-1"},
    {"sony_slog3_sgamut3cine", "SONY_SLOG3-SGAMUT3.CINE_to_ACES2065-1"},
    {"sony_slog3_sgamut3_venice", "SONY_SLOG3-SGAMUT3-VENICE_to_ACES2065-1"},
    {"sony_slog3_sgamut3cine_venice", "SONY_SLOG3-SGAMUT3.CINE-VENICE_to_ACES2065-1"},
    {"canon_clog2_cgamut", "CANON_CLOG2-CGAMUT_to_ACES2065-1"},
    {"canon_clog3_cgamut", "CANON_CLOG3-CGAMUT_to_ACES2065-1"},
    {"panasonic_vlog_vgamut", "PANASONIC_VLOG-VGAMUT_to_ACES2065-1"},
    {"red_log3g10_rwg", "RED_LOG3G10-RWG_to_ACES2065-1"},
    {"red_logfilm_rwg", "RED_REDLOGFILM-RWG_to_ACES2065-1"},
};

OCIO::TransformRcPtr power(double gamma) {
  const auto transform = OCIO::ExponentTransform::Create();
  const double value[4] = {gamma, gamma, gamma, 1};
  transform->setValue(value);
  transform->setNegativeStyle(OCIO::NEGATIVE_MIRROR);
  return transform;
}

/// BT.709-6, 1.2: V = 1.099 L^0.45 - 0.099, linear below L = 0.018.
OCIO::TransformRcPtr linearFromRec709() {
  const auto curve = OCIO::ExponentWithLinearTransform::Create();
  const double gamma[4] = {1 / 0.45, 1 / 0.45, 1 / 0.45, 1};
  const double offset[4] = {0.099, 0.099, 0.099, 0};
  curve->setGamma(gamma);
  curve->setOffset(offset);
  curve->setNegativeStyle(OCIO::NEGATIVE_LINEAR);
  return curve;
}

OCIO::TransformRcPtr matrix(const std::array<double, 9>& m) {
  const auto transform = OCIO::MatrixTransform::Create();
  const double values[16] = {m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0, 0, 0, 0, 1};
  transform->setMatrix(values);
  return transform;
}

// Primaries of SMPTE RP 431-2 and ITU-R BT.2020 over white D65 (.3127, .3290), to those of BT.709.
constexpr std::array<double, 9> kRec709FromP3 = {
    1.2249401762805598,    -0.22494017628055996,  0,
    -0.042056954709688163, 1.0420569547096881,    0,
    -0.019637554590334432, -0.078636045550631889, 1.0982736001409665};
constexpr std::array<double, 9> kRec709FromRec2020 = {
    1.6604910021084345,    -0.58764113878854951, -0.072849863319884883,
    -0.12455047452159074,  1.1328998971259603,   -0.0083494226043694768,
    -0.018150763354905303, -0.10057889800800739, 1.1187296613629127};

OCIO::TransformRcPtr builtinStep(const char* style, bool inverse = false) {
  const auto transform = OCIO::BuiltinTransform::Create();
  transform->setStyle(style);
  if (inverse) transform->setDirection(OCIO::TRANSFORM_DIR_INVERSE);
  return transform;
}

/// By way of ACES2065-1, to AP1, to Rec.709.
OCIO::TransformRcPtr fromLog(const char* style) {
  const auto steps = OCIO::GroupTransform::Create();
  steps->appendTransform(builtinStep(style));
  steps->appendTransform(builtinStep("ACEScg_to_ACES2065-1", true));
  steps->appendTransform(builtinStep("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD"));
  return steps;
}

}  // namespace

std::span<const CameraSpace> cameraSpaces() {
  return kSpaces;
}

OCIO::TransformRcPtr rec709FromCamera(const char* name) {
  const std::string_view space = name;
  if (space == "gamma22") return power(2.2);
  if (space == "gamma24") return power(2.4);
  if (space == "rec709") return linearFromRec709();
  if (space == "lin_p3d65") return matrix(kRec709FromP3);
  if (space == "lin_rec2020") return matrix(kRec709FromRec2020);
  const char* found = nullptr;
  for (const auto& [known, style] : kStyles)
    if (space == known) found = style;
  SWAPLIGHT_CHECK(found);
  return fromLog(found);
}

}  // namespace swaplight
