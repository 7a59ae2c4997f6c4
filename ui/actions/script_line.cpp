#include "ui/actions/script_line.h"

#include <cmath>
#include <sstream>

#include "core/base/error.h"

namespace swaplight {
namespace {

double number(const ScriptLine& line, double most) {
  std::istringstream words(line.argument);
  double value = 0;
  std::string more;
  if (!(words >> value) || words >> more || !(value >= 0 && value <= most))
    throw InputError("{}: \"{}\" is no number from 0 to {:.0f}", line.command, line.argument, most);
  return value;
}

}  // namespace

std::vector<ScriptLine> scriptLines(const std::string& text) {
  std::vector<ScriptLine> lines;
  std::istringstream in(text);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ScriptLine read{++number, {}, {}};
    std::istringstream words(line);
    words >> read.command;
    std::getline(words >> std::ws, read.argument);
    if (!read.command.empty() && line[0] != '#') lines.push_back(std::move(read));
  }
  return lines;
}

int scriptCount(const ScriptLine& line) {
  constexpr double kMost = 1e6;
  return static_cast<int>(number(line, kMost));
}

double scriptSeconds(const ScriptLine& line) {
  constexpr double kMost = 3600;
  return number(line, kMost);
}

ScriptPlaces scriptPlaces(const ScriptLine& line) {
  std::istringstream words(line.argument);
  ScriptPlaces read;
  words >> read.item;
  for (float place = 0; words >> place;) read.places.push_back(place);
  const bool drags = line.command == "drag";
  if (read.places.empty() && !drags) read.places = {0.5F, 0.5F};
  bool fits = words.eof() && read.places.size() == (drags ? 4U : 2U);
  for (const float place : read.places) fits &= std::abs(place) <= 1000;
  if (!fits) throw InputError("{}: write X Y from 0 to 1", line.command);
  return read;
}

}  // namespace swaplight
