#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace swaplight {

/// What an image is: its size, its channels by name, and the colour space of its R, G, B.
struct ImageSpec {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  std::string colorSpace = "lin_rec709";

  [[nodiscard]] int channelCount() const { return static_cast<int>(channels.size()); }
  [[nodiscard]] size_t pixelCount() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
  bool operator==(const ImageSpec&) const = default;

  /// width x height with the channels R, G, B.
  static ImageSpec rgb(int width, int height);
};

/// Somebody else's pixels: a pointer, sizes and strides (in elements). Planes, one after the other: a
/// channel's rows lie apart by rowStride, the channels by planeStride.
template <typename T>
struct BasicImageView {
  T* data = nullptr;
  int width = 0;
  int height = 0;
  int channels = 0;
  ptrdiff_t rowStride = 0;
  ptrdiff_t planeStride = 0;

  [[nodiscard]] T* row(int channel, int y) const { return data + channel * planeStride + y * rowStride; }
  [[nodiscard]] T& at(int channel, int x, int y) const { return row(channel, y)[x]; }
  [[nodiscard]] BasicImageView crop(int x, int y, int w, int h) const {
    return {data + y * rowStride + x, w, h, channels, rowStride, planeStride};
  }
  [[nodiscard]] BasicImageView channelRange(int first, int count) const {
    return {data + first * planeStride, width, height, count, rowStride, planeStride};
  }
  operator BasicImageView<const T>() const {  // NOLINT(google-explicit-constructor)
    return {data, width, height, channels, rowStride, planeStride};
  }
};

using ImageView = BasicImageView<const float>;
using ImageSpan = BasicImageView<float>;

/// An image that owns its pixels: float32, channel planes, every plane aligned to 64 bytes and without gaps
/// between its rows. Moves; copies only by clone().
class Image {
 public:
  Image() = default;
  /// Pixels are not initialised. Throws InputError on a negative size, std::bad_alloc when memory is short.
  explicit Image(ImageSpec spec);
  Image(ImageSpec spec, float value);

  [[nodiscard]] Image clone() const;
  [[nodiscard]] bool empty() const { return m_spec.pixelCount() == 0 || m_spec.channels.empty(); }

  [[nodiscard]] const ImageSpec& spec() const { return m_spec; }
  [[nodiscard]] int width() const { return m_spec.width; }
  [[nodiscard]] int height() const { return m_spec.height; }
  [[nodiscard]] int channelCount() const { return m_spec.channelCount(); }
  [[nodiscard]] size_t pixelCount() const { return m_spec.pixelCount(); }
  void setColorSpace(std::string name) { m_spec.colorSpace = std::move(name); }
  void setChannelNames(std::vector<std::string> names) { m_spec.channels = std::move(names); }

  /// A channel's pixels, row after row.
  [[nodiscard]] float* plane(int channel) { return m_data.get() + channel * m_planeStride; }
  [[nodiscard]] const float* plane(int channel) const { return m_data.get() + channel * m_planeStride; }
  /// The index of a channel by name, or -1.
  [[nodiscard]] int channelIndex(const std::string& name) const;

  [[nodiscard]] ImageSpan span();
  [[nodiscard]] ImageView view() const;

 private:
  struct Free {
    void operator()(float* p) const;
  };
  ImageSpec m_spec;
  ptrdiff_t m_planeStride = 0;
  std::unique_ptr<float[], Free> m_data;
};

}  // namespace swaplight
