#pragma once

#include "core/color/rgb.h"
#include "core/lamp/gel.h"

namespace swaplight {

/// The light of a lamp on its way through filters. As long as it is a white, filters move it along and across
/// the locus of whites (see kelvin.h); once it is coloured they multiply its linear Rec.709 channels.
class Lamp {
 public:
  /// Luminance 1; kelvin in 1000..25000. At kD65Kelvin its colour is exactly {1, 1, 1}.
  static Lamp white(double kelvin);
  static Lamp colored(const Rgb& rec709);

  void through(const Gel& gel);
  /// Plus (or minus) green without loss of light, as a fixture does it; 1 = a full gel.
  void addGreen(float amount);

  /// Linear Rec.709.
  [[nodiscard]] Rgb color() const;

 private:
  void shift(double mired, double green);

  bool m_isWhite = true;
  double m_kelvin = 0;
  double m_green = 0;
  Rgb m_filter{1, 1, 1};  ///< on a white's colour; the colour itself where it is none
};

}  // namespace swaplight
