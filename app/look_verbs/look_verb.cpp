#include "app/arguments/display_arguments.h"
#include "app/look_verbs/look_actions.h"
#include "app/look_verbs/look_verbs.h"
#include "app/program/number_range.h"
#include "core/base/error.h"

namespace swaplight {
namespace {

int run(const LookArguments& arguments, Terminal& terminal) {
  if (arguments.action == "list") return listFilters(arguments, terminal);
  if (arguments.action == "show") return showFilter(arguments, terminal);
  if (arguments.action == "lint") return lintFilters(arguments, terminal);
  if (arguments.action == "apply") return applyFilters(arguments, terminal);
  if (arguments.action == "star" || arguments.action == "unstar") return starLooks(arguments, terminal);
  if (arguments.action == "keep") return keepFilterAs(arguments, terminal);
  if (arguments.action == "light") return filterLightOfSet(arguments, terminal);
  if (arguments.action == "thumbnails") return drawThumbnails(arguments, terminal);
  throw InputError("look {}: expected list, show, star, unstar, lint, apply, keep, light or thumbnails",
                   arguments.action);
}

}  // namespace

void addLookVerb(Program& program) {
  const auto a = std::make_shared<LookArguments>();
  CLI::App& verb =
      program.addVerb("look", "Camera shaders: list, show and check filters, and apply them to a frame",
                      [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("ACTION", a->action,
                  "list, show NAME, star LOOKS, unstar LOOKS, lint FILES, apply FRAME, "
                  "keep NAME,param=value, light SOLVED, or thumbnails FRAME [LOOKS]")
      ->required();
  verb.add_option("NAME", a->names,
                  "list: words to look for; show: a filter, a camera look or .swaplook; star, unstar: camera "
                  "looks that are favourites in the studio's mixer, or are not any more; "
                  "lint: files or folders; apply: the frame; thumbnails: the frame, and camera looks");
  verb.add_option("--look", a->request.look, "apply, light: a camera look, by name or file")
      ->type_name("NAME");
  // One value an option: a filter is not to swallow the frame.
  verb.add_option("--filter", a->request.filters,
                  "apply, light: a filter, with its parameters; again for the next one")
      ->type_name("NAME,param=value")
      ->expected(1)
      ->take_all();
  verb.add_option(
          "-o,--output", a->output,
          "apply: the frame: EXR and HDR in light, PNG, TIFF and JPEG for a display; thumbnails: a folder")
      ->type_name("FRAME");
  verb.add_option("--light", a->light, "light: the light whose contribution is filtered")->type_name("NAME");
  verb.add_option("--save", a->save, "apply: also write the filters as a camera look")
      ->type_name("FILE.swaplook");
  verb.add_option(
          "--name", a->name,
          "apply --save: the look's name (default: the file's); keep: the filter's (default: my-NAME)")
      ->type_name("TEXT");
  addDisplayOptions(verb, a->frame.display);
  verb.add_option("--type", a->frame.write.pixelType,
                  "apply: half, float, uint8 or uint16 (default: the format's)")
      ->type_name("TYPE");
  verb.add_option("--compression", a->frame.write.compression,
                  "apply, EXR: none, rle, zips, zip (default), piz, pxr24, b44, b44a, dwaa, dwab")
      ->type_name("NAME");
  verb.add_option("--frame", a->frameNumber,
                  "apply, thumbnails: the frame's number, from which grain and flicker follow (default: 0)")
      ->check(NumberRange(-1e8, 1e8))
      ->type_name("N");
  verb.add_option("--fps", a->framesPerSecond, "apply: frames a second (default: 24)")
      ->check(NumberRange(0.01, 10000))
      ->type_name("X");
  verb.add_option("--tile", a->tileSide,
                  "apply: longest side of the parts of large frames (default: 4096 pixels)")
      ->check(NumberRange(16, 16384))
      ->type_name("N");
  verb.add_option("--width", a->width, "thumbnails: width of a picture (default: 240 pixels)")
      ->check(NumberRange(16, 4096))
      ->type_name("N");
  verb.add_option("--seconds", a->mostSeconds, "The longest that a filter may take for a part (default: 20)")
      ->check(NumberRange(0.1, 1e5))
      ->type_name("X");
  verb.add_flag("--stages", a->stages, "thumbnails: one more after every filter of a camera look");
  verb.add_flag("--alpha", a->alpha, "apply: write alpha too (a matte)");
}

}  // namespace swaplight
