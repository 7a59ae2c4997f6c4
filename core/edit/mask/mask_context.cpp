#include "core/edit/mask/mask_context.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/edit/guide/edge_guide.h"
#include "core/edit/mask/selection_drawing.h"

namespace swaplight {

MaskContext::MaskContext(const SolvedSet& set, ShadowSource shadows, SurfaceSource surfaces)
    : m_set(set), m_shadows(std::move(shadows)), m_surfaces(std::move(surfaces)) {}

std::shared_ptr<const MaskRaster> MaskContext::raster(const MaskShape& shape, int shadowZone) {
  if (const auto* paint = std::get_if<PaintShape>(&shape.shape); paint && isPainted(*paint->painting))
    return {paint->painting, &paint->painting->mask()};
  if (!std::holds_alternative<ShadowShape>(shape.shape)) shadowZone = 0;
  if (auto raster = known(shape, shadowZone)) return raster;
  auto raster = draw(shape, shadowZone);
  if (raster) m_drawn.push_back({shape, shadowZone, raster});
  return raster;
}

bool MaskContext::isPainted(const Painting& painting) const {
  return !painting.followsEdges() || (painting.guide() && painting.guide()->isOf(m_set));
}

std::shared_ptr<const MaskRaster> MaskContext::known(const MaskShape& shape, int shadowZone) {
  std::erase_if(m_drawn, [](const Drawn& drawn) { return drawn.raster.expired(); });
  const auto found = std::find_if(m_drawn.begin(), m_drawn.end(), [&](const Drawn& drawn) {
    return drawn.shadowZone == shadowZone && drawn.shape.shape == shape.shape;
  });
  return found == m_drawn.end() ? nullptr : found->raster.lock();
}

void MaskContext::keep(const MaskShape& shape, const std::shared_ptr<const MaskRaster>& raster) {
  if (!known(shape)) m_drawn.push_back({shape, 0, raster});
}

std::shared_ptr<const MaskRaster> MaskContext::draw(const MaskShape& shape, int shadowZone) {
  const auto made = [](MaskRaster raster) { return std::make_shared<const MaskRaster>(std::move(raster)); };
  return std::visit(
      [&]<typename T>(const T& s) -> std::shared_ptr<const MaskRaster> {
        if constexpr (std::is_same_v<T, ShadowShape>) {
          if (!m_shadows) throw InputError("the edits use shadows, which are not available here.");
          const auto found = m_shadows(s.light);
          return made(shadowZone > 0 && s.region ? s.drawZone(*found, shadowZone) : s.draw(*found));
        } else if constexpr (requires { s.draw(m_set); }) {
          return made(s.draw(m_set));
        } else if constexpr (std::is_same_v<T, SelectionShape>) {
          return made(drawSelection(s, *this));
        } else if constexpr (std::is_same_v<T, PaintShape>) {
          if (!m_guide) m_guide = std::make_shared<const EdgeGuide>(m_set);
          return made(s.painting->guidedBy(m_guide).mask());
        } else if constexpr (requires { s.valueAt(0.F, 0.F); }) {
          return nullptr;
        } else {
          return made(s.draw(width(), height()));
        }
      },
      shape.shape);
}

}  // namespace swaplight
