#pragma once

#include <CLI/CLI.hpp>

namespace swaplight {

/// A check of an option: a number from `low` to `high`. (CLI::Range lets NaN pass: it is neither below nor
/// above.)
class NumberRange : public CLI::Validator {
 public:
  NumberRange(double low, double high);
};

}  // namespace swaplight
