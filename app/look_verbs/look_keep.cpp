#include <fmt/ranges.h>

#include "app/look_verbs/look_actions.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/filter/favourite_looks.h"
#include "core/filter/filter_names.h"
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

int starLooks(const LookArguments& arguments, Terminal& terminal) {
  if (arguments.names.empty()) throw InputError("look {}: name a camera look", arguments.action);
  const bool star = arguments.action == "star";
  std::vector<std::string> names = readFavouriteLooks(favouriteLooksFile());
  for (const std::string& name : arguments.names) {
    if (isLookFile(name))
      throw InputError("look {}: {}: a favourite is a look of the library; put the file into {}",
                       arguments.action, name, installedLookFolders().front().string());
    if (!star && !isFavourite(names, name)) throw InputError("look unstar: {} is no favourite", name);
    names = star ? withFavourite(std::move(names), findPipeline(name, installedLookFolders()).name)
                 : withoutFavourite(std::move(names), name);
  }
  writeFavouriteLooks(names, favouriteLooksFile());
  terminal.say("favourites: {}", names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")));
  terminal.result("", {{"favourites", names}});
  return 0;
}

}  // namespace swaplight
