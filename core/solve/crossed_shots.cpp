#include "core/solve/crossed_shots.h"

#include <algorithm>
#include <utility>

namespace swaplight {

bool isPartlyCrossed(const Capture& capture) {
  const auto crossed = [](const Shot& shot) { return shot.crossed; };
  return std::any_of(capture.shots.begin(), capture.shots.end(), crossed) &&
         !std::all_of(capture.shots.begin(), capture.shots.end(), crossed);
}

Capture shotsOf(const Capture& capture, bool crossed) {
  Capture some = capture;
  std::erase_if(some.shots, [crossed](const Shot& shot) { return shot.crossed != crossed; });
  return some;
}

BorrowedShots::BorrowedShots(const Capture& capture, bool crossed, CapturePixels& from)
    : m_from(from), m_pixels(withoutShots(from)) {
  m_pixels.clipLevel.clear();
  m_pixels.quantum.clear();
  for (size_t k = 0; k < capture.shots.size(); ++k) {
    if (capture.shots[k].crossed != crossed) continue;
    m_places.push_back(k);
    m_pixels.shots.push_back(std::move(from.shots[k]));
    m_pixels.clipLevel.push_back(from.clipLevel[k]);
    m_pixels.quantum.push_back(from.quantum[k]);
  }
}

BorrowedShots::~BorrowedShots() {
  for (size_t j = 0; j < m_places.size(); ++j) m_from.shots[m_places[j]] = std::move(m_pixels.shots[j]);
}

}  // namespace swaplight
