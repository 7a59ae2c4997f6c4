#include "core/export/frame_export.h"

#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/relight/relight.h"

namespace swaplight {

FrameOptions frameOptionsFor(const DisplayChoice& display, const std::filesystem::path& file,
                             FrameOptions asked) {
  const bool decided = asked.linear || asked.tone;
  if (!decided && !isSceneLinear(file)) asked.display = asked.display.over(display);
  return asked;
}

void exportFrame(const ColorConfig& config, const SolvedSet& set, const Rig& rig,
                 const std::filesystem::path& file, FrameOptions options, const Progress& progress) {
  progress.update(0, "relighting");
  Image frame = relight(set, rigFactors(config, rig, set.colorSpace()), rig.ambient);
  progress.update(0.4F, "writing");
  options.write.text["swaplight/rig"] = jsonText(jsonFromRig(rig));
  if (!options.write.carried) options.write.carried = set.carried;
  writeFrame(config, std::move(frame), file, options, progress.part(0.4F, 1));
}

}  // namespace swaplight
