#pragma once

#include <memory>

#include "core/image/small_picture.h"
#include "core/look/saved_look.h"
#include "core/view/display/display_table.h"
#include "ui/control/lights_context.h"

namespace swaplight {

/// Pictures of versions, which have other edits than the set that is shown: made of a small copy of it.
class VersionPictures {
 public:
  /// At most `width` x `height`. There is a set, and the look is a version. Edits that cannot be applied (a
  /// file of theirs is gone) are left out.
  [[nodiscard]] SmallPicture draw(const LightsContext& studio, const SavedLook& version,
                                  const DisplayTable& table, int width, int height);

 private:
  std::shared_ptr<const SolvedSet> m_original;  ///< what the copy is of
  std::shared_ptr<const SolvedSet> m_small;
};

}  // namespace swaplight
