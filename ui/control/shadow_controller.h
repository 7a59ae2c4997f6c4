#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/shadow/detect/shadow_preview.h"
#include "core/shadow/result/connected_shadow.h"
#include "core/view/window_pixels.h"
#include "ui/jobs/job.h"

namespace swaplight {

struct StudioContext;

/// What the page of the shadows shows, made in threads: a preview that follows the hand on the threshold,
/// then what was found exactly (by EditController); the outlines of either; the shadow that was clicked.
class ShadowController {
 public:
  explicit ShadowController(std::function<void()> wake) : m_wake(std::move(wake)) {}

  /// To be called in each frame in which the page is open.
  void show(StudioContext& studio);
  /// nullptr while it is being made.
  [[nodiscard]] const ShadowPreview* preview() const { return m_preview.get(); }
  /// Of the light that is shown; nullptr while there are none to show.
  [[nodiscard]] const ShadowOutlines* outlines(const StudioContext& studio) const;
  /// Chooses the shadow that holds a pixel of the picture, as soon as the shadows are found.
  void choose(StudioContext& studio, int x, int y);
  void chooseAll(StudioContext& studio);
  /// A light's visibility for the viewer; nullptr until it has been found.
  [[nodiscard]] const Pyramid* visibility(StudioContext& studio, int light);
  [[nodiscard]] bool busy() const {
    return m_previewing.running() || m_drawing.running() || m_choosing.running();
  }

 private:
  struct Drawn {
    int light = 0;
    std::optional<float> threshold;
    std::shared_ptr<const LightShadows> exact;  ///< nullptr: of the preview
    ShadowOutlines outlines;
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

  void follow(StudioContext& studio);
  void makePreview(StudioContext& studio);
  void drawOutlines(StudioContext& studio);
  void resolveClick(StudioContext& studio);

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
