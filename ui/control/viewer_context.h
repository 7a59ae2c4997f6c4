#pragma once

#include "render/viewport_renderer.h"
#include "ui/camera/look_preview.h"
#include "ui/camera/look_shelf.h"
#include "ui/camera/look_thumbnails.h"
#include "ui/control/editing_context.h"
#include "ui/control/subject_pictures.h"
#include "ui/pictures/view_table.h"
#include "ui/state/camera_look_state.h"
#include "ui/state/viewer_state.h"

namespace swaplight {

/// What the viewer reads and changes: what is edited in it, and what it shows.
struct ViewerContext : EditingContext {
  ViewerState& viewer;
  ShownPicture& drawn;  ///< the same as `shown`: the viewer says what it has drawn
  ViewportRenderer& renderer;
  SubjectPictures& subjects;
  ViewTable& table;
  LookPreview& seen;  ///< the picture under the camera look
  LookThumbnails& thumbnails;
  CameraLookState& cameraLook;
  LookShelf& shelf;
};

}  // namespace swaplight
