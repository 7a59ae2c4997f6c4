#include "core/edit/apply/shadow_change.h"

#include <algorithm>

#include "core/edit/apply/shadow_silhouette.h"
#include "core/edit/apply/soft_visibility.h"
#include "core/edit/pool/lit_around.h"
#include "core/edit/pool/spot_pool.h"

namespace swaplight {
namespace {

using Kind = ShadowOperation::Kind;

/// A steeper visibility: half light stays half light, the penumbra shrinks to nothing.
Image hardened(const Image& visibility) {
  Image hard(visibility.spec());
  std::transform(visibility.plane(0), visibility.plane(0) + visibility.pixelCount(), hard.plane(0),
                 [](float v) { return std::clamp((v - .5f) * 20 + .5f, 0.f, 1.f); });
  return hard;
}

std::shared_ptr<const Image> stepTo(Image next, const Image& visibility) {
  for (size_t i = 0; i < next.pixelCount(); ++i) next.plane(0)[i] -= visibility.plane(0)[i];
  return std::make_shared<const Image>(std::move(next));
}

/// Where darkness is shadow: inside a spot's cone; of other lights, among what is lit.
std::shared_ptr<const Image> poolOf(const SolvedSet& set, size_t light, const Image& visibility) {
  std::shared_ptr<const Image> spot = spotPool(set, light);
  return spot ? spot : litAround(visibility);
}

std::shared_ptr<const Image> missingWithin(const Image& pool, const Image& visibility) {
  Image missing(visibility.spec());
  std::transform(visibility.plane(0), visibility.plane(0) + visibility.pixelCount(), pool.plane(0),
                 missing.plane(0), [](float v, float within) { return (1 - v) * within; });
  return std::make_shared<const Image>(std::move(missing));
}

}  // namespace

ShadowChange shadowChange(const ShadowOperation& operation, std::shared_ptr<const LightShadows> shadows,
                          const SolvedSet& set, size_t light, bool all, const ShadowChange* earlier) {
  const Image& visibility = shadows->visibility;
  ShadowChange change;
  if (operation.kind == Kind::Soften) {
    change.silhouettes = earlier && earlier->shadows == shadows && earlier->silhouettes
                             ? earlier->silhouettes
                             : std::make_shared<const Image>(shadowSilhouettes(visibility, set, light));
    change.step = stepTo(softVisibility(visibility, *change.silhouettes, operation.radius), visibility);
  } else if (operation.kind == Kind::Sharpen) {
    change.step = stepTo(hardened(visibility), visibility);
  } else if (operation.kind != Kind::Deepen && all) {
    const bool same = earlier && earlier->shadows == shadows && earlier->pool;
    change.pool = same ? earlier->pool : poolOf(set, light, visibility);
    change.step = missingWithin(*change.pool, visibility);
  }
  change.shadows = std::move(shadows);
  return change;
}

bool sameShadowChange(const ShadowOperation& a, const ShadowOperation& b) {
  return a.kind == b.kind && (a.kind != Kind::Soften || a.radius == b.radius);
}

void shadowWeightRow(const ShadowOperation& operation, const ShadowChange& change, int x, int y,
                     const float* mask, int count, float* weight) {
  if (change.step) {
    const float* step = change.step->view().row(0, y) + x;
    for (int i = 0; i < count; ++i) weight[i] = mask[i] * operation.amount * step[i];
  } else {
    const float* visibility = change.shadows->visibility.view().row(0, y) + x;
    for (int i = 0; i < count; ++i) weight[i] = mask[i] * operation.amount * (1 - visibility[i]);
  }
}

void changeShadowRow(const ShadowOperation& operation, int channel, const float* weight, const float* direct,
                     int count, float* t) {
  if (operation.kind == Kind::Deepen) {
    for (int i = 0; i < count; ++i) t[i] *= 1 - weight[i];
    return;
  }
  const float color = operation.kind == Kind::Recolor ? operation.color[channel] : 1;
  for (int i = 0; i < count; ++i) t[i] = std::max(0.f, t[i] + weight[i] * color * direct[i]);
}

int shadowZone(const ShadowOperation& operation, int width) {
  const int rim = std::max(4, width / 96);
  return operation.kind == Kind::Soften ? rim + 2 * operation.radius : rim;
}

}  // namespace swaplight
