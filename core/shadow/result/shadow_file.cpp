#include "core/shadow/result/shadow_file.h"

#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/image/io/carried_data.h"
#include "core/image/io/image_write.h"

namespace swaplight {

void checkShadowFile(const std::filesystem::path& file) {
  if (lowerExtension(file) != ".exr")
    throw InputError("{}: shadows are written as OpenEXR. Name it {}.", file.string(),
                     std::filesystem::path(file).replace_extension(".exr").string());
}

void writeShadows(const SolvedSet& set, const std::vector<NamedShadows>& lights,
                  const std::filesystem::path& file) {
  checkShadowFile(file);
  const Image& first = lights.front().shadows->visibility;
  FileToWrite contents{first.width(), first.height(), {{}}, "data", {}, {}};
  std::vector<std::vector<float>> labels;
  for (const auto& [light, shadows] : lights) {
    std::vector<float>& plane = labels.emplace_back(shadows->labels.size());
    std::transform(shadows->labels.begin(), shadows->labels.end(), plane.begin(),
                   [](ShadowLabel label) { return static_cast<float>(label); });
    auto& channels = contents.parts.front().channels;
    channels.push_back({"shadow_" + light + ".Y", shadows->visibility.plane(0)});
    channels.push_back({"shadow_" + light + ".label", plane.data()});
  }
  if (set.carried) {  // of the picture's channels none
    addCarried(contents, *set.carried, false);
    contents.dataWindow = set.carried->dataWindow;
  }
  writeChannels(contents, file);
}

}  // namespace swaplight
