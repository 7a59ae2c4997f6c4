#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "app/arguments/display_arguments.h"
#include "app/arguments/solve_arguments.h"
#include "app/verbs/balance_work.h"
#include "app/verbs/verbs.h"
#include "core/balance/illuminant.h"
#include "core/balance/lamp_reading.h"
#include "core/balance/neutral_rig.h"
#include "core/balance/photograph.h"
#include "core/balance/set_balance.h"
#include "core/balance/two_color_balance.h"
#include "core/balance/white_point.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/export/frame_file.h"
#include "core/file/json_file.h"
#include "core/file/same_file.h"
#include "core/intake/shot_color.h"
#include "core/ocio/chosen_config.h"
#include "core/session/open_source.h"

namespace swaplight {
namespace {

struct BalanceCommand {
  std::string photograph;
  std::string output;
  std::string set;
  std::string colors;
  std::string method;
  std::string grey;
  std::string camera;
  bool chart = false;
  std::string map;
  std::string white = "D65";
  std::string lights = "all";
  std::string colorSpace;
  std::string noise;
  FrameOptions frame;
};

std::vector<Rgb> colorsFrom(const BalanceCommand& arguments, size_t expected, const std::string& of) {
  std::vector<Rgb> colors;
  for (const ShotColor& color : shotColorsFromText(arguments.colors)) {
    if (!color.color) throw InputError("--colors: '{}' is no colour: give every lamp's", color.text);
    colors.push_back(*color.color);
  }
  if (colors.size() != expected)
    throw InputError("--colors has {} colour{}, {} takes {}", colors.size(), colors.size() == 1 ? "" : "s",
                     of, expected);
  return colors;
}

void balanceWithSet(const BalanceCommand& arguments, BalanceWork& work, const Progress& progress) {
  SolveOptions solving;
  solving.highlights = false;  // nothing here looks at them
  const SolvedSet set = openSource(*work.config, arguments.set, solving, progress.part(0, 0.4F));
  const CapturePixels photograph = loadPhotographOf(*work.config, set, arguments.photograph,
                                                    arguments.colorSpace, progress.part(0.4F, 0.6F));
  work.warnings = photograph.warnings;
  LampReadingOptions options;
  if (!arguments.noise.empty()) options.noise = noiseFromText(arguments.noise);
  const LampReading reading = readLamps(set, photograph, options, progress.part(0.6F, 0.8F));
  LampBalance balance;
  balance.ambient = reading.ambient.value_or(1);
  for (const ReadLamp& lamp : reading.lamps) balance.lamps.push_back(lamp.color);
  if (arguments.colors.empty())
    work.warnings.insert(work.warnings.end(), reading.warnings.begin(), reading.warnings.end());
  else
    balance.lamps = colorsFrom(arguments, set.contributions.size(), arguments.set);
  work.picture = photograph.shots.front().clone();
  work.carried = photograph.carried;
  work.clip = photograph.clipLevel.front();
  work.setWhite(whitePointFromText(arguments.white));
  const std::vector<size_t> chosen = lightsFromText(defaultRig(set.capture), arguments.lights);
  balance.targets = whiteTargets(balance.lamps, chosen, work.white, work.weights);
  progress.update(0.8F, "balancing");
  work.picture =
      balanceBySet(set, work.picture, work.clip, balance, noiseModel(reading.noise, photograph, 0));
  for (size_t i = 0; i < balance.lamps.size(); ++i)
    work.json["lights"][set.capture.lights[i].name] = {{"color", jsonFromRgb(balance.lamps[i])},
                                                       {"balanced", jsonFromRgb(balance.targets[i])}};
  work.json["method"] = "set";
}

void loadPlain(const BalanceCommand& arguments, BalanceWork& work, const Progress& progress) {
  CapturePixels pixels = loadPhotograph(*work.config, arguments.photograph, arguments.colorSpace, progress);
  work.warnings = pixels.warnings;
  work.picture = std::move(pixels.shots.front());
  work.carried = pixels.carried;
  work.clip = pixels.clipLevel.front();
  work.setWhite(whitePointFromText(arguments.white));
}

void balanceWithColors(const BalanceCommand& arguments, BalanceWork& work) {
  const std::vector<Rgb> colors = colorsFrom(arguments, 2, "a balance without a solved set");
  for (const Rgb& color : colors)
    if (!(color.r + color.g + color.b > 0)) throw InputError("--colors: a lamp that is black lights nothing");
  if (!tellTwoLampsApart(colors[0], colors[1]))
    throw InputError(
        "--colors: the two lamps have the same colour: --method grey-world, or --grey, is for one");
  TwoColorBalance balanced = balanceByTwoColors(work.picture, colors[0], colors[1], work.white, work.weights);
  work.picture = std::move(balanced.picture);
  if (!arguments.map.empty()) writeImage(balanced.beta, arguments.map);
  work.json["method"] = "two-colors";
}

bool isRig(const BalanceCommand& arguments) {
  return lowerExtension(arguments.photograph) == ".json";
}

/// A rig's lights become white: what the studio's Neutralize does.
int balanceRig(const BalanceCommand& arguments, Terminal& terminal) {
  if (!arguments.set.empty() || !arguments.colors.empty() || !arguments.method.empty() ||
      !arguments.grey.empty() || arguments.chart || !arguments.camera.empty() || !arguments.map.empty() ||
      !arguments.noise.empty() || !arguments.colorSpace.empty())
    throw InputError(
        "{}: is a rig: its lights have colours of their own; leave out --beta, --colors, --method, --grey, "
        "--chart, --camera, --map, --noise and --color-space",
        arguments.photograph);
  const std::vector<std::filesystem::path> inputs{arguments.photograph};
  checkOutput(arguments.output, inputs);
  checkEnding(arguments.output, std::array{".json"}, "a rig");
  const WhitePoint white = whitePointFromText(arguments.white);
  Rig rig = readRig(arguments.photograph);
  try {
    rig = neutralized(rig, lightsFromText(rig, arguments.lights), white);
  } catch (const InputError& error) {
    throw InputError("--lights {}: {}", arguments.lights, error.what());
  }
  const Json json = jsonFromRig(rig);
  writeJson(json, arguments.output);
  terminal.say("wrote {}", arguments.output);
  terminal.result("", {{"rig", json}, {"white", textFromWhitePoint(white)}, {"output", arguments.output}});
  return 0;
}

void checkArguments(const BalanceCommand& arguments) {
  const bool method = !arguments.method.empty();
  const int ways =
      int(!arguments.set.empty()) + int(arguments.set.empty() && !arguments.colors.empty()) + int(method);
  if (ways > 1) throw InputError("give one of --beta, --colors and --method");
  if (ways == 0 && arguments.grey.empty() && !arguments.chart && arguments.camera.empty())
    throw InputError(
        "say how: --beta SOLVED (best), --colors FIRST,SECOND of two lamps, --grey X,Y of a card, --chart, "
        "--method NAME, or, of what is balanced already, --camera CAMERA.json");
  if (arguments.chart && (!arguments.grey.empty() || !arguments.camera.empty()))
    throw InputError("--chart: says what is grey, and the camera's matrix: leave out --grey and --camera");
  if (arguments.lights != "all" && arguments.set.empty())
    throw InputError("--lights: only a solved set tells lamps apart: give --beta SOLVED");
  if (!arguments.noise.empty() && arguments.set.empty())
    throw InputError("--noise: is of a photograph that a set's lamps are read from: give --beta SOLVED");
  if (!arguments.map.empty() && (!arguments.set.empty() || arguments.colors.empty()))
    throw InputError("--map: is of --colors without --beta; a solved set has its beta maps already");
}

int run(const BalanceCommand& arguments, Terminal& terminal) {
  if (isRig(arguments)) return balanceRig(arguments, terminal);
  checkArguments(arguments);
  BalanceWork work;
  work.config = programConfig();
  work.photograph = arguments.photograph;
  checkFrame(*work.config, arguments.output, arguments.frame);
  std::vector<std::filesystem::path> inputs{arguments.photograph};
  if (!arguments.set.empty()) {
    const std::vector<std::filesystem::path> read = filesOfSource(arguments.set);
    inputs.insert(inputs.end(), read.begin(), read.end());
  }
  if (!arguments.camera.empty()) inputs.emplace_back(arguments.camera);
  checkOutputs(std::array<std::filesystem::path, 2>{arguments.output, arguments.map}, inputs);
  const WhitePoint white = whitePointFromText(arguments.white);
  std::optional<CameraFile> camera;
  if (!arguments.camera.empty()) {
    camera = readCamera(arguments.camera);
    checkWhiteFor(*camera, *work.config, white);
  }

  const Progress progress = terminal.progress();
  work.json = {{"photograph", arguments.photograph}, {"output", arguments.output}};
  if (!arguments.set.empty()) {
    balanceWithSet(arguments, work, progress.part(0, 0.7F));
  } else {
    loadPlain(arguments, work, progress.part(0, 0.7F));
    if (!arguments.colors.empty()) balanceWithColors(arguments, work);
    if (!arguments.method.empty()) {
      work.picture = balanceByMethod(work.picture, work.clip, arguments.method, work.white, work.weights);
      work.json["method"] = arguments.method;
    }
  }
  if (!arguments.grey.empty()) balanceByCard(work, arguments.grey);
  if (arguments.chart) balanceByChart(work, white, progress.part(0.7F, 0.9F));
  if (camera) correctCamera(work, *camera, arguments.camera, white);
  sayWarnings(work.warnings, terminal);
  work.json["warnings"] = work.warnings;
  FrameOptions output = arguments.frame;
  output.write.carried = work.carried;
  writeFrame(*work.config, std::move(work.picture), arguments.output, output, progress.part(0.9F, 1));
  terminal.say("wrote {}", arguments.output);
  terminal.result("", work.json);
  return 0;
}

std::string methodNames() {
  std::vector<std::string_view> names;
  for (const BalanceMethod& method : balanceMethods()) names.emplace_back(method.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void addBalanceVerb(Program& program) {
  const auto a = std::make_shared<BalanceCommand>();
  CLI::App& verb =
      program.addVerb("balance", "White balance of a photograph under lamps of different colours",
                      [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("PHOTO", a->photograph, "The photograph; or a rig (JSON), whose lights become white")
      ->required();
  verb.add_option("-o,--output", a->output, "The balanced picture: EXR, HDR, PNG, TIFF or JPEG; or the rig")
      ->required()
      ->type_name("FRAME");
  verb.add_option(
          "--beta", a->set,
          "A solved set that the photograph is of (things and people may have come): it says which lamp "
          "lights what")
      ->type_name("SOLVED");
  verb.add_option(
          "--colors", a->colors,
          "What the lamps' colours were: with --beta one a light (default: read from the photograph); "
          "without it those of two lamps")
      ->type_name("LIST");
  verb.add_option("--method", a->method, "Without knowing the lamps: " + methodNames())->type_name("NAME");
  verb.add_option("--grey", a->grey, "A grey card in the photograph, which becomes neutral at last")
      ->type_name("X,Y[,SIDE]");
  verb.add_flag("--chart", a->chart,
                "A Macbeth chart in the photograph: its greys become neutral, and the camera's colours "
                "Rec.709's, at last");
  verb.add_option("--camera", a->camera,
                  "The camera's matrix, as swaplight chart writes it: the balanced picture's colours become "
                  "Rec.709's")
      ->type_name("CAMERA.json");
  verb.add_option("--white", a->white, "A, D50, D55, D60, D65, 4300K, or with a Duv: 4300K,duv:+0.003")
      ->capture_default_str()
      ->type_name("WHITE");
  verb.add_option("--lights", a->lights,
                  "Lamps that become white: all, key,fill or all-but:key (with --beta, or of a rig)")
      ->capture_default_str()
      ->type_name("NAMES");
  verb.add_option("--map", a->map, "Write the first lamp's share of every pixel (with two --colors)")
      ->type_name("FILE");
  verb.add_option("--color-space", a->colorSpace, "Of the photograph (default: as the file says)")
      ->type_name("NAME");
  verb.add_option("--noise", a->noise, "Of the photograph, as read=.002,full_well=20000")->type_name("NOISE");
  addDisplayOptions(verb, a->frame.display);
  verb.add_flag("--linear", a->frame.linear, "Scene-linear pixels, whatever the format");
}

}  // namespace swaplight
