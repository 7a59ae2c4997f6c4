#pragma once

#include <string>
#include <vector>

#include "core/bench/hard_cases.h"
#include "core/bench/solution_error.h"

namespace swaplight {

/// A row of the hard-case suite.
struct HardCaseError {
  std::string name, group;
  bool matte = false, mixed = false;  ///< as HardCase
  double bound = 0;                   ///< relative RMSE of T that no matte fit of single pixels can beat
  struct Answer {
    std::string model;  ///< published, lambert, gloss, transport, auto
    SolutionError error;
  };
  std::vector<Answer> answers;  ///< of the models that fit the case

  /// A model's error, or null where it does not fit.
  [[nodiscard]] const SolutionError* find(const std::string& model) const;
};

/// Solves a case by every model, each as a person would call it: what is not said in the capture (above all
/// how far the light colours can be trusted) is estimated.
[[nodiscard]] HardCaseError measureHardCase(const HardCase& hardCase);

/// `published`: the dissertation's minimum and relight formula, for two lights.
[[nodiscard]] std::vector<std::string> hardCaseModels();

}  // namespace swaplight
