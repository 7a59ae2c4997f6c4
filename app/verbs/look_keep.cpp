#include "app/verbs/look_actions.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/filter/kept_filter.h"

namespace swaplight {

int keepFilterAs(const LookArguments& arguments, Terminal& terminal) {
  if (arguments.names.size() != 1)
    throw InputError("look keep: name one filter with what is to be its defaults: NAME,parameter=value");
  const FilterStage typed = stageFromText(arguments.names[0]);
  const ResolvedStage stage =
      resolveStage(installedFilters(), typed, std::filesystem::current_path(), "look keep");
  const std::filesystem::path file = keepFilter(stage, personalFilterFolders().front().path, arguments.name);
  terminal.say("wrote {}", file.string());
  terminal.result("", {{"filter", file.stem().string()}, {"file", file.string()}});
  return 0;
}

}  // namespace swaplight
