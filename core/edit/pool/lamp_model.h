#pragma once

#include <array>
#include <opencv2/core.hpp>

#include "core/edit/pool/lamp_change.h"

namespace swaplight {

// A lamp as far as its light in one picture tells. Nobody knows the set's geometry: an upright plane stands
// for it, z = 0, of which the picture is a view at right angles. Lengths are widths of the picture; x to the
// right and y up from the middle of the picture, z towards the camera.

/// Where a lamp stands and where it points.
struct LampModel {
  cv::Vec3d position{0, 0, 0.8};
  cv::Vec3d aim{0, 0, 0};  ///< where its axis meets the plane: the middle of what it lights
  /// Of its beam: the intensity goes with the cosine of the angle to the axis to this power. 1: a softbox; 0:
  /// alike in all directions (a bare bulb; a spot, whose cone is a picture of its own).
  double lobe = 1;

  [[nodiscard]] cv::Vec3d axis() const { return cv::normalize(aim - position); }
  [[nodiscard]] double distance() const { return cv::norm(aim - position); }
};

/// The diameter, over its distance, of a lamp of which nobody has said it: a spot's, or a softbox's.
[[nodiscard]] double usualDiameter(const LampModel& lamp);

/// Points of a lamp's front, of even light.
using LampFront = std::array<cv::Vec3d, 16>;

/// The lamp after a change, and where a ray of its beam was before.
class ChangedLamp {
 public:
  ChangedLamp(const LampModel& before, const LampChange& change);

  /// log of how much more light reaches the plane at (x, y): n.l / d^2 and the beam of an even lamp (a spot's
  /// cone does not count here; see sourceOf).
  [[nodiscard]] double logGain(double x, double y) const;
  /// Of its front as it was photographed.
  [[nodiscard]] double diameter() const { return m_diameter; }
  /// The ray that now meets the plane at (x, y) met it here before. False where it comes from behind the
  /// lamp, or went away from the plane.
  bool sourceOf(double x, double y, double& sourceX, double& sourceY) const;
  [[nodiscard]] const LampModel& after() const { return m_after; }

 private:
  LampModel m_before, m_after;
  cv::Matx33d m_toBefore;  // directions from the lamp now -> before
  double m_contrast;       // of the beam's falloff
  double m_middle;         // log of the falloff in the middle
  double m_diameter, m_size;
  cv::Vec3d m_axis;  ///< of the lamp after the change, as are its fronts
  LampFront m_front, m_sizedFront;
};

/// n.l / d^2 times the beam at (x, y) of the plane, as a logarithm, but for a constant.
[[nodiscard]] double logLevel(const LampModel& lamp, double x, double y);

}  // namespace swaplight
