#include "core/solve/model/crossed_shots.h"

#include <algorithm>
#include <utility>

namespace swaplight {
namespace {

std::vector<size_t> placesOf(const Capture& capture, bool crossed) {
  std::vector<size_t> places;
  for (size_t k = 0; k < capture.shots.size(); ++k)
    if (capture.shots[k].crossed == crossed) places.push_back(k);
  return places;
}

/// What is said of each shot, of these only.
void keepLevels(const Capture& capture, bool crossed, CapturePixels& pixels) {
  const std::vector<float> clipLevel = std::move(pixels.clipLevel), quantum = std::move(pixels.quantum);
  const std::vector<float> lift = std::move(pixels.clippedLift);
  pixels.clipLevel.clear();
  pixels.quantum.clear();
  pixels.clippedLift.clear();
  for (const size_t k : placesOf(capture, crossed)) {
    pixels.clipLevel.push_back(clipLevel[k]);
    pixels.quantum.push_back(quantum[k]);
    if (!lift.empty()) pixels.clippedLift.push_back(lift[k]);
  }
}

}  // namespace

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

CapturePixels copiedShots(const Capture& capture, bool crossed, const CapturePixels& from) {
  CapturePixels pixels = withoutShots(from);
  keepLevels(capture, crossed, pixels);
  for (const size_t k : placesOf(capture, crossed)) pixels.shots.push_back(from.shots[k].clone());
  return pixels;
}

BorrowedShots::BorrowedShots(const Capture& capture, bool crossed, CapturePixels& from)
    : m_from(from), m_pixels(withoutShots(from)), m_places(placesOf(capture, crossed)) {
  keepLevels(capture, crossed, m_pixels);
  for (const size_t k : m_places) m_pixels.shots.push_back(std::move(from.shots[k]));
}

BorrowedShots::~BorrowedShots() {
  for (size_t j = 0; j < m_places.size(); ++j) m_from.shots[m_places[j]] = std::move(m_pixels.shots[j]);
}

}  // namespace swaplight
