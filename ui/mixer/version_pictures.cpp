#include "ui/mixer/version_pictures.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/session/open_source.h"
#include "core/set/shrunk_set.h"
#include "ui/pictures/frame_picture.h"

namespace swaplight {
namespace {

constexpr int kLongest = 320;  ///< of the small copy, in pixels: more than a thumbnail has

std::shared_ptr<const SolvedSet> smallCopy(const SolvedSet& set) {
  const int factor = std::max(1, (std::max(set.width(), set.height()) + kLongest - 1) / kLongest);
  return std::make_shared<const SolvedSet>(
      shrunkSet(set, std::max(1, set.width() / factor), std::max(1, set.height() / factor)));
}

std::shared_ptr<const SolvedSet> editedCopy(const std::shared_ptr<const SolvedSet>& small,
                                            const EditStack& edits) {
  if (edits.edits.empty() && edits.newLights.empty()) return small;
  try {
    return std::make_shared<const SolvedSet>(withEdits(small, edits));
  } catch (const InputError&) {
    return small;
  }
}

}  // namespace

SmallPicture VersionPictures::draw(const LightsContext& studio, const SavedLook& version,
                                   const DisplayTable& table, int width, int height) {
  const OpenSet& set = *studio.set();
  if (m_original != set.original) {
    m_original = set.original;
    m_small = smallCopy(*m_original);
  }
  const auto edited = editedCopy(m_small, version.scene->edits);
  return framePicture(*edited, ViewPictures(edited), *studio.colors.config(), table, version.rig, width,
                      height);
}

}  // namespace swaplight
