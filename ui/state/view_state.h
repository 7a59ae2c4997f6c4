#pragma once

#include <set>

#include "core/base/json_fwd.h"
#include "core/view/display/view_settings.h"
#include "core/view/view_subject.h"
#include "core/view/view_window.h"
#include "ui/state/compare_state.h"

namespace swaplight {

/// Where the person is looking: saved with the session, never undone.
struct ViewState {
  bool fit = true;  ///< the whole picture, whatever the window's size
  double zoom = 1;  ///< screen pixels a picture pixel, where not fitted
  double centerX = 0;
  double centerY = 0;  ///< the picture's point in the middle of the viewer
  ViewSettings settings;
  ViewSubject subject;
  CompareState compare;
  bool pools = false;            ///< show where each light's pools lie
  bool probe = false;            ///< tell about the place under the mouse
  int probeSide = 1;             ///< pixels of the square that it looks at
  int selectedLight = 0;         ///< whose colour is shown
  std::set<int> selectedLights;  ///< with it; what is touched on one of them changes on all

  /// Zooms by a factor so that the picture's point under a point of the viewer stays there.
  void zoomAt(const ViewWindow& window, double windowX, double windowY, double factor);
  /// Moves the picture by screen pixels.
  void pan(const ViewWindow& window, double dx, double dy);
  void showFit() { fit = true; }
  void showAt(const ViewWindow& window, double newZoom);

  /// What of a picture is seen in a viewer of this size. Where the picture is smaller it is centred: the
  /// window then begins left of, or above, the picture.
  [[nodiscard]] ViewWindow window(int pictureWidth, int pictureHeight, int width, int height) const;

 private:
  void keep(const ViewWindow& window);
};

[[nodiscard]] Json jsonFromViewState(const ViewState& state);
/// What cannot be read stays at its default: a view is no reason to refuse a session.
[[nodiscard]] ViewState viewStateFromJson(const Json& json);

}  // namespace swaplight
