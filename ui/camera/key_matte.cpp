#include "ui/camera/key_matte.h"

#include <algorithm>

namespace swaplight {
namespace {

/// A parameter's value; nothing where the filter has none of this name and type.
template <typename T>
std::optional<T> valueNamed(const ResolvedStage& stage, const char* name) {
  for (size_t i = 0; i < stage.values.size(); ++i)
    if (const T* value = std::get_if<T>(&stage.values[i]); value && stage.filter->inputs[i].name == name)
      return *value;
  return std::nullopt;
}

}  // namespace

std::optional<MaskShape> keyMatteOf(const ResolvedStage& stage, const Rig& rig,
                                    const std::vector<Rgb>& factors) {
  KeyShape key;
  MaskShape matte;
  const auto color = valueNamed<FilterColor>(stage, "key");
  const auto inner = valueNamed<float>(stage, "inner"), outer = valueNamed<float>(stage, "outer");
  const auto low = valueNamed<float>(stage, "low"), high = valueNamed<float>(stage, "high");
  const auto invert = valueNamed<bool>(stage, "invert");
  if (color && inner && outer) {
    for (int c = 0; c < 3; ++c) key.color[c] = std::clamp((*color)[static_cast<size_t>(c)], 0.0F, 1.0F);
    key.from = *inner;
    key.to = *outer;
  } else if (low && high && invert) {
    key.by = KeyShape::By::Luma;
    key.from = *low;
    key.to = *high;
    matte.invert = *invert;
  } else {
    return std::nullopt;
  }
  if (!valueNamed<bool>(stage, "underWhite").value_or(false)) {
    for (size_t i = 0; i < std::min(rig.lights.size(), factors.size()); ++i)
      key.lights[rig.lights[i].light] = factors[i];
    key.ambient = rig.ambient;
  }
  matte.shape = std::move(key);
  return matte;
}

}  // namespace swaplight
