#include "core/edit/apply/lamp_edit.h"

#include "core/edit/pool/lamp_gain.h"

namespace swaplight {

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
  return edit;
}

void changeLampRow(const LampEdit& edit, int x, int y, int count, const float* mask, const LampRow& row) {
  if (edit.gain) edit.gain->changeRow(x, y, count, mask, row);
}

}  // namespace swaplight
