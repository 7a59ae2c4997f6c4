#include "core/edit/apply/shadow_change.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

using Kind = ShadowOperation::Kind;

constexpr int kExactRadius = 8;  // larger blurs are made of a smaller picture

// A steeper visibility: half light stays half light, the penumbra shrinks to nothing.
float hardened(float visibility) {
  return std::clamp((visibility - .5f) * 20 + .5f, 0.f, 1.f);
}

cv::Mat softened(const cv::Mat& visibility, int radius) {
  const int shrink = std::max(1, radius / kExactRadius);
  cv::Mat small = visibility;
  if (shrink > 1) {
    const cv::Size size((visibility.cols + shrink - 1) / shrink, (visibility.rows + shrink - 1) / shrink);
    cv::resize(visibility, small, size, 0, 0, cv::INTER_AREA);
  }
  cv::Mat soft(small.size(), CV_32F);
  parallelRows(small.rows, 64, [&](int begin, int end) {
    cv::Mat band = soft.rowRange(begin, end);  // sees the rows around it
    cv::GaussianBlur(small.rowRange(begin, end), band, {}, radius / (2. * shrink), 0, cv::BORDER_REPLICATE);
  });
  if (shrink > 1) cv::resize(soft, soft, visibility.size(), 0, 0, cv::INTER_LINEAR);
  return soft;
}

}  // namespace

ShadowChange shadowChange(const ShadowOperation& operation, std::shared_ptr<const LightShadows> shadows) {
  if (operation.kind != Kind::Soften && operation.kind != Kind::Sharpen) return {std::move(shadows), nullptr};
  const Image& visibility = shadows->visibility;
  auto step = std::make_shared<Image>(visibility.spec());
  const cv::Mat in(visibility.height(), visibility.width(), CV_32F, const_cast<float*>(visibility.plane(0)));
  const bool softens = operation.kind == Kind::Soften;
  const cv::Mat soft = softens ? softened(in, operation.radius) : cv::Mat();
  parallelRows(visibility.height(), 64, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto* v = in.ptr<float>(y);
      float* out = step->span().row(0, y);
      for (int x = 0; x < in.cols; ++x) out[x] = (softens ? soft.ptr<float>(y)[x] : hardened(v[x])) - v[x];
    }
  });
  return {std::move(shadows), std::move(step)};
}

bool sameShadowChange(const ShadowOperation& a, const ShadowOperation& b) {
  return a.kind == b.kind && (a.kind != Kind::Soften || a.radius == b.radius);
}

void shadowWeightRow(const ShadowOperation& operation, const ShadowChange& change, int x, int y,
                     const float* mask, int count, float* weight) {
  if (change.step) {
    const float* step = change.step->view().row(0, y) + x;
    for (int i = 0; i < count; ++i) weight[i] = mask[i] * operation.amount * step[i];
  } else {
    const float* visibility = change.shadows->visibility.view().row(0, y) + x;
    for (int i = 0; i < count; ++i) weight[i] = mask[i] * operation.amount * (1 - visibility[i]);
  }
}

void changeShadowRow(const ShadowOperation& operation, int channel, const float* weight, const float* direct,
                     int count, float* t) {
  if (operation.kind == Kind::Deepen) {
    for (int i = 0; i < count; ++i) t[i] *= 1 - weight[i];
    return;
  }
  const float color = operation.kind == Kind::Recolor ? operation.color[channel] : 1;
  for (int i = 0; i < count; ++i) t[i] = std::max(0.f, t[i] + weight[i] * color * direct[i]);
}

int shadowZone(const ShadowOperation& operation, int width) {
  const int rim = std::max(4, width / 96);
  return operation.kind == Kind::Soften ? rim + 2 * operation.radius : rim;
}

}  // namespace swaplight
