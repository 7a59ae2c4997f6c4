#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

#include "core/base/check.h"
#include "core/simd/padding.h"

namespace swaplight {

/// Room for planes of `count` floats each, handed out one after the other. Each begins at a cache line and
/// has room for whole lanes; what lies in them is not set.
class PlaneArena {
 public:
  PlaneArena(size_t count, size_t planes)
      : m_padded(roundedUpToLanes(count)),
        m_data(new (std::align_val_t(kLine)) float[m_padded * planes]),
        m_next(m_data.get()),
        m_left(planes) {}

  /// The next plane, of those that are left.
  float* take() {
    SWAPLIGHT_CHECK_LT(size_t{0}, m_left);
    --m_left;
    return std::exchange(m_next, m_next + m_padded);
  }
  /// The next plane, every value set, those beyond `count` as well.
  float* take(float value) {
    float* plane = take();
    std::fill_n(plane, m_padded, value);
    return plane;
  }

  /// Floats from a plane to the next: `count`, rounded up to whole lanes.
  [[nodiscard]] size_t padded() const { return m_padded; }

 private:
  static constexpr size_t kLine = 64;
  struct Free {
    void operator()(float* p) const { operator delete[](p, std::align_val_t(kLine)); }
  };
  size_t m_padded;
  std::unique_ptr<float[], Free> m_data;
  float* m_next;
  size_t m_left;
};

}  // namespace swaplight
