#include "core/edit/apply/edit_targets.h"

#include <algorithm>

namespace swaplight {
namespace {

float lookUp(const std::vector<float>& table, float beta) {
  const float position = std::clamp(beta, 0.f, 1.f) * static_cast<float>(table.size() - 1);
  const auto below = std::min(static_cast<size_t>(position), table.size() - 2);
  const float fraction = position - static_cast<float>(below);
  return table[below] + fraction * (table[below + 1] - table[below]);
}

}  // namespace

void targetRow(const PreparedEdit& edit, size_t chosen, int y, int x, const float* beta, const float* blurred,
               int count, float* target) {
  const Operation& operation = edit.edit->operation;
  if (const auto* fill = std::get_if<FillOperation>(&operation)) {
    std::fill_n(target, count, fill->value);
  } else if (const auto* gain = std::get_if<GainOperation>(&operation)) {
    for (int i = 0; i < count; ++i) target[i] = gain->gain * beta[i] + gain->offset;
  } else if (std::holds_alternative<CurveOperation>(operation)) {
    for (int i = 0; i < count; ++i) target[i] = lookUp(edit.curve, beta[i]);
  } else if (std::holds_alternative<InvertOperation>(operation)) {
    for (int i = 0; i < count; ++i) target[i] = 1 - beta[i];
  } else if (std::holds_alternative<BlurOperation>(operation)) {
    std::copy_n(blurred, count, target);
  } else if (const auto* sharpen = std::get_if<SharpenOperation>(&operation)) {
    for (int i = 0; i < count; ++i) target[i] = beta[i] + sharpen->amount * (beta[i] - blurred[i]);
  } else if (std::holds_alternative<PictureOperation>(operation)) {
    std::copy_n(edit.beta->maps[chosen].view().row(0, y) + x, count, target);
  }
  for (int i = 0; i < count; ++i) target[i] = std::max(target[i], 0.f);
}

}  // namespace swaplight
