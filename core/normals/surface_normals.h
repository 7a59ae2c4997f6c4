#pragma once

#include <cstddef>
#include <vector>

#include "core/base/progress.h"
#include "core/normals/lamp_place.h"
#include "core/set/solved_set.h"
#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// Why a pixel has no normal; each pixel counts once.
struct RefusedPixels {
  size_t flagged = 0;    ///< its light was not measured: clipped, moved, filled in
  size_t fewLamps = 0;   ///< fewer than three lamps light it
  size_t alike = 0;      ///< they light it from directions too much alike
  size_t disagreed = 0;  ///< four or more do, and contradict each other
  size_t away = 0;       ///< it would be turned away from the camera
  [[nodiscard]] size_t count() const { return flagged + fewLamps + alike + disagreed + away; }
};

/// A light of the set, by its index, and where its lamp stood.
struct PlacedLight {
  size_t light = 0;
  LampPlace place;
};

/// The same after refinement, with its level: what the middle of the set would show of a surface of
/// reflectance 1 that faces it.
struct LeveledLight {
  size_t light = 0;
  LampPlace place;
  double level = 1;
};

struct SurfaceNormals {
  /// normal.X to the right, .Y up, .Z towards the camera, of length 1; 0 where refused.
  Image normals;
  /// R, G, B: what a surface that faces a lamp of level 1 shows; 0 where refused. Levels that were not
  /// metered are those of bright pixels: then white is about 1.
  Image reflectance;
  std::vector<LeveledLight> lamps;  ///< those that light anything
  RefusedPixels refused;
  size_t checked = 0;  ///< pixels with a normal that was fitted to four lamps or more
  /// Pixels on which lamps contradict the others that are in shadow there, though none was found: left out.
  size_t shadowed = 0;

  /// Lamps disagree so often that a place is likely to be told wrong: then the others may agree by chance.
  /// A quarter: chosen by judgement, not measured.
  [[nodiscard]] bool isContradictory() const {
    return (refused.disagreed + shadowed) * 4 > refused.disagreed + checked;
  }
};

/// How the surfaces of a set are turned, by photometric stereo.
///
/// A matte surface of reflectance r and normal n shows T_i = r s_i f_i(x) (n . l_i(x)) of lamp i, where s_i
/// is the lamp's level, l_i the direction to it and f_i its falloff (lamp_place.h). Three lamps or more that
/// shine there give r n (normal_fit.h); where more disagree, those are left out that give least and so much
/// less than the surface would show that they must be in a shadow that was not found. T is the mean of the
/// channels of a contribution; a lamp shines where `shadows` calls it lit. Light that bounces around is not
/// modelled: it bends normals towards where it comes from.
///
/// Levels: those that were metered, if all have `stops`. Otherwise each light is held against its own bright
/// pixels, as if some bright surface faced each lamp. Where four lamps or more shine, their directions and
/// levels are refined (lamp_refinement.h). What remains open, the bas-relief ambiguity among it (Belhumeur,
/// Kriegman and Yuille 1999), is as right as what was said. (A search for levels by the normals' curl,
/// almost free of them, drew them away in a prototype; with a firm prior it was not tried.)
///
/// Throws Stopped.
[[nodiscard]] SurfaceNormals surfaceNormals(const SolvedSet& set, const ShadowSource& shadows,
                                            const std::vector<PlacedLight>& lamps,
                                            const Progress& progress = {});

}  // namespace swaplight
