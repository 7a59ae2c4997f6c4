#pragma once

#include <memory>
#include <vector>

#include "core/edit/mask/mask.h"
#include "core/normals/set_surfaces.h"
#include "core/set/solved_set.h"
#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// What masks are drawn on and edits look at: the set as solved, its shadows, how its surfaces are turned. A
/// shape is drawn once as long as somebody holds it. Not for use by several threads at once.
class MaskContext {
 public:
  /// The set must outlive it.
  explicit MaskContext(const SolvedSet& set, ShadowSource shadows = {}, SurfaceSource surfaces = {});

  [[nodiscard]] int width() const { return m_set.width(); }
  [[nodiscard]] int height() const { return m_set.height(); }
  [[nodiscard]] const SolvedSet& set() const { return m_set; }
  [[nodiscard]] const ShadowSource& shadows() const { return m_shadows; }
  [[nodiscard]] const SurfaceSource& surfaces() const { return m_surfaces; }

  /// A shape as pixels, before it is inverted; nullptr for shapes that are formulas (rectangles, ellipses,
  /// gradients, patterns). Throws InputError: a picture that cannot be read, a light without shadows, a place
  /// outside the picture.
  /// `shadowZone`: edits of shadows are measured by the visibility themselves: for them a shadow that was
  /// chosen counts in whole, with so many pixels around it.
  std::shared_ptr<const MaskRaster> raster(const MaskShape& shape, int shadowZone = 0);
  /// The same where it has been drawn already and somebody holds it; else nullptr.
  [[nodiscard]] std::shared_ptr<const MaskRaster> known(const MaskShape& shape, int shadowZone = 0);
  /// A shape that was drawn elsewhere, on the same set and shadows.
  void keep(const MaskShape& shape, const std::shared_ptr<const MaskRaster>& raster);
  /// To be called when the shadows are others.
  void forgetDrawn() { m_drawn.clear(); }

 private:
  struct Drawn {
    MaskShape shape;
    int shadowZone = 0;
    std::weak_ptr<const MaskRaster> raster;
  };
  /// Whether a painting's own mask is the one on this set: it follows no edges, or this set's.
  [[nodiscard]] bool isPainted(const Painting& painting) const;
  std::shared_ptr<const MaskRaster> draw(const MaskShape& shape, int shadowZone);

  const SolvedSet& m_set;
  ShadowSource m_shadows;
  SurfaceSource m_surfaces;
  std::vector<Drawn> m_drawn;
  std::shared_ptr<const EdgeGuide> m_guide;  ///< of the set; nullptr: not needed yet
};

}  // namespace swaplight
