#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/ocio/color_grade.h"

namespace swaplight {

/// --cdl and --cdl-id: a grade in place of the session's. Must live as long as the verb.
class GradeArguments {
 public:
  void addTo(CLI::App& verb);
  /// What is asked for; nothing: the session's. "none" is a grade that changes nothing. Throws InputError.
  [[nodiscard]] std::optional<ColorGrade> grade() const;
  [[nodiscard]] std::vector<std::filesystem::path> inputs() const;

 private:
  std::string m_file;
  std::string m_id;
};

}  // namespace swaplight
