#include "app/arguments/solve_arguments.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "app/arguments/place_text.h"
#include "app/program/number_range.h"
#include "core/base/error.h"
#include "core/session/open_source.h"
#include "core/solve/model/estimator.h"

namespace swaplight {
namespace {

constexpr const char* kHighlights = "--highlights";
constexpr const char* kGroup = "Solving";

/// True for the second of two words, false for the first.
bool chosen(const char* option, const std::string& text, const char* off, const char* on) {
  if (text != off && text != on)
    throw InputError("{}: '{}' is not known; known: {}, {}", option, text, off, on);
  return text == on;
}

/// "key=120,80"
OpenColorChoice::OneLamp oneLampFromText(const std::string& text) {
  const LightPlace place = lightPlaceFromText(text, "--one-lamp");
  return {place.light, place.x, place.y};
}

}  // namespace

Remedy remedyFromText(const char* option, const std::string& text, const char* off, const char* on) {
  if (text == "sure") return Remedy::Sure;
  if (text != off && text != on)
    throw InputError("{}: '{}' is not known; known: {}, sure, {}", option, text, off, on);
  return text == on ? Remedy::On : Remedy::Off;
}

SensorNoise noiseFromText(const std::string& text) {
  const auto wrong = [&](const std::string& part) {
    return InputError(
        "--noise: '{}' is not right; write read=.002,full_well=20000 (read noise 0 or more, full "
        "well above 0, full scale = 1)",
        part);
  };
  SensorNoise noise;
  std::istringstream parts(text);
  std::string part;
  while (std::getline(parts, part, ',')) {
    const size_t equals = part.find('=');
    double value = 0;
    if (equals == std::string::npos || !CLI::detail::lexical_cast(part.substr(equals + 1), value))
      throw wrong(part);
    const std::string key = part.substr(0, equals);
    if (key == "read" && value >= 0 && value < 1)
      noise.read = value;
    else if (key == "full_well" && value > 0 && value < 1e30)
      noise.fullWell = value;
    else
      throw wrong(part);
  }
  return noise;
}

void SolveArguments::addTo(CLI::App& verb) {
  addWithoutHighlightsTo(verb);
  m_options.push_back(
      verb.add_option(kHighlights, m_highlights,
                      "on or off: keep what of each light is highlight, where the photographs show some (a "
                      "set with them takes up to twice the memory)")
          ->type_name("HOW")
          ->capture_default_str()
          ->group(kGroup));
}

void SolveArguments::addWithoutHighlightsTo(CLI::App& verb) {
  const auto add = [&](CLI::Option* option) {
    m_options.push_back(option->group(kGroup));
    return option;
  };
  add(verb.add_option("--model", m_model, "Model of a pixel: auto, single, lambert, gloss or transport"))
      ->type_name("NAME")
      ->capture_default_str();
  std::vector<std::string_view> solvers;
  for (const EstimatorInfo& info : estimators()) solvers.push_back(info.name);
  add(verb.add_option("--solver", m_solve.solver,
                      fmt::format("Instead of the model's own estimator: {}", fmt::join(solvers, ", "))))
      ->type_name("NAME");
  add(verb.add_option("--denoise", m_denoise,
                      "off or guided: smooth remaining noise in beta, guided by the edges of the sum"))
      ->type_name("HOW")
      ->capture_default_str();
  add(verb.add_flag(
      "--solve-ambient", m_solve.solveAmbient,
      "Solve for ambient light, the same in every photograph (needs more photographs than lights)"));
  add(verb.add_option("--align", m_align,
                      "on: register the photographs to the first. sure: where they surely show that the "
                      "camera moved. off: "
                      "never"))
      ->type_name("HOW")
      ->capture_default_str();
  add(verb.add_flag("--refine-colors", m_solve.refineColors,
                    "Refine the light colours from the photographs, starting at the capture's"));
  add(verb.add_flag("--field", m_solve.field,
                    "Even lamps whose colour drifts over the picture, as far as the photographs show it "
                    "(nothing where they do not); a grey card under each lamp (--flat) knows more"));
  add(verb.add_option("--color-uncertainty", m_solve.colorUncertainty,
                      "Relative standard error of the light colours, e.g. .03 (default: estimated)"))
      ->check(NumberRange(0.0, 1.0))
      ->type_name("X");
  add(verb.add_option("--one-lamp", m_oneLamp,
                      "Settles an unknown colour: a pixel that only this light reaches"))
      ->type_name("LIGHT=X,Y");
  add(verb.add_option("--grey", m_grey, "Settles an unknown colour: a pixel of a grey surface"))
      ->type_name("X,Y");
  add(verb.add_option(
          "--gel-luminance", m_luminance,
          "Settles an unknown colour: the share of the light that the gel lets through (Y on its data "
          "sheet)"))
      ->check(NumberRange(kLeastGelLuminance, 1.0))
      ->type_name("Y");
  add(verb.add_option("--open-color", m_position,
                      "Chooses an unknown colour where photographs leave it open: 0 nearest to the known one "
                      "(default), 1 farthest from it"))
      ->check(NumberRange(0.0, 1.0))
      ->type_name("X");
  add(verb.add_flag("--exchange-lamps", m_solve.openColor.exchanged,
                    "With an unknown colour: the lamps are the other way round than is likelier"));
  add(verb.add_option("--noise", m_noise, "The sensor's noise (default: the capture's, or estimated)"))
      ->type_name("read=X,full_well=X");
}

const CLI::Option* SolveArguments::given() const {
  const auto found = std::find_if(m_options.begin(), m_options.end(), [](const CLI::Option* option) {
    return option->count() > 0 && option->get_name() != kHighlights;  // solved sets are read without, too
  });
  return found != m_options.end() ? *found : nullptr;
}

void SolveArguments::check(const std::filesystem::path& source) const {
  if (const CLI::Option* option = given(); option && sourceKind(source) == SourceKind::SolvedSet)
    throw InputError("{}: {} is solved already; give its capture, or leave the option out",
                     option->get_name(), source.string());
}

SolveOptions SolveArguments::resolveOver(const SolveOptions& session) const {
  const SolveOptions own = resolve();
  if (given()) return own;
  SolveOptions options = session;
  const bool said = std::any_of(m_options.begin(), m_options.end(),
                                [](const CLI::Option* option) { return option->count() > 0; });
  if (said) options.highlights = own.highlights;
  return options;
}

SolveOptions SolveArguments::resolveFor(const std::filesystem::path& source) const {
  check(source);
  return resolve();
}

SolveOptions SolveArguments::resolve() const {
  SolveOptions resolved = m_solve;
  resolved.model = modelFromName(m_model);
  if (!resolved.solver.empty() && resolved.model != Model::Auto &&
      resolved.model != estimatorInfo(resolved.solver).model)
    throw InputError("--solver {} assumes --model {}: leave out --model {}", resolved.solver,
                     modelName(estimatorInfo(resolved.solver).model), m_model);
  resolved.align = remedyFromText("--align", m_align, "off", "on");
  resolved.highlights = chosen(kHighlights, m_highlights, "off", "on");
  if (chosen("--denoise", m_denoise, "off", "guided")) resolved.denoise = Denoise::Guided;
  const int settled = !m_oneLamp.empty() + !m_grey.empty() + m_luminance.has_value() + m_position.has_value();
  if (settled > 1) throw InputError("--one-lamp, --grey, --gel-luminance, --open-color: give one of them");
  if (!m_oneLamp.empty()) resolved.openColor.oneLamp = oneLampFromText(m_oneLamp);
  if (!m_grey.empty()) resolved.openColor.grey = placeFromText(m_grey, "--grey " + m_grey);
  resolved.openColor.luminance = m_luminance;
  resolved.openColor.position = m_position;
  if (!m_noise.empty()) resolved.noise = noiseFromText(m_noise);
  return resolved;
}

}  // namespace swaplight
