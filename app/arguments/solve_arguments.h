#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/solve/model/solve_options.h"

namespace swaplight {

/// "read=.002,full_well=20000", as --noise has it. Throws InputError that says what would be right.
[[nodiscard]] SensorNoise noiseFromText(const std::string& text);

/// What an option of two words says, and "sure" between them. Throws InputError that lists them.
[[nodiscard]] Remedy remedyFromText(const char* option, const std::string& text, const char* off,
                                    const char* on);

/// The options of solving, for every verb that solves. They are texts until the verb runs, so that a mistake
/// is said as every other one.
class SolveArguments {
 public:
  void addTo(CLI::App& verb);
  /// For verbs that look at no highlights.
  void addWithoutHighlightsTo(CLI::App& verb);
  /// Throws InputError where the command line says how to solve a source that is a solved set.
  void check(const std::filesystem::path& source) const;
  /// Throws InputError that quotes the option that is wrong.
  [[nodiscard]] SolveOptions resolve() const;
  /// The same for a session's set: as the session has it where the command line does not say how to solve.
  [[nodiscard]] SolveOptions resolveOver(const SolveOptions& session) const;
  /// The same for a source, which check() looks at first.
  [[nodiscard]] SolveOptions resolveFor(const std::filesystem::path& source) const;

 private:
  /// The first option that the command line has and that says how to solve; nullptr where it has none.
  [[nodiscard]] const CLI::Option* given() const;

  std::string m_model = "auto";
  std::string m_highlights = "on";
  std::string m_align = "sure";
  std::string m_denoise = "off";
  std::string m_noise;
  std::string m_oneLamp;
  std::string m_grey;
  std::optional<float> m_luminance;
  std::optional<float> m_position;
  SolveOptions m_solve;
  std::vector<const CLI::Option*> m_options;
};

}  // namespace swaplight
