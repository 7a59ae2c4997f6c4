#pragma once

#include <vector>

#include "core/capture/capture_pixels.h"

namespace swaplight {

/// Whether some photographs, but not all, were taken through crossed polarisers.
[[nodiscard]] bool isPartlyCrossed(const Capture& capture);
/// The capture with its crossed shots only, or with the others only.
[[nodiscard]] Capture shotsOf(const Capture& capture, bool crossed);

/// The photographs of shotsOf(), copied.
[[nodiscard]] CapturePixels copiedShots(const Capture& capture, bool crossed, const CapturePixels& from);

/// The same, as long as this lives: taken from all of them, and put back.
class BorrowedShots {
 public:
  BorrowedShots(const Capture& capture, bool crossed, CapturePixels& from);
  BorrowedShots(const BorrowedShots&) = delete;
  BorrowedShots& operator=(const BorrowedShots&) = delete;
  ~BorrowedShots();

  [[nodiscard]] CapturePixels& pixels() { return m_pixels; }

 private:
  CapturePixels& m_from;
  CapturePixels m_pixels;
  std::vector<size_t> m_places;
};

}  // namespace swaplight
