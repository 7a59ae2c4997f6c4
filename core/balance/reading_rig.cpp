#include "core/balance/reading_rig.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/base/json.h"
#include "core/color/chromaticity.h"
#include "core/lamp/kelvin.h"
#include "core/ocio/convert_color.h"
#include "core/relight/rig_edit.h"
#include "core/relight/setting.h"

namespace swaplight {
namespace {

constexpr double kWhiteDuv = 0.05;  // beyond, a temperature says nothing (CIE 015)

Json numberOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json numbersOrNull(const Rgb& color) {
  return {numberOrNull(color.r), numberOrNull(color.g), numberOrNull(color.b)};
}

bool isKnown(const ReadLamp& lamp) {
  return std::isfinite(lamp.error.r + lamp.error.g + lamp.error.b);
}

/// The lamp as a row of the mixer.
LightSetting settingOf(const ColorConfig& config, LightSetting setting, const std::string& colorSpace,
                       const ReadLamp& lamp) {
  if (!isKnown(lamp)) return setting;
  setting = resetLight(setting);
  setting.group.clear();
  setting.on = lamp.on;
  if (!lamp.on) return setting;
  const Rgb rec709 = glm::max(convertColor(config, lamp.color, colorSpace, "lin_rec709"), Rgb(0));
  const float level = luminance(rec709);
  setting.color.kind = LightColor::Kind::LinearRgb;
  setting.color.value = rec709 / level;
  setting.stops = std::clamp(std::log2(level), -kMostStops, kMostStops);
  return setting;
}

Json jsonFromLamp(const ColorConfig& config, const std::string& colorSpace, const ReadLamp& lamp) {
  Json json{{"color", numbersOrNull(lamp.color)},
            {"standard_error", numbersOrNull(lamp.error)},
            {"luminance", lamp.luminance},
            {"luminance_error", numberOrNull(lamp.luminanceError)},
            {"stops", lamp.on ? Json(std::log2(lamp.luminance)) : Json(nullptr)},
            {"on", lamp.on},
            {"known", isKnown(lamp)}};
  LightSetting setting;
  setting.light = lamp.light;
  json["setting"] = settingText(settingOf(config, setting, colorSpace, lamp));
  if (!lamp.on) return json;
  const CorrelatedTemperature white = correlatedTemperature(
      xyFromRec709(glm::max(convertColor(config, lamp.color, colorSpace, "lin_rec709"), Rgb(0))));
  if (std::abs(white.duv) > kWhiteDuv) return json;
  json["kelvin"] = white.kelvin;
  json["duv"] = white.duv;
  return json;
}

}  // namespace

Rig rigOfReading(const ColorConfig& config, Rig rig, const SolvedSet& set, const LampReading& reading) {
  for (const ReadLamp& lamp : reading.lamps) {
    LightSetting& setting = findLight(rig, lamp.light);
    setting = settingOf(config, setting, set.colorSpace(), lamp);
  }
  if (reading.ambient) rig.ambient = *reading.ambient;
  return rig;
}

Json jsonFromReading(const ColorConfig& config, const SolvedSet& set, const LampReading& reading) {
  Json json{{"color_space", set.colorSpace()}, {"lights", Json::object()}};
  for (const ReadLamp& lamp : reading.lamps)
    json["lights"][lamp.light] = jsonFromLamp(config, set.colorSpace(), lamp);
  if (reading.ambient)
    json["ambient"] = {{"level", *reading.ambient}, {"standard_error", reading.ambientError}};
  json["noise"] = {{"read", reading.noise.read}, {"full_well", reading.noise.fullWell}};
  json["misfit"] = reading.misfit;
  json["expected_misfit"] = reading.expectedMisfit;
  json["used"] = reading.used;
  json["left_out"] = reading.leftOut;
  if (reading.shift) json["shift"] = {reading.shift->x, reading.shift->y};
  if (reading.shift && reading.shift->isTurned())
    json["turn"] = {double(reading.shift->turn) * 180 / std::numbers::pi, reading.shift->zoom};
  json["warnings"] = reading.warnings;
  json["rig"] = jsonFromRig(rigOfReading(config, defaultRig(set.capture), set, reading));
  return json;
}

}  // namespace swaplight
