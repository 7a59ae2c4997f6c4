#include <fmt/format.h>

#include <cmath>
#include <span>

#include "app/arguments/look_frame.h"
#include "app/look_verbs/look_actions.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/export/filtered_frame.h"
#include "core/image/shrunk_image.h"
#include "core/ocio/chosen_config.h"
#include "render/gl/egl_context.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

FilteredImage shrunk(const FilteredImage& frame, int width) {
  const int height = static_cast<int>(
      std::lround(static_cast<double>(width) * frame.image.height() / std::max(frame.image.width(), 1)));
  return {shrunkImage(frame.image, width, std::max(height, 1)), frame.space};
}

/// What a picture is made of, and its file's name.
struct Thumbnail {
  std::string name;
  std::vector<ResolvedStage> stages;
};

/// Of a look; with `everyStage` also one after each of its filters, from the first on.
void addLook(std::vector<Thumbnail>& all, const FilterLibrary& library, const FilterPipeline& look,
             bool everyStage) {
  Thumbnail thumbnail{"look " + look.name, {}};
  for (const FilterStage& stage : look.stages) {
    if (!stage.on) continue;
    thumbnail.stages.push_back(resolveStage(library, stage, look.folder, look.name));
    const size_t count = thumbnail.stages.size();
    const std::string& filter = thumbnail.stages.back().filter->name;
    if (everyStage) all.push_back({fmt::format("{} {} {}", thumbnail.name, count, filter), thumbnail.stages});
  }
  all.push_back(std::move(thumbnail));
}

/// Of the looks that are named; else of everything there is, filters with their defaults.
std::vector<Thumbnail> thumbnailsOf(const LookArguments& arguments, const FilterLibrary& library) {
  std::vector<Thumbnail> all;
  const std::span<const std::string> named = std::span(arguments.names).subspan(1);
  for (const std::string& look : named)
    addLook(all, library, findPipeline(look, installedLookFolders()), arguments.stages);
  if (!named.empty()) return all;
  for (const auto& filter : library.filters())
    all.push_back({filter->name, {resolveStage(library, stageFromText(filter->name), {}, filter->name)}});
  for (const FilterPipeline& look : pipelinesIn(installedLookFolders()))
    addLook(all, library, look, arguments.stages);
  return all;
}

}  // namespace

int drawThumbnails(const LookArguments& arguments, Terminal& terminal) {
  if (arguments.names.empty() || arguments.output.empty())
    throw InputError(
        "look thumbnails: name a frame, camera looks if it is to be those alone, and the folder for the "
        "pictures (-o FOLDER)");
  std::error_code error;
  fs::create_directories(arguments.output, error);
  if (error) throw InputError("{}: the folder cannot be made: {}", arguments.output, error.message());
  const std::shared_ptr<const ColorConfig> config = programConfig();
  const FilteredImage frame = shrunk(readFrame(arguments.names[0], false).frame, arguments.width);
  const FilterLibrary library = installedFilters();
  const EglContext context;
  PipelineRenderer renderer;
  Json written = Json::array();
  PipelineOptions options;
  options.time = {arguments.frameNumber.value_or(0), arguments.framesPerSecond};
  options.limitsPerTile.mostSeconds = arguments.mostSeconds;
  options.displayFromScene = displayFromScene(*config, frame.image.spec().colorSpace, arguments.frame);
  for (const auto& [name, stages] : thumbnailsOf(arguments, library)) try {
      FilteredImage picture{frame.image.clone(), frame.space};
      picture = renderer.apply(std::move(picture), stages, options);
      const fs::path file = fs::path(arguments.output) / (name + ".png");
      writeFilteredFrame(*config, std::move(picture), file, arguments.frame);
      written.push_back(file.string());
    } catch (const InputError& broken) {
      terminal.say("warning: {}", broken.what());
    }
  terminal.say("wrote {} pictures into {}", written.size(), arguments.output);
  terminal.result("", {{"pictures", std::move(written)}});
  return 0;
}

}  // namespace swaplight
