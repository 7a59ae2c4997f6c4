#include "core/image/image.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/image/images_in_files.h"

namespace swaplight {
namespace {

constexpr size_t kAlignFloats = 16;  // 64 bytes: one cache line, one AVX-512 register

}  // namespace

ImageSpec ImageSpec::rgb(int width, int height) {
  return {width, height, {"R", "G", "B"}, "lin_rec709"};
}

void Image::Free::operator()(float* p) const {
  freeImage(p);
}

Image::Image(ImageSpec spec) : m_spec(std::move(spec)) {
  if (m_spec.width < 0 || m_spec.height < 0)
    throw InputError("an image cannot be {} x {} pixels", m_spec.width, m_spec.height);
  const size_t stride = (m_spec.pixelCount() + kAlignFloats - 1) / kAlignFloats * kAlignFloats;
  m_planeStride = static_cast<ptrdiff_t>(stride);
  const size_t floats = stride * m_spec.channels.size();
  if (floats > 0) m_data.reset(allocateImage(floats));
}

Image::Image(ImageSpec spec, float value) : Image(std::move(spec)) {
  for (int c = 0; c < channelCount(); ++c) std::fill_n(plane(c), pixelCount(), value);
}

Image Image::clone() const {
  Image copy(m_spec);
  for (int c = 0; c < channelCount(); ++c) std::copy_n(plane(c), pixelCount(), copy.plane(c));
  return copy;
}

int Image::channelIndex(const std::string& name) const {
  const auto found = std::find(m_spec.channels.begin(), m_spec.channels.end(), name);
  return found == m_spec.channels.end() ? -1 : static_cast<int>(found - m_spec.channels.begin());
}

ImageSpan Image::span() {
  return {m_data.get(), width(), height(), channelCount(), width(), m_planeStride};
}

ImageView Image::view() const {
  return {m_data.get(), width(), height(), channelCount(), width(), m_planeStride};
}

}  // namespace swaplight
