#pragma once

#include <memory>

#include "core/edit/stack/edit.h"
#include "core/set/solved_set.h"
#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// What a shadow operation looks up of a light: its shadows, and where the visibility itself changes by how
/// much. Of the operation it knows the kind and the radius; amount and colour are free to change.
struct ShadowChange {
  std::shared_ptr<const LightShadows> shadows;
  std::shared_ptr<const Image> step;         ///< one channel, -1..1: to the new visibility; nullptr: to 1
  std::shared_ptr<const Image> silhouettes;  ///< where softening ends (shadow_silhouette.h); else nullptr
  /// Where darkness is shadow to be filled (spot_pool.h, lit_around.h); nullptr: wherever it is, or not used.
  std::shared_ptr<const Image> pool;
};

/// Of light number `light` of the set. `all`: no mask says where, so that what lies outside a spot's cone, or
/// beyond all that another light reaches, is no shadow to be filled. `earlier`, if there is one, is what an
/// operation looked up of it before: what has not changed is taken from it.
[[nodiscard]] ShadowChange shadowChange(const ShadowOperation& operation,
                                        std::shared_ptr<const LightShadows> shadows, const SolvedSet& set,
                                        size_t light, bool all, const ShadowChange* earlier = nullptr);

/// Whether changes made for one operation serve another.
[[nodiscard]] bool sameShadowChange(const ShadowOperation& a, const ShadowOperation& b);

/// What an operation does to the contribution t of a light, in a row of one channel: t + weight * color *
/// direct, at least 0; deepening: t * (1 - weight). `weight` is mask * amount * step.
void changeShadowRow(const ShadowOperation& operation, int channel, const float* weight, const float* direct,
                     int count, float* t);

/// weight[0..count) = mask * amount * step in pixels x.. of row y.
void shadowWeightRow(const ShadowOperation& operation, const ShadowChange& change, int x, int y,
                     const float* mask, int count, float* weight);

/// How far beyond a shadow's outline the operation changes something: its faint rim, and what softening makes
/// of it. Pixels.
[[nodiscard]] int shadowZone(const ShadowOperation& operation, int width);

}  // namespace swaplight
