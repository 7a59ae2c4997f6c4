#include "core/edit/apply/lamp_edit.h"

#include <vector>

#include "core/base/error.h"
#include "core/edit/pool/lamp_gain.h"
#include "core/edit/pool/penumbra_scales.h"

namespace swaplight {
namespace {

// The light's shadows, and how they look with lamps of other sizes.
void lookUpShadows(LampEdit& edit, const std::string& light, const MaskContext& context,
                   const LampEdit* earlier) {
  if (!context.shadows())
    throw InputError("the size of a lamp changes shadows, which are not available here.");
  edit.shadows = context.shadows()(light);
  edit.penumbras = earlier && earlier->shadows == edit.shadows && earlier->penumbras
                       ? earlier->penumbras
                       : std::make_shared<const PenumbraScales>(edit.shadows->visibility, edit.pool->cone);
}

// How much of the lamp is seen once it has its size. A smaller one gives no pixel less that sees all of it,
// nor more to one that sees nothing, and what cannot be told stays.
void seenThen(const LampEdit& edit, int x, int y, int count, float* then) {
  const LightShadows& shadows = *edit.shadows;
  edit.penumbras->row(edit.size, edit.gain->diameter(), x, y, count, then);
  if (edit.size > 1) return;
  const float* now = shadows.visibility.view().row(0, y) + x;
  const ShadowLabel* label =
      &shadows.labels[static_cast<size_t>(y) * static_cast<size_t>(shadows.visibility.width()) +
                      static_cast<size_t>(x)];
  for (int i = 0; i < count; ++i)
    if (label[i] != ShadowLabel::Penumbra) then[i] = now[i];
}

}  // namespace

LampEdit lampEdit(const LampChange& change, size_t light, const MaskContext& context,
                  const LampEdit* earlier) {
  const SolvedSet& set = context.set();
  if (light >= set.contributions.size()) return {};
  LampEdit edit;
  edit.solved = &set.contributions[light];
  edit.pool =
      earlier && earlier->pool ? earlier->pool : std::make_shared<const LightPool>(measurePool(set, light));
  if (!change.isNeutral())
    edit.gain = std::make_shared<const LampGain>(*edit.pool, change, set.width(), set.height());
  edit.size = change.size;
  if (change.size != 1) {
    lookUpShadows(edit, set.capture.lights[light].name, context, earlier);
  } else if (earlier) {  // a slider that comes by 1 goes on
    edit.shadows = earlier->shadows;
    edit.penumbras = earlier->penumbras;
  }
  return edit;
}

void changeLampRow(const LampEdit& edit, int x, int y, int count, const float* mask, const LampRow& row) {
  if (!edit.gain) return;
  if (edit.size == 1) return edit.gain->changeRow(x, y, count, mask, row);
  std::vector<float> then(static_cast<size_t>(count));
  seenThen(edit, x, y, count, then.data());
  LampRow sized = row;
  sized.seen = edit.shadows->visibility.view().row(0, y) + x;
  sized.seenThen = then.data();
  edit.gain->changeRow(x, y, count, mask, sized);
}

}  // namespace swaplight
