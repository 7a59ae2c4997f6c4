#pragma once

#include <memory>

#include "core/edit/mask/mask_context.h"
#include "core/edit/pool/lamp_change.h"
#include "core/shadow/result/light_shadows.h"

namespace swaplight {

class LampGain;
struct LampRow;
struct LightPool;
class PenumbraScales;

/// What an edit of a light's lamp looks up of the light: its pool as it was solved, and what the change makes
/// of it. A neutral change has no gain; of a light that the edits add nothing is known: it stays as it is.
struct LampEdit {
  std::shared_ptr<const LightPool> pool;
  std::shared_ptr<const LampGain> gain;
  const Image* solved = nullptr;  ///< the contribution; of the context's set
  /// Where the lamp's size changes, or did.
  std::shared_ptr<const LightShadows> shadows;
  std::shared_ptr<const PenumbraScales> penumbras;
  float size = 1;
};

/// `light` is an index of the set's lights or, beyond, of those that edits add. `earlier`: what was looked up
/// before for the same light and set, or nullptr.
[[nodiscard]] LampEdit lampEdit(const LampChange& change, size_t light, const MaskContext& context,
                                const LampEdit* earlier = nullptr);

/// What a row of the light becomes. `mask`: times the edit's opacity, 0..1.
void changeLampRow(const LampEdit& edit, int x, int y, int count, const float* mask, const LampRow& row);

}  // namespace swaplight
