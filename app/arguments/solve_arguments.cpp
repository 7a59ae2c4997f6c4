#include "app/arguments/solve_arguments.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "app/program/number_range.h"
#include "core/base/error.h"
#include "core/solve/model/estimator.h"

namespace swaplight {
namespace {

/// True for the second of two words, false for the first.
bool chosen(const char* option, const std::string& text, const char* off, const char* on) {
  if (text != off && text != on)
    throw InputError("{}: '{}' is not known; known: {}, {}", option, text, off, on);
  return text == on;
}

}  // namespace

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
  const auto add = [&](CLI::Option* option) {
    m_options.push_back(option->group("Solving"));
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
  add(verb.add_option("--align", m_align, "off or on: register the photographs to the first"))
      ->type_name("HOW")
      ->capture_default_str();
  add(verb.add_flag("--refine-colors", m_solve.refineColors,
                    "Refine the light colours from the photographs, starting at the capture's"));
  add(verb.add_option("--color-uncertainty", m_solve.colorUncertainty,
                      "Relative standard error of the light colours, e.g. .03 (default: estimated)"))
      ->check(NumberRange(0.0, 1.0))
      ->type_name("X");
  add(verb.add_option("--noise", m_noise, "The sensor's noise (default: the capture's, or estimated)"))
      ->type_name("read=X,full_well=X");
}

bool SolveArguments::given() const {
  return std::any_of(m_options.begin(), m_options.end(),
                     [](const CLI::Option* option) { return option->count() > 0; });
}

SolveOptions SolveArguments::resolve() const {
  SolveOptions resolved = m_solve;
  resolved.model = modelFromName(m_model);
  resolved.align = chosen("--align", m_align, "off", "on");
  if (chosen("--denoise", m_denoise, "off", "guided")) resolved.denoise = Denoise::Guided;
  if (!m_noise.empty()) resolved.noise = noiseFromText(m_noise);
  return resolved;
}

}  // namespace swaplight
