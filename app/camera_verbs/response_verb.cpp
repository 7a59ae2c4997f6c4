#include <algorithm>

#include "app/camera_verbs/camera_verbs.h"
#include "app/program/description.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/intake/response_fit.h"
#include "core/ocio/chosen_config.h"

namespace swaplight {
namespace {

constexpr double kMuchMisfit = .1;  // of the light: wrong exposures, or too few

struct ResponseCommand {
  std::string folder, exposures, output;
  std::string method = "debevec";
};

/// As told, or as the files say; all of them are one bracket where nothing repeats itself.
Brackets bracketsFor(const ResponseCommand& arguments, const ShotFolder& folder) {
  if (arguments.exposures.empty()) return statedBrackets(folder);
  Brackets brackets = toldBrackets(folder, arguments.exposures);
  if (brackets.length == 1) brackets.length = static_cast<int>(folder.shots.size());
  return brackets;
}

ResponseMethod methodOf(const std::string& name) {
  if (name == "debevec") return ResponseMethod::Debevec;
  if (name == "robertson") return ResponseMethod::Robertson;
  throw InputError("--method: '{}' is not known; known: debevec, robertson", name);
}

Description descriptionOf(const ResponseFit& fit, const ShotFolder& folder, const Brackets& brackets) {
  Description d{"", Json::object()};
  d.line("photographs", fmt::format("{}, {}", folder.shots.size(), brackets.words));
  d.line("nearest", fmt::format("{}, which differs by up to {:.1f} % of full scale", fit.nearest,
                                100 * fit.nearestDifference));
  d.line("misfit", fmt::format("{:.1f}, {:.1f}, {:.1f} % of the light", 100 * fit.misfit[0],
                               100 * fit.misfit[1], 100 * fit.misfit[2]));
  d.line("other method", fmt::format("differs by up to {:.1f} % of full scale", 100 * fit.methodDifference));
  const double darkest = *std::max_element(fit.darkest.begin(), fit.darkest.end());
  d.line("seen", fmt::format("codes from {:.0f} of 255; below it is continued", 255 * darkest));
  d.json = {{"exposures", brackets.words},
            {"nearest", fit.nearest},
            {"nearest_difference", fit.nearestDifference},
            {"method_difference", fit.methodDifference},
            {"misfit", fit.misfit},
            {"darkest_code", fit.darkest}};
  return d;
}

int run(const ResponseCommand& arguments, Terminal& terminal) {
  checkResponseFile(arguments.output, "--output");
  const ResponseMethod method = methodOf(arguments.method);
  const ShotFolder folder = scanShotFolder(*programConfig(), arguments.folder);
  sayWarnings(folder.notes, terminal);
  const Brackets brackets = bracketsFor(arguments, folder);
  const ResponseFit fit = fitResponse(loadCodes(folder), brackets, method);
  writeResponse(fit.curve, arguments.output);
  terminal.say("wrote {}", arguments.output);
  if (const double worst = *std::max_element(fit.misfit.begin(), fit.misfit.end()); worst > kMuchMisfit)
    sayWarnings(
        {fmt::format("{}: the curve leaves {:.0f} % of the light unexplained: check the exposures and "
                     "their order, and that nothing but the exposure changed",
                     arguments.output, 100 * worst)},
        terminal);
  Description d = descriptionOf(fit, folder, brackets);
  d.json["response"] = arguments.output;
  d.json["method"] = arguments.method;
  terminal.result(d.text, d.json);
  return 0;
}

}  // namespace

void addResponseVerb(Program& program) {
  const auto a = std::make_shared<ResponseCommand>();
  CLI::App& verb = program.addVerb("response", "Recover a camera's response curve from brackets",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("FOLDER", a->folder, "JPEG, PNG or TIFF photographs of one light at several exposures")
      ->required();
  verb.add_option("-o,--output", a->output, "The curve, for --response of new and solve")
      ->required()
      ->type_name("CURVE.csv");
  verb.add_option("--exposures", a->exposures,
                  "Their exposures in stops, in the photographs' order (default: as the files say)")
      ->type_name("0,-1,-2");
  verb.add_option("--method", a->method,
                  "debevec: least squares of the logarithm of light (Debevec and Malik); robertson: of light")
      ->type_name("HOW")
      ->capture_default_str();
}

}  // namespace swaplight
