#include "app/look_verbs/look_actions.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/no_such_light.h"
#include "core/export/filtered_set.h"
#include "core/file/same_file.h"
#include "core/ocio/chosen_config.h"
#include "core/set/solved_file.h"

namespace swaplight {
int filterLightOfSet(const LookArguments& arguments, Terminal& terminal) {
  if (arguments.names.size() != 1 || arguments.output.empty())
    throw InputError("look light: name one solved set, and where the changed one goes (-o SOLVED.exr)");
  if (arguments.light.empty()) throw InputError("look light: say which light (--light NAME)");
  if (arguments.request.empty())
    throw InputError("look light: name a look (--look NAME) or filters (--filter NAME)");
  const std::string& file = arguments.names[0];
  checkSolvedFile(arguments.output);
  checkOutput(arguments.output, std::vector<std::filesystem::path>{file, arguments.request.look});
  const std::shared_ptr<const ColorConfig> config = programConfig();
  const bool typed = arguments.request.look.empty();
  const std::shared_ptr<CameraLook> look =
      readyLook(arguments.request.pipeline(), typed ? "--filter" : arguments.request.look, typed,
                {arguments.framesPerSecond, arguments.tileSide, arguments.mostSeconds}, terminal);
  checkPlace(*look, "light");
  const Progress progress = terminal.progress();
  SolvedSet set = readSolvedSet(file, progress.part(0, 0.3F));
  filterLight(*config, set, placeOfLight(set.capture, arguments.light, "look light"), *look,
              progress.part(0.3F, 0.7F));
  writeSolvedSet(set, arguments.output, {}, progress.part(0.7F, 1));
  terminal.say("wrote {}, {} x {} pixels", arguments.output, set.width(), set.height());
  terminal.result("",
                  {{"solved", arguments.output}, {"light", arguments.light}, {"left_out", look->leftOut()}});
  return codeWithLook(0, look.get());
}

}  // namespace swaplight
