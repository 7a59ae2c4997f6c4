#pragma once

#include <string>
#include <vector>

namespace swaplight {

/// A line of the studio's script: a command and the rest. Readers of the rest throw InputError.
struct ScriptLine {
  int number = 0;  ///< from 1
  std::string command;
  std::string argument;
};

/// The lines that say something; `#` begins a comment.
[[nodiscard]] std::vector<ScriptLine> scriptLines(const std::string& text);
/// A count of frames, 0 to a million.
[[nodiscard]] int scriptCount(const ScriptLine& line);
/// Seconds, 0 to an hour.
[[nodiscard]] double scriptSeconds(const ScriptLine& line);

/// A widget, and places on it as parts of its width and height: two numbers, for `drag` four.
struct ScriptPlaces {
  std::string item;
  std::vector<float> places;
};
[[nodiscard]] ScriptPlaces scriptPlaces(const ScriptLine& line);

}  // namespace swaplight
