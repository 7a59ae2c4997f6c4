#include "core/export/frame_export.h"

#include "core/base/json.h"
#include "core/export/filtered_frame.h"
#include "core/file/json_file.h"
#include "core/relight/relative_light.h"
#include "core/relight/relight.h"
#include "core/session/session_parts.h"

namespace swaplight {

FrameOptions frameOptionsFor(const DisplayChoice& display, const std::filesystem::path& file,
                             FrameOptions asked) {
  const bool decided = asked.linear || asked.tone;
  asked.seenThrough = asked.display.over(display);
  if (!decided && !isSceneLinear(file))
    asked.display = asked.seenThrough;
  else
    asked.display.grade.reset();  // see gradedLight; an EXR through a view has it from there
  if (!asked.display.empty()) asked.display.grade = asked.seenThrough.grade;
  return asked;
}

void exportFrame(const ColorConfig& config, const SolvedSet& set, const Rig& rig,
                 const std::filesystem::path& file, FrameOptions options, const Progress& progress) {
  progress.update(0, "relighting");
  const std::vector<Rgb> factors = rigFactors(config, rig, set.colorSpace());
  Image frame = relight(set, factors, rig.ambient);
  options.write.text["swaplight/rig"] = jsonText(jsonFromRig(rig));
  if (!options.write.carried) options.write.carried = set.carried;
  FilteredImage seen{std::move(frame), FilterSpace::SceneLinear};
  if (options.cameraLook) {
    options.write.text["swaplight/cameraLook"] = jsonText(jsonFromPipeline(options.cameraLook->pipeline()));
    progress.update(0.3F, "filtering");
    if (options.cameraLook->wantsLight()) seen.light = relativeLight(set, factors, rig.ambient);
    const auto toDisplay = displayFromScene(config, set.colorSpace(), options);
    seen =
        options.cameraLook->apply(std::move(seen), toDisplay, options.frameNumber, progress.part(0.3F, 0.6F));
    if (const auto& carried = options.write.carried; carried && carried->dataWindow)
      options.write.dataWindow = windowWithLight(*carried->dataWindow, seen.image);
  }
  seen = gradedLight(config, std::move(seen), options);
  if (const ColorGrade* grade = options.seenThrough.actingGrade())
    options.write.text["swaplight/grade"] = jsonText(jsonFromGrade(*grade));
  progress.update(0.6F, "writing");
  writeFilteredFrame(config, std::move(seen), file, options, progress.part(0.6F, 1));
}

}  // namespace swaplight
