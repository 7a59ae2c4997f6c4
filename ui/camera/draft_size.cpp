#include "ui/camera/draft_size.h"

#include <array>

namespace swaplight {
namespace {

/// Half of the 33 ms in which a picture follows the hand: the rest is the window's own.
constexpr double kDraftSeconds = 0.016;
/// A draft that nobody waits for shares the processor with the window's own drawing, and takes this many
/// times as long.
constexpr double kHeldUp = 2;
/// Each has twice the pixels of the one before it.
constexpr std::array<float, 5> kScales = {0.26F, 0.36F, 0.51F, 0.71F, 1};
/// Twice the pixels cost up to 2 sqrt(2) times as much: a blur looks further on a larger picture.
constexpr double kDearer = 2.83;

}  // namespace

float DraftSize::scaleFor(const std::vector<std::string>& filters) {
  if (filters != m_filters) {
    m_filters = filters;
    m_step = 0;
    m_seconds = 0;
  }
  return kScales.at(m_step);
}

void DraftSize::tell(float scale, double seconds) {
  if (scale != kScales.at(m_step)) return;  // an exact picture, or of an earlier step
  m_seconds = seconds;
  if (seconds > kDraftSeconds && m_step > 0) {
    m_seconds /= kDearer;
    --m_step;
  } else if (seconds * kDearer < kDraftSeconds && m_step + 1 < kScales.size()) {
    m_seconds *= kDearer;
    ++m_step;
  }
}

bool DraftSize::isQuick() const {
  return m_seconds > 0 && m_seconds <= kHeldUp * kDraftSeconds;
}

}  // namespace swaplight
