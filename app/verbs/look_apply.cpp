#include "app/verbs/look_actions.h"
#include "app/verbs/look_frame.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/same_file.h"
#include "core/ocio/chosen_config.h"
#include "render/gl/egl_context.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

FilterPipeline pipelineOf(const LookArguments& arguments) {
  if (arguments.look.empty() == arguments.filters.empty())
    throw InputError(
        "look apply: name a look (--look NAME) or filters (--filter NAME,param=value): one of the two");
  if (!arguments.look.empty()) return findPipeline(arguments.look, installedLookFolders());
  FilterPipeline pipeline;
  pipeline.folder = fs::current_path();
  pipeline.name = !arguments.name.empty() ? arguments.name : fs::path(arguments.save).stem().string();
  for (const std::string& text : arguments.filters) pipeline.stages.push_back(stageFromText(text));
  return pipeline;
}

std::vector<ResolvedStage> resolve(const FilterPipeline& pipeline, const std::string& where) {
  const FilterLibrary library = installedFilters();
  std::vector<ResolvedStage> stages;
  for (const FilterStage& stage : pipeline.stages) {
    ResolvedStage resolved = resolveStage(library, stage, pipeline.folder, where);
    if (stage.on) stages.push_back(std::move(resolved));
  }
  return stages;
}

/// The pipeline with the values that its texts stand for.
FilterPipeline typed(FilterPipeline pipeline, const FilterLibrary& library) {
  for (FilterStage& stage : pipeline.stages) {
    const ResolvedStage resolved = resolveStage(library, stage, pipeline.folder, "--filter");
    for (size_t i = 0; i < resolved.values.size(); ++i)
      if (const auto given = stage.parameters.find(resolved.filter->inputs[i].name);
          given != stage.parameters.end())
        given->second = resolved.values[i];
  }
  return pipeline;
}

}  // namespace

int applyFilters(const LookArguments& arguments, Terminal& terminal) {
  if (arguments.names.size() != 1) throw InputError("look apply: name one frame");
  if (arguments.output.empty()) throw InputError("look apply: say where the frame goes (-o FRAME)");
  const std::string& file = arguments.names[0];
  const std::shared_ptr<const ColorConfig> config = programConfig();
  checkFrame(*config, arguments.output, arguments.frame);
  checkOutput(arguments.output, std::vector<fs::path>{file, arguments.look});
  if (!arguments.save.empty()) checkOutput(arguments.save, std::vector<fs::path>{file, arguments.look});
  const FilterPipeline pipeline = pipelineOf(arguments);
  const std::vector<ResolvedStage> stages =
      resolve(pipeline, arguments.look.empty() ? "--filter" : arguments.look);

  FilteredImage frame = readFrame(file, arguments.alpha);
  const int width = frame.image.width(), height = frame.image.height();
  const PipelineOptions options = pipelineOptionsFor(*config, frame, arguments);
  const EglContext context;
  PipelineRenderer renderer;
  frame = renderer.apply(std::move(frame), stages, options, terminal.progress());
  writeFiltered(*config, std::move(frame), arguments.output, arguments);
  terminal.say("wrote {}, {} x {} pixels", arguments.output, width, height);
  if (!arguments.save.empty()) {
    writePipeline(typed(pipeline, installedFilters()), arguments.save);
    terminal.say("wrote {}", arguments.save);
  }
  Json names = Json::array();
  for (const ResolvedStage& stage : stages) names.push_back(stage.filter->name);
  terminal.result("",
                  {{"frame", arguments.output}, {"width", width}, {"height", height}, {"filters", names}});
  return 0;
}

}  // namespace swaplight
