#include "core/edit/shadow_change.h"

#include <opencv2/imgproc.hpp>

#include "core/error.h"

namespace swaplight {
namespace {

// A steeper visibility: half light stays half light, the penumbra shrinks to nothing as `amount` grows.
float hardened(float visibility) {
  const float t = std::clamp((visibility - .5f) * 20 + .5f, 0.f, 1.f);
  return t;
}

}  // namespace

ShadowChange shadowChange(const ShadowOperation& operation, std::shared_ptr<const LightShadows> shadows) {
  using Kind = ShadowOperation::Kind;
  const Image& visibility = shadows->visibility;
  auto weight = std::make_shared<Image>(visibility.spec());
  const auto* v = visibility.plane(0);
  float* w = weight->plane(0);
  const size_t count = visibility.pixelCount();

  ShadowChange change{std::move(shadows), nullptr, Rgb(1), operation.kind == Kind::Deepen};
  switch (operation.kind) {
    case Kind::Recolor:
      change.color = operation.color;
      [[fallthrough]];
    case Kind::Lighten:
      for (size_t p = 0; p < count; ++p) w[p] = operation.amount * (1 - v[p]);
      break;
    case Kind::Deepen:
      for (size_t p = 0; p < count; ++p) w[p] = -operation.amount * (1 - v[p]);
      break;
    case Kind::Sharpen:
      for (size_t p = 0; p < count; ++p) w[p] = operation.amount * (hardened(v[p]) - v[p]);
      break;
    case Kind::Soften: {
      const cv::Mat in(visibility.height(), visibility.width(), CV_32F, const_cast<float*>(v));
      cv::Mat soft;
      cv::GaussianBlur(in, soft, {}, operation.radius / 2., 0, cv::BORDER_REPLICATE);
      for (size_t p = 0; p < count; ++p) w[p] = operation.amount * (soft.ptr<float>()[p] - v[p]);
      break;
    }
  }
  change.weight = std::move(weight);
  return change;
}

}  // namespace swaplight
