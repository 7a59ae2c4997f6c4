#pragma once

#include <memory>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// Identifies a picture for caches. An address would not: another picture may be created there later. Expires
/// with the picture.
using PictureIdentity = std::weak_ptr<const void>;

[[nodiscard]] inline bool isSamePicture(const PictureIdentity& a, const PictureIdentity& b) {
  return !a.owner_before(b) && !b.owner_before(a);
}

/// A picture and its halves: level 0 is the picture, level n + 1 is level n with every 2 x 2 pixels averaged
/// (a last odd row or column averages what there is). So that a small view of a large picture reads few
/// pixels and does not flicker.
class Pyramid {
 public:
  /// The picture must outlive the pyramid. Builds every level down to a side of 64.
  explicit Pyramid(ImageView picture);
  Pyramid(const Pyramid&) = delete;
  Pyramid& operator=(const Pyramid&) = delete;
  Pyramid(Pyramid&&) = default;
  Pyramid& operator=(Pyramid&&) = default;
  ~Pyramid() = default;

  /// To be called when pixels of the picture have changed: makes the halves of that rectangle again.
  void refresh(int x, int y, int width, int height);

  [[nodiscard]] int levels() const { return static_cast<int>(m_halves.size()) + 1; }
  [[nodiscard]] ImageView level(int index) const {
    return index == 0 ? m_picture : m_halves[static_cast<size_t>(index) - 1].view();
  }
  [[nodiscard]] int width() const { return m_picture.width; }
  [[nodiscard]] int height() const { return m_picture.height; }
  /// The same after the pyramid was moved.
  [[nodiscard]] PictureIdentity identity() const { return m_identity; }

 private:
  ImageView m_picture;
  std::vector<Image> m_halves;
  std::shared_ptr<const void> m_identity = std::make_shared<char>();
};

/// Every 2 x 2 pixels averaged.
[[nodiscard]] Image halveImage(ImageView image);

}  // namespace swaplight
