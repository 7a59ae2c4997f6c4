#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/view/scopes/scope_pictures.h"
#include "ui/camera/look_preview.h"
#include "ui/control/edit_controller.h"
#include "ui/control/light_edit.h"
#include "ui/control/session_controller.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"
#include "ui/pictures/view_table.h"
#include "ui/state/color_choice.h"
#include "ui/state/panel_layout.h"
#include "ui/state/viewer_state.h"

namespace swaplight {

/// Counts the scopes of what is lit now, under its camera look, in a thread; while a gesture goes on, of
/// fewer pixels. Of one light they are before the look, which is of the whole picture.
class ScopesController {
 public:
  /// What it follows, and what it tells. All outlive it.
  struct Parts {
    ChosenLights lights;
    const SessionController& session;
    const EditController& edits;
    const ScopeOptions& options;
    const ViewerState& viewer;
    LookPreview& seen;
    const ColorChoice& colors;
    ViewTable& table;
    Messages& messages;
  };
  ScopesController(const Parts& parts, std::function<void()> wake)
      : m_parts(parts), m_wake(std::move(wake)) {}

  /// To be called in every frame that shows scopes.
  void update();
  /// What was counted last; nullptr before.
  [[nodiscard]] const ScopePictures* pictures() const { return m_pictures ? &*m_pictures : nullptr; }
  /// How bright the display shows their codes.
  [[nodiscard]] const DisplayLuminance& displayLuminance() const { return m_parts.table.displayLuminance(); }
  /// Counts up with every result.
  [[nodiscard]] uint64_t revision() const { return m_revision; }

 private:
  /// What the scopes are of.
  struct Request {
    std::shared_ptr<const ColorConfig> config;
    std::vector<Rgb> factors;
    float ambient = 1;
    PictureRegion region;
    DisplayChoice display;
    int pixels = 0;
    uint64_t set = 0;
    uint64_t edits = 0;
    std::shared_ptr<const SeenPicture> seen;  ///< under the camera look; nothing: without one
    int seenCount = 0;                        ///< another number: `seen` holds another picture
    bool operator==(const Request&) const = default;
  };
  [[nodiscard]] Request wanted(const OpenSet& set) const;
  void addSeen(Request& request, const OpenSet& set) const;
  [[nodiscard]] std::function<ScopePictures()> counting(const Request& request, const OpenSet& set);

  Parts m_parts;
  std::function<void()> m_wake;
  std::optional<Request> m_counted;
  std::optional<ScopePictures> m_pictures;
  uint64_t m_revision = 0;
  Job<ScopePictures> m_job;
};

}  // namespace swaplight
