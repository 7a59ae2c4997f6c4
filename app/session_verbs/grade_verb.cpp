#include <algorithm>
#include <initializer_list>
#include <sstream>

#include "app/arguments/grade_arguments.h"
#include "app/arguments/lighting_arguments.h"
#include "app/program/description.h"
#include "app/session_verbs/session_verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/same_file.h"
#include "core/ocio/grade_file.h"
#include "core/session/session_file.h"
#include "core/session/session_parts.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

using Triple = std::array<double, 3>;

struct GradeCommand {
  std::string source;
  std::string id;
  std::string output;
  std::string from;
  std::map<std::string, std::string> values;  ///< by option, as typed
  bool on = false, off = false, reset = false;

  [[nodiscard]] bool changes() const { return on || off || reset || !from.empty() || !values.empty(); }
};

constexpr const char* kSaturationOption = "--saturation";

/// "1.1" for all channels, or "1.1/1/0.9".
Triple tripleFromText(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, '/');) {
    std::istringstream number(part);
    double value = 0;
    if (!(number >> value) || !number.eof())
      throw InputError("{} {}: give a number, or three as 1.1/1/0.9", option, text);
    numbers.push_back(value);
  }
  if (numbers.size() == 1) return {numbers[0], numbers[0], numbers[0]};
  if (numbers.size() != 3) throw InputError("{} {}: give a number, or three as 1.1/1/0.9", option, text);
  return {numbers[0], numbers[1], numbers[2]};
}

/// Options that speak against each other, or of a file that is not there, are mistakes.
void check(const GradeCommand& arguments) {
  const auto firstOf = [&](std::initializer_list<const char*> options) {
    const auto found = std::find_if(options.begin(), options.end(),
                                    [&](const char* option) { return arguments.values.contains(option); });
    return found != options.end() ? *found : nullptr;
  };
  const char* wheel = firstOf({"--lift", "--gamma", "--gain"});
  const char* cdl = firstOf({"--slope", "--offset", "--power"});
  if (wheel && cdl)
    throw InputError(
        "{} and {}: lift, gamma and gain are another way to say slope, offset and power; give those of one "
        "kind",
        wheel, cdl);
  if (arguments.on && arguments.off) throw InputError("--on and --off: give one of them");
  if (arguments.reset && !arguments.from.empty())
    throw InputError("--from and --reset: each begins anew; give one of them");
  if (!arguments.id.empty() && arguments.from.empty() && isSessionFile(arguments.source))
    throw InputError("--id {}: is of a .ccc or .cdl file: name it by --from", arguments.id);
}

ColorGrade changed(ColorGrade grade, const GradeCommand& arguments) {
  if (arguments.reset) grade = {};
  if (!arguments.from.empty()) grade = readGrade(arguments.from, arguments.id);
  LiftGammaGain wheels = liftGammaGainOf(grade);
  bool turned = false;
  const auto take = [&](const char* option, Triple& values) {
    const auto typed = arguments.values.find(option);
    if (typed == arguments.values.end()) return false;
    values = tripleFromText(option, typed->second);
    return true;
  };
  turned |= take("--lift", wheels.lift);
  turned |= take("--gamma", wheels.gamma);
  turned |= take("--gain", wheels.gain);
  for (const double gamma : wheels.gamma)
    if (!(gamma > 0)) throw InputError("--gamma {:g}: give more than 0", gamma);
  if (turned) grade = withLiftGammaGain(grade, wheels);
  take("--slope", grade.slope);
  take("--offset", grade.offset);
  take("--power", grade.power);
  Triple saturation{grade.saturation, 0, 0};
  if (take(kSaturationOption, saturation)) grade.saturation = saturation[0];
  if (arguments.on || arguments.off) grade.on = arguments.on;
  checkGrade(grade, "the grade");
  return grade;
}

std::string tripleText(const Triple& v) {
  return v[0] == v[1] && v[1] == v[2] ? fmt::format("{:g}", v[0])
                                      : fmt::format("{:g}/{:g}/{:g}", v[0], v[1], v[2]);
}

void tell(const ColorGrade& grade, Terminal& terminal) {
  const LiftGammaGain wheels = liftGammaGainOf(grade);
  std::vector<std::vector<std::string>> rows;
  if (!grade.on) rows.push_back({"grade", "off"});
  for (const auto& [name, values] : {std::pair{"lift", wheels.lift},
                                     {"gamma", wheels.gamma},
                                     {"gain", wheels.gain},
                                     {"slope", grade.slope},
                                     {"offset", grade.offset},
                                     {"power", grade.power}})
    rows.push_back({name, tripleText(values)});
  rows.push_back({"saturation", fmt::format("{:g}", grade.saturation)});
  Json json = jsonFromGrade(grade);
  json["lift"] = wheels.lift;
  json["gamma"] = wheels.gamma;
  json["gain"] = wheels.gain;
  terminal.result(tableText(rows), json);
}

/// Into a session, or a file of its own.
void write(const ColorGrade& grade, std::optional<Session> session, const GradeCommand& arguments,
           Terminal& terminal) {
  const std::string& output = arguments.output.empty() ? arguments.source : arguments.output;
  if (isGradeFile(output)) {
    const std::string space = LightingArguments::colors(session)->gradingSpace();
    if (!grade.on)
      sayWarnings(
          {output + ": the grade is off here, which such a file cannot say: other programs apply its values"},
          terminal);
    writeGrade(grade, output, "Swaplight: the finished frame, in " + space);
  } else if (session && isSessionFile(output)) {
    session->document.display.grade = grade;
    writeSession(*session, output);
  } else {
    throw InputError("{}: give a .cc, .ccc or .cdl file{}", output,
                     session ? ", or a session (NAME.swaplight)" : "");
  }
  terminal.say("wrote {}", output);
}

int run(const GradeCommand& arguments, Terminal& terminal) {
  check(arguments);
  std::optional<Session> session;
  ColorGrade grade;
  if (isSessionFile(arguments.source)) {
    session = readSession(arguments.source);
    sayWarnings(session->warnings, terminal);
    grade = session->document.display.grade.value_or(ColorGrade{});
  } else {
    grade = readGrade(arguments.source, arguments.id);
  }
  grade = changed(grade, arguments);
  if (arguments.changes() && arguments.output.empty() && !session)
    throw InputError("{}: say where the changed grade goes (-o FILE.cc)", arguments.source);
  std::vector<fs::path> inputs{arguments.from};
  // A session takes its grade itself; a file of corrections may hold others, which would be lost.
  if (!session || arguments.output != arguments.source) inputs.emplace_back(arguments.source);
  if (session) inputs.push_back(session->document.source);
  if (!arguments.output.empty()) checkOutput(arguments.output, inputs);
  if (arguments.changes() || !arguments.output.empty()) write(grade, session, arguments, terminal);
  tell(grade, terminal);
  return 0;
}

}  // namespace

void addGradeVerb(Program& program) {
  const auto a = std::make_shared<GradeCommand>();
  CLI::App& verb =
      program.addVerb("grade", "Show and change the grade of the finished frame; read and write ASC CDL",
                      [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("SOURCE", a->source, "A session (NAME.swaplight), or a .cc, .ccc or .cdl file")->required();
  verb.add_option("--from", a->from, "Take the correction of this file into the session")
      ->type_name("FILE.cc");
  verb.add_option("--id", a->id, "Which correction of a .ccc or .cdl (default: its first)")->type_name("ID");
  const auto value = [&](const char* option, const char* words) {
    verb.add_option_function<std::string>(
            option, [a, option](const std::string& text) { a->values[option] = text; }, words)
        ->type_name("X or R/G/B");
  };
  value("--lift", "Raises the dark parts and leaves white: 0 changes nothing");
  value("--gamma", "Brightens between black and white: 1 changes nothing");
  value("--gain", "Scales the codes and leaves black: 1 changes nothing");
  value("--slope", "ASC CDL: a factor, 0..16");
  value("--offset", "ASC CDL: added, -16..16");
  value("--power", "ASC CDL: the exponent, 1/16..16");
  value(kSaturationOption, "0 is black and white, 1 changes nothing");
  verb.add_flag("--on", a->on, "Switch the grade on");
  verb.add_flag("--off", a->off, "Switch it off; its values stay");
  verb.add_flag("--reset", a->reset, "Begin with a grade that changes nothing");
  verb.add_option("-o,--output", a->output,
                  "Write .cc, .ccc or .cdl, or another session (default: changes go into the session)")
      ->type_name("FILE");
}

}  // namespace swaplight
