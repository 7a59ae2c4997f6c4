#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/normals/surface_normals.h"

namespace swaplight {

/// How the surfaces of a set are turned and what they reflect, everywhere: what light from another place
/// needs to know. Where a normal was refused, it is continued from those around, as far as the next edge of
/// the picture, and the reflectance is the set at unit white over the light around: a guess.
struct SetSurfaces {
  Image normals;                       ///< X to the right, Y up, Z towards the camera, of length 1
  Image reflectance;                   ///< R, G, B: what a surface that faces a lamp of level 1 shows
  std::vector<unsigned char> guessed;  ///< a pixel each: 1 where the normal was refused
  double guessedShare = 0;             ///< of the pixels, 0..1
  std::vector<LeveledLight> lamps;     ///< those whose places were told
  double level = 1;                    ///< of the strongest of them

  /// Of one of the set's lights; nullptr: nobody has told where its lamp stood, or it lights nothing.
  [[nodiscard]] const LeveledLight* lampOf(size_t light) const;
};

/// Finds them when they are asked for; may take long the first time. Throws InputError where they cannot be
/// told, and says why.
using SurfaceSource = std::function<std::shared_ptr<const SetSurfaces>()>;

/// `found`: of the set. Without a single normal the surfaces face the camera, and all is a guess.
[[nodiscard]] SetSurfaces setSurfaces(const SolvedSet& set, const SurfaceNormals& found);

/// Finds them on first demand and keeps them, for edits that use them. `places`: of the lamps of three lights
/// or more; throws as placedLights does.
[[nodiscard]] SurfaceSource surfaceSource(std::shared_ptr<const SolvedSet> set, ShadowSource shadows,
                                          LampPlaces places);

}  // namespace swaplight
