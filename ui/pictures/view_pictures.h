#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/image/pixel_rect.h"
#include "core/set/solved_set.h"
#include "core/view/view_subject.h"
#include "core/view/window_pixels.h"

namespace swaplight {

/// A set's pictures at every size at which they are shown.
class ViewPictures {
 public:
  explicit ViewPictures(std::shared_ptr<const SolvedSet> set);

  [[nodiscard]] int width() const { return m_set->width(); }
  [[nodiscard]] int height() const { return m_set->height(); }

  /// To be called when pixels of these lights have changed, of all lights: those of the ambient light, too.
  /// Returns the pictures that show them.
  std::vector<const Pyramid*> refresh(const std::vector<PixelRect>& changed, const std::set<int>& lights);
  /// To be called when the set has other lights: pictures that lie where they lay are kept.
  void lightsChanged();
  [[nodiscard]] const std::vector<Pyramid>& contributions() const { return m_contributions; }
  /// nullptr where there is none.
  [[nodiscard]] const Pyramid* ambient() const { return m_ambient ? &*m_ambient : nullptr; }

  /// What has to be added up to show a subject; `factors` are the rig's; a light that it lacks
  /// is dark.
  [[nodiscard]] std::vector<ViewLayer> layers(const ViewSubject& subject, std::span<const Rgb> factors,
                                              float ambientFactor) const;

 private:
  std::shared_ptr<const SolvedSet> m_set;
  std::vector<Pyramid> m_contributions;
  std::optional<Pyramid> m_ambient;
};

}  // namespace swaplight
