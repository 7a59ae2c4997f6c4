#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/shadow/detect/shadow_preview.h"
#include "core/shadow/result/connected_shadow.h"
#include "core/shadow/result/untold_pixels.h"
#include "core/view/window_pixels.h"
#include "ui/control/edit_controller.h"
#include "ui/control/light_edit.h"
#include "ui/control/session_controller.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"
#include "ui/state/shadow_state.h"

namespace swaplight {

/// What the page of the shadows shows, made in threads: a preview that follows the hand on the threshold,
/// then what was found exactly (by EditController); the outlines of either; the shadow that was clicked.
class ShadowController {
 public:
  /// What it follows, and what it tells. All outlive it.
  struct Parts {
    ChosenLights lights;
    const SessionController& session;
    EditController& edits;
    ShadowState& state;
    Messages& messages;
  };
  ShadowController(const Parts& parts, std::function<void()> wake)
      : m_parts(parts), m_wake(std::move(wake)) {}

  /// To be called in each frame in which the page is open.
  void show();
  /// nullptr while it is being made.
  [[nodiscard]] const ShadowPreview* preview() const { return m_preview.get(); }
  /// A light's shadows as the viewer draws them.
  struct Shown {
    ShadowOutlines outlines;
    UntoldPixels untold;
  };
  /// Of the light that is shown; nullptr while there is nothing to show.
  [[nodiscard]] const Shown* shown() const;
  /// Chooses the shadow that holds a pixel of the picture, as soon as the shadows are found.
  void choose(int x, int y);
  void chooseAll();
  /// A light's visibility for the viewer; nullptr until it has been found.
  [[nodiscard]] const Pyramid* visibility(int light);
  [[nodiscard]] bool busy() const {
    return m_previewing.running() || m_drawing.running() || m_choosing.running();
  }

 private:
  struct Drawn {
    int light = 0;
    std::optional<float> threshold;
    ShadowMarks marks;
    std::shared_ptr<const LightShadows> exact;  ///< nullptr: of the preview
    Shown shown;
  };
  /// A light's visibility as the viewer needs it.
  struct Seen {
    std::shared_ptr<const LightShadows> shadows;
    std::unique_ptr<Pyramid> pyramid;
  };
  struct Click {
    std::string light;
    int x = 0, y = 0;
  };
  struct Chosen {
    Click click;
    std::shared_ptr<const LightShadows> of;
    std::optional<ConnectedShadow> shadow;
  };

  /// The light that is shown, by its place in the set as solved; -1: it has no shadows.
  [[nodiscard]] int light() const;
  [[nodiscard]] const std::string& nameOf(int light) const {
    return m_set->capture.lights[static_cast<size_t>(light)].name;
  }
  void follow();
  void makePreview();
  void drawOutlines();
  [[nodiscard]] static Shown drawn(const Drawn& wanted, const ShadowPreview* preview);
  void resolveClick();

  Parts m_parts;
  std::function<void()> m_wake;
  std::shared_ptr<const SolvedSet> m_set;
  std::shared_ptr<const ShadowPreview> m_preview;
  bool m_previewFailed = false;
  std::list<Drawn> m_drawn;  ///< the last one at the end
  std::optional<Click> m_click;
  std::shared_ptr<const LightShadows> m_chosenOf;  ///< what the chosen shadow was found in
  std::map<int, Seen> m_seen;                      ///< by light
  Job<std::shared_ptr<const ShadowPreview>> m_previewing;
  Job<Drawn> m_drawing;
  Job<Chosen> m_choosing;
};

}  // namespace swaplight
