#include "core/edit/pool/lamp_handle.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

/// Of the ring, the beam as it was photographed.
double ringRadius(const LampInHand& held) {
  constexpr double kLeast = 1e-3;  // of a light that lights next to nothing
  return std::max(held.width / 4, kLeast);
}

}  // namespace

PlanePoint middleOf(const LampModel& lamp, const LampChange& change) {
  constexpr double kFarthest = 20;  // widths of the picture: nobody looks so far beside it
  constexpr double kLeast = 1e-9;
  const LampModel now = ChangedLamp(lamp, change).after();
  const cv::Vec3d axis = now.axis();
  double far = kFarthest / std::max(std::hypot(axis[0], axis[1]), kLeast);
  if (axis[2] < -kLeast) far = std::min(far, now.position[2] / -axis[2]);
  return {now.position[0] + far * axis[0], now.position[1] + far * axis[1]};
}

LampChange movedTo(const LampModel& lamp, const PlanePoint& place) {
  LampChange change;
  change.right = static_cast<float>(place.x - lamp.aim[0]);
  change.up = static_cast<float>(place.y - lamp.aim[1]);
  return change;
}

LampChange turnedTo(const LampModel& lamp, const PlanePoint& place) {
  LampChange change;
  const cv::Vec3d axis = lamp.axis();
  const cv::Vec3d wanted = cv::normalize(cv::Vec3d(place.x, place.y, 0) - lamp.position);
  const cv::Vec3d aside = wanted - axis * axis.dot(wanted);
  // A turn is a direction in the picture, (pan, tilt, 0), and an angle: of that direction the part across the
  // axis is `aside`, so that what it lacks is along the axis.
  const cv::Vec3d swing = aside - axis * (aside[2] / axis[2]);
  const double length = cv::norm(swing);
  if (length < 1e-9) return change;
  const double degrees = std::acos(std::clamp(axis.dot(wanted), -1., 1.)) * 180 / CV_PI;
  change.pan = static_cast<float>(degrees * swing[0] / length);
  change.tilt = static_cast<float>(degrees * swing[1] / length);
  return change;
}

PlanePoint ringHandle(const LampInHand& held, double spread) {
  const double side = held.lamp.aim[0] > 0 ? -1 : 1;
  return {held.lamp.aim[0] + side * spread * ringRadius(held), held.lamp.aim[1]};
}

double spreadThrough(const LampInHand& held, const PlanePoint& place) {
  return std::hypot(place.x - held.lamp.aim[0], place.y - held.lamp.aim[1]) / ringRadius(held);
}

}  // namespace swaplight
