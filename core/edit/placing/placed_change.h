#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "core/edit/mask/mask_context.h"
#include "core/edit/operations/place_operation.h"
#include "core/edit/placing/placed_lamp.h"
#include "core/normals/set_surfaces.h"

namespace swaplight {

/// Why a light cannot be placed, in words; nothing where it can. `told`: where the lamps of the set's lights
/// stood: of three or more, the light's own among them unless the edits have added it.
[[nodiscard]] std::optional<std::string> whyNotPlaced(const std::string& light, const LampPlaces& told,
                                                      const Capture& capture);

/// The same of surfaces that were found: where most of them are a guess nothing can be placed.
[[nodiscard]] std::optional<std::string> whyNotPlaced(const SetSurfaces& surfaces);

/// A row of pixels of one light, R G B apart; all start at the same pixel.
struct PlacedRow {
  std::array<float*, 3> light;           ///< its contribution: changed
  std::array<const float*, 3> paint;     ///< what the surfaces reflect
  std::array<const float*, 3> solved{};  ///< the light as solved, on these surfaces; of a new one none
};

/// What the light of a lamp becomes that stands elsewhere. With s the shade (placed_lamp.h) before and s'
/// after, r the reflectance, L the lamp's level:
///
///   T' = T + v r L (s' - s)         where it gets brighter
///   T' = T (1 + v (s'/s - 1))       where it gets darker: none is left over, and all of the detail stays
///
/// v is how much of the lamp is seen: as the search for shadows says, at least T / r L s, and all of it where
/// s was small, since then the surface was turned away from the lamp. A light that the edits add, and so has
/// no T, gets r L s', L that of the strongest lamp. No shadow is thrown from the new place; those that were
/// thrown stay. Where earlier edits have left only a part of the light, it is a lamp of so much less. A lamp
/// that comes nearer keeps its power: its level goes with the inverse square of its
/// distance.
///
/// Woodham 1980 backwards; the surfaces: core/normals/set_surfaces.h.
class PlacedChange {
 public:
  /// `light`: an index of the set's lights or, beyond, of those that edits add. Throws InputError: surfaces
  /// cannot be told, or on too little of the picture, or nobody has said where this light's lamp stood.
  PlacedChange(const PlaceOperation& operation, const std::string& name, size_t light,
               const MaskContext& context, const LampPlaces& told);

  /// Nothing changes: the lamp stands where it stood.
  [[nodiscard]] bool isNeutral() const { return m_neutral; }
  /// Changes a row by `mask` (0..1) times what the change asks for.
  void changeRow(int x, int y, int count, const float* mask, const PlacedRow& row) const;
  [[nodiscard]] const SetSurfaces& surfaces() const { return *m_surfaces; }
  /// Whether the pixel's surface is a guess.
  [[nodiscard]] bool guessAt(int x, int y) const;

 private:
  std::shared_ptr<const SetSurfaces> m_surfaces;
  std::shared_ptr<const LightShadows> m_shadows;  ///< of a light that was photographed
  std::optional<PlacedLamp> m_before;             ///< nothing: a light that edits add
  PlacedLamp m_after;
  float m_level = 1;   ///< of the lamp, which reflectances are times
  float m_nearer = 1;  ///< times the level, where the lamp comes nearer
  bool m_neutral = false;
};

}  // namespace swaplight
