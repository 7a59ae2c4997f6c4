#pragma once

#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

#include "app/program/printable.h"
#include "core/base/json.h"

namespace swaplight {

/// What is to be said about a thing: lines for people, an object for programs.
struct Description {
  std::string text;
  Json json = Json::object();

  /// A line "  label      value".
  void line(const std::string& label, const std::string& value) {
    text += fmt::format("  {:<12} {}\n", printable(label), printable(value));
  }
};

/// A table with its columns aligned; the first row is the heading.
[[nodiscard]] std::string tableText(std::vector<std::vector<std::string>> rows);

}  // namespace swaplight
