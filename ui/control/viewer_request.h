#pragma once

#include <optional>
#include <string>

#include "ui/control/viewer_context.h"

namespace swaplight {

/// The pictures that the viewer shows now; nothing while one of them is still being read.
struct ViewerPictures {
  std::optional<LayeredPicture> a;
  std::optional<LayeredPicture> b;  ///< where there is a comparison
};
[[nodiscard]] ViewerPictures viewerPictures(const ViewerContext& studio);

/// The wipe's line in the picture's pixels.
[[nodiscard]] Comparison wipeIn(const CompareState& state, int pictureWidth, int pictureHeight);

/// The pixels of the picture that a window may show.
[[nodiscard]] PixelRect visiblePart(const ViewWindow& window);

/// The viewer's settings with the session's display and view.
[[nodiscard]] ViewSettings viewerSettings(const ViewerContext& studio);

/// A subject in words, as "beta of key".
[[nodiscard]] std::string subjectWords(const ViewerContext& studio, const ViewSubject& subject);
/// What A is compared with, in words.
[[nodiscard]] std::string sideBWords(const ViewerContext& studio);

/// The relit picture as the viewer shows it, under the camera look; nullptr where it is shown without one, or
/// another picture is shown.
[[nodiscard]] std::shared_ptr<const SeenPicture> seenNow(const ViewerContext& studio);

}  // namespace swaplight
