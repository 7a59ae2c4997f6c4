#include "core/lamp/lamp.h"

#include <algorithm>

#include "core/lamp/kelvin.h"

namespace swaplight {
namespace {

// Bluer than this no white is: the locus ends at infinite temperature.
constexpr double kLowestMired = 1;

}  // namespace

Lamp Lamp::white(double kelvin) {
  Lamp lamp;
  lamp.m_kelvin = kelvin;
  return lamp;
}

Lamp Lamp::colored(const Rgb& rec709) {
  Lamp lamp;
  lamp.m_isWhite = false;
  lamp.m_filter = rec709;
  return lamp;
}

void Lamp::through(const Gel& gel) {
  switch (gel.kind) {
    case Gel::Kind::Neutral:
      m_filter *= gel.transmission;
      break;
    case Gel::Kind::Correction:
      shift(gel.miredShift, gel.green);
      m_filter *= gel.transmission;
      break;
    case Gel::Kind::Color:
      *this = colored(color() * gel.filter);
      break;
  }
}

void Lamp::addGreen(float amount) {
  shift(0, amount);
}

void Lamp::shift(double mired, double green) {
  if (m_isWhite) {
    m_kelvin = 1e6 / std::clamp(1e6 / m_kelvin + mired, kLowestMired, 1e6 / kLowestKelvin);
    m_green += green;
  } else {
    Lamp filter = white(kD65Kelvin);
    filter.shift(mired, green);
    m_filter *= filter.color();
  }
}

Rgb Lamp::color() const {
  if (!m_isWhite || (m_kelvin == kD65Kelvin && m_green == 0)) return m_filter;
  return m_filter * rec709FromXy(whiteXy(m_kelvin, m_green * kFullGreenDuv));
}

}  // namespace swaplight
