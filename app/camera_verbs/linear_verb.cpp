#include <cmath>

#include "app/arguments/flat_arguments.h"
#include "app/camera_verbs/camera_verbs.h"
#include "app/program/description.h"
#include "core/base/json.h"
#include "core/capture/capture_pixels.h"
#include "core/capture/response_curve.h"
#include "core/ocio/chosen_config.h"
#include "core/session/open_source.h"
#include "core/solve/causes/linearity.h"

namespace swaplight {
namespace {

struct LinearCommand {
  std::string capture, response;
};

void line(const char* name, const ToneEvidence& one, Description& d) {
  d.line(name,
         fmt::format("light to the power of {:.3f} ± {:.3f}; a curve of three terms: {:.1f} ± {:.1f} %, "
                     "which explains {:.0f} % of the misfit",
                     one.exponent, one.exponentError, 100 * std::expm1(one.departure),
                     100 * one.departureError, 100 * one.explained));
}

int run(const LinearCommand& arguments, Terminal& terminal) {
  const std::shared_ptr<const ColorConfig> config = programConfig();
  Capture capture = readCapture(*config, sourceFile(arguments.capture));
  if (!arguments.response.empty()) {
    checkResponseFile(arguments.response, "--response");
    capture.colorSpace = pathInManifest(capture.folder, arguments.response);
  }
  sayWarnings(capture.warnings, terminal);
  const Progress progress = terminal.progress();
  const CapturePixels pixels = loadCapturePixels(*config, capture, progress.part(0, .5F));
  sayWarnings(pixels.warnings, terminal);
  const LinearityEvidence evidence = linearityOf(capture, pixels, progress.part(.5F, 1));
  Description d{"", jsonFromLinearity(evidence)};
  d.json["color_space"] = capture.colorSpace;
  d.line("light?", evidence.words);
  if (evidence.additivity)
    line(evidence.ambientProof ? "sums" : "sums, no ambient light", *evidence.additivity, d);
  if (evidence.matte) line("matte", *evidence.matte, d);
  terminal.result(d.text, d.json);
  return 0;
}

}  // namespace

void addLinearVerb(Program& program) {
  const auto a = std::make_shared<LinearCommand>();
  CLI::App& verb = program.addVerb("linear", "Say whether photographs hold light, as their colour space says",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("CAPTURE", a->capture, "capture.json, or the folder that holds it")->required();
  verb.add_option(
          "--response", a->response,
          "The camera's response, as swaplight response writes it, instead of the capture's color_space")
      ->type_name("CURVE.csv");
}

}  // namespace swaplight
