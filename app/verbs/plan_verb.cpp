#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include "app/program/description.h"
#include "app/program/number_range.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/light_name.h"
#include "core/plan/plan_forecast.h"
#include "core/plan/plan_search.h"
#include "core/set/solve_report.h"

namespace swaplight {
namespace {

struct PlanCommand {
  std::string lights;
  std::string gels;
  std::string colors;
  std::string model = "auto";
  std::string coding = "rotation";
  PlanSearchOptions search;
};

/// "3", or the names "key,fill,back".
std::vector<std::string> lightNames(const std::string& text) {
  std::vector<std::string> names;
  int count = 0;
  if (CLI::detail::lexical_cast(text, count)) {
    if (count < 2 || count > kMaxLights)
      throw InputError("--lights: {} lights; a plan is for 2 to {}", count, kMaxLights);
    names = {"key", "fill", "back", "kicker"};
    for (int i = 4; i < count; ++i) names.push_back(fmt::format("light{}", i + 1));
    names.resize(static_cast<size_t>(count));
    return names;
  }
  std::istringstream parts(text);
  for (std::string name; std::getline(parts, name, ',');) names.push_back(name);
  checkLightNames(names, "--lights");
  return names;
}

std::vector<PlanColor> colorsAtHand(const PlanCommand& arguments) {
  std::vector<PlanColor> colors;
  const auto add = [&](const std::vector<PlanColor>& more) {
    colors.insert(colors.end(), more.begin(), more.end());
  };
  if (!arguments.gels.empty()) add(planGelsFromText(arguments.gels));
  if (!arguments.colors.empty()) add(planColorsFromText(arguments.colors));
  if (colors.empty()) add(panelColors());
  return colors;
}

PlanCoding codingFromName(const std::string& name) {
  if (name == "rotation") return PlanCoding::Rotation;
  if (name == "free") return PlanCoding::Free;
  throw InputError("--coding: '{}' is not known; known are rotation, free", name);
}

std::string minimizedText(Model model) {
  switch (model) {
    case Model::Lambert:
      return "the matte model's variance (Fisher information)";
    case Model::Transport:
      return "the full contributions' variance (inverse Gram matrix)";
    default:
      return "the mean of the matte model's variance (Fisher information) and the full contributions' "
             "(inverse Gram "
             "matrix)";
  }
}

std::string numberText(double value) {
  return std::isfinite(value) ? fmt::format("{:.2f}", value) : "infinite";
}

std::string errorText(double value) {
  return std::isfinite(value) ? fmt::format("{:.4f}", value) : "infinite";
}

std::string percentText(double fraction) {
  return std::isfinite(fraction) ? fmt::format("{:.1f} %", 100 * fraction) : "infinite";
}

Json finiteOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

const PlanColor& colorOf(const PlanChoice& choice, const std::vector<PlanColor>& colors, int shot,
                         int light) {
  return colors[size_t(choice.colorIndex[size_t(shot) * size_t(choice.plan.lights) + size_t(light)])];
}

/// The shots x lights table; colours are without the exposure.
std::string assignmentText(const PlanChoice& choice, const std::vector<PlanColor>& colors) {
  std::vector<std::vector<std::string>> rows{{"shot"}};
  for (const std::string& name : choice.plan.names) rows.front().push_back(name);
  for (int k = 0; k < choice.plan.shots; ++k) {
    rows.push_back({fmt::format("{}", k + 1)});
    for (int i = 0; i < choice.plan.lights; ++i) rows.back().push_back(colorOf(choice, colors, k, i).name);
  }
  std::vector<std::vector<std::string>> values{{"colour", "linear r/g/b"}};
  for (size_t c = 0; c < colors.size(); ++c)
    if (std::find(choice.colorIndex.begin(), choice.colorIndex.end(), int(c)) != choice.colorIndex.end())
      values.push_back({colors[c].name, fmt::format("{:.3f} {:.3f} {:.3f}", colors[c].color.r,
                                                    colors[c].color.g, colors[c].color.b)});
  return tableText(rows) + "\n" + tableText(values);
}

std::string conditioningText(const Conditioning& conditioning) {
  std::vector<std::vector<std::string>> rows{{"channel", "condition", "amplification", "singular values"}};
  for (size_t c = 0; c < 3; ++c)
    rows.push_back({std::array{"red", "green", "blue"}[c], numberText(conditioning.condition[c]),
                    numberText(conditioning.amplification[c]),
                    fmt::format("{:.3f}", fmt::join(conditioning.singularValues[c], " "))});
  return tableText(rows);
}

Description describe(const PlanChoice& choice, const std::vector<PlanColor>& colors,
                     const PlanForecast& forecast, const PlanSearchOptions& options) {
  const PlanNoise &matte = forecast.matte, &transport = forecast.transport;
  std::string text = fmt::format(
      "{} shots of {} lights; {} of {} colours at hand\n\n", choice.plan.shots, choice.plan.lights,
      std::set(choice.colorIndex.begin(), choice.colorIndex.end()).size(), colors.size());
  text += assignmentText(choice, colors) + "\n" + conditioningText(forecast.conditioning) + "\n";
  Description d{text, Json::object()};
  d.line("error of T", fmt::format("{} (matte), {} (full contribution)", percentText(matte.contribution),
                                   percentText(transport.contribution)));
  d.line("error of beta",
         fmt::format("{} (matte), {} (full contribution)", errorText(matte.beta), errorText(transport.beta)));
  d.line("at", fmt::format("full well {:g}, read noise {:g}, {:+g} stops, typical pixels",
                           options.noise.fullWell, options.noise.read, options.exposureStops));
  d.line("minimised", minimizedText(options.model));
  d.line("compared",
         fmt::format("{} plans{}", choice.tried, choice.exhaustive ? ": all there are" : ", not all"));
  for (const std::string& advice : forecast.conditioning.advice) d.line("advice", advice);
  return d;
}

Json shotsJson(const PlanChoice& choice, const std::vector<PlanColor>& colors,
               const std::vector<std::string>& lights) {
  Json shots = Json::array();
  for (int k = 0; k < choice.plan.shots; ++k) {
    Json shot = Json::array();
    for (int i = 0; i < choice.plan.lights; ++i) {
      const auto& [name, color] = colorOf(choice, colors, k, i);
      shot.push_back({{"light", lights[size_t(i)]}, {"name", name}, {"color", {color.r, color.g, color.b}}});
    }
    shots.push_back(shot);
  }
  return shots;
}

Json jsonFromPlan(const PlanChoice& choice, const std::vector<PlanColor>& colors,
                  const PlanForecast& forecast, const PlanSearchOptions& options) {
  const auto errors = [](const PlanNoise& noise) -> Json {
    return {{"contribution", finiteOrNull(noise.contribution)}, {"beta", finiteOrNull(noise.beta)}};
  };
  return {{"lights", options.lights},
          {"shots", shotsJson(choice, colors, options.lights)},
          {"conditioning", jsonFromConditioning(forecast.conditioning)},
          {"predicted", {{"lambert", errors(forecast.matte)}, {"transport", errors(forecast.transport)}}},
          {"noise", {{"read", options.noise.read}, {"full_well", options.noise.fullWell}}},
          {"exposure_stops", options.exposureStops},
          {"model", modelName(options.model)},
          {"minimized", minimizedText(options.model)},
          {"cost", choice.cost},
          {"tried", choice.tried},
          {"exhaustive", choice.exhaustive}};
}

int run(const PlanCommand& arguments, Terminal& terminal) {
  PlanSearchOptions options = arguments.search;
  options.lights = lightNames(arguments.lights);
  options.model = modelFromName(arguments.model);
  options.coding = codingFromName(arguments.coding);
  const std::vector<PlanColor> colors = colorsAtHand(arguments);
  const PlanChoice choice = searchPlan(colors, options, terminal.progress());
  const PlanForecast forecast = planForecast(choice.plan, options.noise);
  terminal.result(describe(choice, colors, forecast, options).text,
                  jsonFromPlan(choice, colors, forecast, options));
  return 0;
}

}  // namespace

void addPlanVerb(Program& program) {
  const auto a = std::make_shared<PlanCommand>();
  CLI::App& verb = program.addVerb("plan", "Plan which colours to give the lights in each photograph",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("--lights", a->lights, "How many, or their names: 3 or key,fill,back")
      ->required()
      ->type_name("N");
  verb.add_option("--shots", a->search.shots, "Number of photographs (default: one per light)")
      ->check(CLI::Range(1, kMaxShots).description(""))
      ->type_name("K");
  verb.add_option("--gels", a->gels, "Available gels: numbers (L106,L124), all, or a gel table")
      ->type_name("GELS");
  verb.add_option(
          "--colors", a->colors,
          "Available colours: linear r/g/b, #rrggbb, 3200K, off, panels (those of an RGB panel; the default)")
      ->type_name("LIST");
  verb.add_option("--coding", a->coding,
                  "rotation (gels move on by one light per photograph) or free (any colour on any light)")
      ->type_name("HOW")
      ->capture_default_str();
  verb.add_flag("--repeat", a->search.repeat, "A rotation may use a colour on several lights at once");
  verb.add_option("--model", a->model,
                  "Model whose error is minimised: lambert, transport, or auto, the mean of both")
      ->type_name("NAME")
      ->capture_default_str();
  verb.add_option("--full-well", a->search.noise.fullWell, "Electrons at full scale")
      ->check(NumberRange(1.0, 1e12))
      ->type_name("X")
      ->capture_default_str();
  verb.add_option("--read", a->search.noise.read, "Read noise, full scale 1")
      ->check(NumberRange(0.0, 1.0))
      ->type_name("X")
      ->capture_default_str();
  verb.add_option("--exposure", a->search.exposureStops,
                  "Exposure in stops over one in which a white surface facing one white light reaches half "
                  "of full scale")
      ->check(NumberRange(-20.0, 20.0))
      ->type_name("STOPS")
      ->capture_default_str();
}

}  // namespace swaplight
