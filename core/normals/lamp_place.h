#pragma once

#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

namespace swaplight {

/// Where a lamp stood, as a person says it who was there, seen from the middle of what the picture shows.
struct LampPlace {
  double azimuth =
      0;  ///< degrees to the right of the camera: 90 on the right, -90 on the left, 180 behind the set
  double elevation = 0;  ///< degrees above the line from there to the camera, -90..90
  /// Widths of the picture, as wide as it is at the set; nothing: so far that its light is parallel.
  std::optional<double> distance;
  /// What a meter reads there that points to the lamp, at unit white; from any level that all lamps share.
  std::optional<double> stops;

  /// Nearer ones light a set of unknown depth from unknown directions: at two widths a surface that lies a
  /// quarter of a width before or behind the middle sees a lamp at the side 7 degrees off.
  static constexpr double kNearest = 2;
  [[nodiscard]] bool isTooNear() const { return distance && *distance < kNearest; }
  bool operator==(const LampPlace&) const = default;
};

/// Of lamps, by their lights' names.
using LampPlaces = std::map<std::string, LampPlace>;

/// What a lamp sends to a place of an upright plane through the middle of the set, which stands for it.
struct LampRay {
  cv::Vec3d direction;  ///< to the lamp: x to the right, y up, z towards the camera; of length 1
  double level = 1;     ///< of the light from there, over that in the middle
};

/// Of places x, y: widths of the picture from its middle, to the right and up. No place is nearer to the lamp
/// than kNearest, so that the level stays finite.
class LampRays {
 public:
  explicit LampRays(const LampPlace& place);
  [[nodiscard]] LampRay at(double x, double y) const;

  static constexpr double kNearest = 0.05;  ///< widths of the picture

 private:
  cv::Vec3d m_direction;
  std::optional<double> m_distance;
};

}  // namespace swaplight
