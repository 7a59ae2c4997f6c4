#include <cmath>

#include "app/verbs/look_actions.h"
#include "app/verbs/look_frame.h"
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

/// The stages of everything that can be shown: filters with their defaults, looks as they are.
std::vector<std::pair<std::string, std::vector<ResolvedStage>>> allOf(const FilterLibrary& library) {
  std::vector<std::pair<std::string, std::vector<ResolvedStage>>> all;
  for (const auto& filter : library.filters())
    all.push_back({filter->name, {resolveStage(library, stageFromText(filter->name), {}, filter->name)}});
  for (const FilterPipeline& look : pipelinesIn(installedLookFolders())) {
    std::vector<ResolvedStage> stages;
    for (const FilterStage& stage : look.stages)
      if (stage.on) stages.push_back(resolveStage(library, stage, look.folder, look.name));
    all.push_back({"look " + look.name, std::move(stages)});
  }
  return all;
}

}  // namespace

int drawThumbnails(const LookArguments& arguments, Terminal& terminal) {
  if (arguments.names.size() != 1 || arguments.output.empty())
    throw InputError("look thumbnails: name one frame, and the folder for the pictures (-o FOLDER)");
  std::error_code error;
  fs::create_directories(arguments.output, error);
  if (error) throw InputError("{}: the folder cannot be made: {}", arguments.output, error.message());
  const std::shared_ptr<const ColorConfig> config = programConfig();
  const FilteredImage frame = shrunk(readFrame(arguments.names[0], false), arguments.width);
  const FilterLibrary library = installedFilters();
  const EglContext context;
  PipelineRenderer renderer;
  Json written = Json::array();
  PipelineOptions options;
  options.time = arguments.time;
  options.mostSecondsPerTile = arguments.mostSeconds;
  options.displayFromScene = displayFromScene(*config, frame.image.spec().colorSpace, arguments.frame);
  for (const auto& [name, stages] : allOf(library)) try {
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
