#include <array>

#include "app/arguments/look_frame.h"
#include "app/look_verbs/look_actions.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/export/filtered_frame.h"
#include "core/file/same_file.h"
#include "core/ocio/chosen_config.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

FilterPipeline pipelineOf(const LookArguments& arguments) {
  if (arguments.request.empty())
    throw InputError(
        "look apply: name a look (--look NAME) or filters (--filter NAME,param=value): one of the two");
  FilterPipeline pipeline = arguments.request.pipeline();
  if (arguments.request.look.empty())
    pipeline.name = !arguments.name.empty() ? arguments.name : fs::path(arguments.save).stem().string();
  return pipeline;
}

}  // namespace

int applyFilters(const LookArguments& arguments, Terminal& terminal) {
  if (arguments.names.size() != 1) throw InputError("look apply: name one frame");
  if (arguments.output.empty()) throw InputError("look apply: say where the frame goes (-o FRAME)");
  const std::string& file = arguments.names[0];
  const std::string frameFile = stillName(arguments.output, arguments.frameNumber);
  const std::shared_ptr<const ColorConfig> config = programConfig();
  checkFrame(*config, frameFile, arguments.frame);
  checkOutputs(std::array<fs::path, 2>{frameFile, arguments.save},
               std::array<fs::path, 2>{file, arguments.request.look});
  const FilterPipeline pipeline = pipelineOf(arguments);
  const bool typed = arguments.request.look.empty();
  const std::shared_ptr<CameraLook> look =
      readyLook(pipeline, typed ? "--filter" : arguments.request.look, typed,
                {arguments.framesPerSecond, arguments.tileSide, arguments.mostSeconds}, terminal);

  const std::unique_ptr<const ImagesInFiles> large = largeImagesBeside(frameFile, arguments.tileSide);
  auto [frame, carried, warnings] = readFrame(file, arguments.alpha);
  sayWarnings(warnings, terminal);
  FrameOptions output = arguments.frame;
  const int width = frame.image.width(), height = frame.image.height();
  const std::string space = frame.image.spec().colorSpace;
  frame = look->apply(std::move(frame), displayFromScene(*config, space, arguments.frame),
                      arguments.frameNumber.value_or(0), terminal.progress());
  if (carried && carried->dataWindow)
    output.write.dataWindow = windowWithLight(*carried->dataWindow, frame.image);
  output.write.carried = std::move(carried);
  writeFilteredFrame(*config, std::move(frame), frameFile, output);
  terminal.say("wrote {}, {} x {} pixels", frameFile, width, height);
  if (!arguments.save.empty()) {
    writePipeline(standalone(pipeline, installedFilters()), arguments.save);
    terminal.say("wrote {}", arguments.save);
  }
  Json names = Json::array();
  for (const ResolvedStage& stage : look->stages()) names.push_back(stage.filter->name);
  terminal.result("", {{"frame", frameFile},
                       {"width", width},
                       {"height", height},
                       {"filters", names},
                       {"left_out", look->leftOut()}});
  return codeWithLook(0, look.get());
}

}  // namespace swaplight
