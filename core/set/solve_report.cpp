#include "core/set/solve_report.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"

namespace swaplight {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();
constexpr float kDegrees = 180 / std::numbers::pi_v<float>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// JSON has no infinity.
Json finiteOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

double finiteOrInfinity(JsonFields& fields, const std::string& key, double missing = 0) {
  const Json* value = fields.find(key);
  if (value && value->is_null()) return kInfinity;
  return fields.number(key, -kMost, kMost).value_or(missing);
}

size_t count(JsonFields& fields, const std::string& key) {
  return static_cast<size_t>(fields.number(key, 0, 1e15).value_or(0));
}

/// Hands each element of a list, if there is one, to `take`.
template <typename Take>
void each(JsonFields& fields, const std::string& key, const std::string& what, Take take) {
  if (!fields.find(key)) return;
  for (const Json& item : fields.list(key, what)) take(item);
}

std::vector<std::string> texts(JsonFields& fields, const std::string& key) {
  std::vector<std::string> result;
  each(fields, key, "a list of texts", [&](const Json& text) {
    if (!text.is_string())
      throw InputError("{}: \"{}\" holds {}, expected texts.", fields.where(), key, describeJson(text));
    result.push_back(text.get<std::string>());
  });
  return result;
}

/// [1.5, 2] and the like.
std::vector<float> numbers(const JsonFields& fields, const std::string& key, const Json& list, size_t size) {
  std::vector<float> result;
  if (list.is_array())
    for (const Json& number : list)
      if (number.is_number()) result.push_back(number.get<float>());
  if (result.size() != size || list.size() != size)
    throw InputError("{}: \"{}\" holds {}, expected a list of {} numbers.", fields.where(), key, list.dump(),
                     size);
  return result;
}

Json jsonFromNoise(const SolveReport& report) {
  return {
      {"read", report.noise.read}, {"full_well", report.noise.fullWell}, {"estimated", !report.noiseGiven}};
}

void readNoise(JsonFields& fields, SolveReport& report) {
  const Json* json = fields.find("noise");
  if (!json) return;
  JsonFields noise(*json, fields.where() + ": noise");
  report.noise.read = finiteOrInfinity(noise, "read", report.noise.read);
  report.noise.fullWell = finiteOrInfinity(noise, "full_well", report.noise.fullWell);
  report.noiseGiven = !noise.boolean("estimated").value_or(true);
}

Conditioning conditioningFromJson(JsonFields& fields) {
  Conditioning result;
  const Json* json = fields.find("conditioning");
  if (!json) return result;
  JsonFields inner(*json, fields.where() + ": conditioning");
  size_t c = 0;
  each(inner, "channels", "a list of channels", [&](const Json& item) {
    if (c == 3) throw InputError("{}: has more than three channels.", inner.where());
    JsonFields channel(item, inner.where());
    each(channel, "singular_values", "a list of numbers", [&](const Json& value) {
      result.singularValues[c].push_back(value.is_number() ? value.get<double>() : 0);
    });
    result.condition[c] = finiteOrInfinity(channel, "condition");
    result.amplification[c] = finiteOrInfinity(channel, "amplification");
    ++c;
  });
  result.matteAmplification = finiteOrInfinity(inner, "matte_amplification");
  result.advice = texts(inner, "advice");
  return result;
}

Json jsonFromOpenColor(const OpenColor& open) {
  const auto list = [](const Rgb& color) { return Json{color.r, color.g, color.b}; };
  return {{"name", open.name},
          {"nearest", list(open.nearest)},
          {"farthest", list(open.farthest)},
          {"taken", list(open.taken)},
          {"exchanged", list(open.exchanged)},
          {"position", open.position},
          {"by", open.by},
          {"settled", open.settled}};
}

std::optional<OpenColor> openColorFromJson(JsonFields& fields) {
  const Json* json = fields.find("open_color");
  if (!json || json->is_null()) return std::nullopt;
  JsonFields inner(*json, fields.where() + ": open_color");
  const auto color = [&](const char* key) {
    const Json* list = inner.find(key);
    if (!list) return Rgb(0);
    const std::vector<float> parts = numbers(inner, key, *list, 3);
    return Rgb(parts[0], parts[1], parts[2]);
  };
  OpenColor open;
  open.name = inner.text("name").value_or("");
  open.nearest = color("nearest");
  open.farthest = color("farthest");
  open.taken = color("taken");
  open.exchanged = color("exchanged");
  open.position = static_cast<float>(inner.number("position", 0, 1).value_or(0));
  open.by = inner.text("by").value_or("");
  open.settled = inner.boolean("settled").value_or(false);
  return open;
}

KeptJson kept(JsonFields& fields, const std::string& key) {
  const Json* json = fields.find(key);
  return json ? KeptJson(*json) : KeptJson();
}

}  // namespace

Json jsonFromConditioning(const Conditioning& conditioning) {
  Json channels = Json::array();
  for (size_t c = 0; c < 3; ++c)
    channels.push_back({{"channel", std::string(1, "RGB"[c])},
                        {"singular_values", conditioning.singularValues[c]},
                        {"condition", finiteOrNull(conditioning.condition[c])},
                        {"amplification", finiteOrNull(conditioning.amplification[c])}});
  return {{"channels", channels},
          {"matte_amplification", finiteOrNull(conditioning.matteAmplification)},
          {"advice", conditioning.advice}};
}

Json jsonFromSolveReport(const SolveReport& report) {
  Json refined = Json::array();
  Json shifts = Json::array(), turns = Json::array();
  bool turned = false;
  for (const ShotShift& shift : report.shifts) {
    shifts.push_back(shift.found ? Json{shift.x, shift.y} : Json(nullptr));
    turns.push_back({shift.turn * kDegrees, shift.zoom});
    turned |= shift.isTurned();
  }
  for (const Rgb& color : report.refinedColors) refined.push_back({color.r, color.g, color.b});
  Json json = {{"message", report.message},
               {"model", report.model},
               {"solver", report.solver},
               {"noise", jsonFromNoise(report)},
               {"color_uncertainty", report.colorUncertainty},
               {"color_disagreement", report.colorDisagreement},
               {"color_change", report.colorChange},
               {"refined_colors", refined},
               {"estimated", report.estimated},
               {"open_color", report.openColor ? jsonFromOpenColor(*report.openColor) : Json()},
               {"shifts", shifts},
               {"conditioning", jsonFromConditioning(report.conditioning)},
               {"residual_median", report.residualMedian},
               {"sigma_median", report.sigmaMedian},
               {"pixels", report.pixels},
               {"clipped", report.clipped},
               {"too_dark", report.tooDark},
               {"moved", report.moved},
               {"not_finite", report.notFinite},
               {"lost", report.lost},
               {"filled", report.filled},
               {"seconds", report.seconds},
               {"misfit_causes", jsonFromMisfitCauses(report.causes)},
               {"warnings", report.warnings}};
  if (turned) json["turns"] = turns;
  if (report.highlights > 0) json["highlights"] = report.highlights;
  if (report.tone) json["tone_correction"] = jsonFromTakenTone(*report.tone);
  if (!report.lampFields.empty()) json["lamp_fields"] = jsonFromLampFields(report.lampFields);
  if (!report.options.empty()) json["options"] = report.options.json();
  json.update(report.unknown.json());
  return json;
}

Json jsonFromSolveSummary(const SolveReport& report) {
  return {{"message", report.message},
          {"model", report.model},
          {"solver", report.solver},
          {"residual_median", report.residualMedian},
          {"sigma_median", report.sigmaMedian},
          {"noise", jsonFromNoise(report)},
          {"pixels", report.pixels},
          {"warnings", report.warnings}};
}

SolveReport solveReportFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  SolveReport report;
  report.message = fields.text("message").value_or("");
  report.model = fields.text("model").value_or("");
  report.solver = fields.text("solver").value_or("");
  readNoise(fields, report);
  report.colorUncertainty = static_cast<float>(finiteOrInfinity(fields, "color_uncertainty"));
  report.colorDisagreement = finiteOrInfinity(fields, "color_disagreement");
  report.colorChange = finiteOrInfinity(fields, "color_change");
  each(fields, "refined_colors", "a list of colours", [&](const Json& item) {
    const std::vector<float> color = numbers(fields, "refined_colors", item, 3);
    report.refinedColors.emplace_back(color[0], color[1], color[2]);
  });
  report.estimated = texts(fields, "estimated");
  report.openColor = openColorFromJson(fields);
  report.conditioning = conditioningFromJson(fields);
  each(fields, "shifts", "a list of shifts", [&](const Json& item) {
    ShotShift& shift = report.shifts.emplace_back();
    shift.found = !item.is_null();
    if (!shift.found) return;
    const std::vector<float> offset = numbers(fields, "shifts", item, 2);
    shift.x = offset[0], shift.y = offset[1];
  });
  size_t k = 0;
  each(fields, "turns", "a list of turns", [&](const Json& item) {
    const std::vector<float> turn = numbers(fields, "turns", item, 2);
    if (k >= report.shifts.size()) throw InputError("{}: turns: there are more than shifts", fields.where());
    report.shifts[k].turn = turn[0] / kDegrees, report.shifts[k].zoom = turn[1];
    ++k;
  });
  report.residualMedian = finiteOrInfinity(fields, "residual_median");
  report.sigmaMedian = finiteOrInfinity(fields, "sigma_median");
  report.pixels = count(fields, "pixels");
  report.clipped = count(fields, "clipped");
  report.tooDark = count(fields, "too_dark");
  report.moved = count(fields, "moved");
  report.notFinite = count(fields, "not_finite");
  report.lost = count(fields, "lost");
  report.filled = count(fields, "filled");
  report.seconds = finiteOrInfinity(fields, "seconds");
  report.highlights = fields.number("highlights", 0, 1).value_or(0);
  if (const Json* causes = fields.find("misfit_causes")) report.causes = misfitCausesFromJson(*causes);
  if (const Json* tone = fields.find("tone_correction")) report.tone = takenToneFromJson(*tone);
  if (const Json* lamps = fields.find("lamp_fields")) report.lampFields = lampFieldsFromJson(*lamps);
  report.warnings = texts(fields, "warnings");
  report.options = kept(fields, "options");
  report.unknown = fields.unknown();
  return report;
}

}  // namespace swaplight
