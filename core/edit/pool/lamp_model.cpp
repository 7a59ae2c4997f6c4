#include "core/edit/pool/lamp_model.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

constexpr double kLeastCosine = 0.02;  // light that grazes is not followed to its end
constexpr double kLeastDepth = 0.05;   // widths of the picture: a lamp stays in front of the plane

/// The turn that carries the axis by so many degrees to the right and up, as the camera sees it.
cv::Matx33d swing(const cv::Vec3d& axis, double pan, double tilt) {
  const double degrees = std::hypot(pan, tilt);
  if (degrees == 0) return cv::Matx33d::eye();
  const cv::Vec3d across = axis.cross(cv::Vec3d(pan, tilt, 0) / degrees);
  const double length = cv::norm(across);
  if (length < 1e-6) return cv::Matx33d::eye();  // it points there already
  const cv::Vec3d k = across / length;
  const double angle = degrees * CV_PI / 180;
  const cv::Matx33d cross(0, -k[2], k[1], k[2], 0, -k[0], -k[1], k[0], 0);
  return cv::Matx33d::eye() + std::sin(angle) * cross + (1 - std::cos(angle)) * cross * cross;  // Rodrigues
}

}  // namespace

double logLevel(const LampModel& lamp, double x, double y) {
  const cv::Vec3d ray(x - lamp.position[0], y - lamp.position[1], -lamp.position[2]);
  const double square = ray.dot(ray);
  double level = std::log(lamp.position[2]) - 1.5 * std::log(square);
  if (lamp.lobe != 0)
    level += lamp.lobe * std::log(std::max(ray.dot(lamp.axis()) / std::sqrt(square), kLeastCosine));
  return level;
}

ChangedLamp::ChangedLamp(const LampModel& before, const LampChange& change)
    : m_before(before), m_after(before) {
  const cv::Vec3d axis = before.axis();
  const cv::Matx33d turn = swing(axis, change.pan, change.tilt);
  m_after.position = before.aim + double{change.distance} * (before.position - before.aim) +
                     cv::Vec3d(change.right, change.up, 0);
  m_after.position[2] = std::max(m_after.position[2], kLeastDepth);
  m_after.aim = m_after.position + before.distance() * (turn * axis);

  // A direction's part across the axis is that much longer in a wider beam.
  const cv::Matx33d along = axis * axis.t();
  m_toBefore = (along + (cv::Matx33d::eye() - along) * (1. / change.spread)) * turn.t();
  m_contrast = 1. / (double{change.spread} * change.spread);
  m_middle = logLevel(before, before.aim[0], before.aim[1]);
}

double ChangedLamp::logGain(double x, double y) const {
  const double before = logLevel(m_before, x, y);
  double gain = logLevel(m_after, x, y) - before;
  // A beam that is wider falls off less: a Gaussian's logarithm goes with the inverse square of its width.
  if (m_before.lobe != 0 && m_contrast != 1) gain += (m_contrast - 1) * (before - m_middle);
  return gain;
}

bool ChangedLamp::sourceOf(double x, double y, double& sourceX, double& sourceY) const {
  const cv::Vec3d now(x - m_after.position[0], y - m_after.position[1], -m_after.position[2]);
  const cv::Vec3d ray = m_toBefore * now;
  constexpr double kAway = -1e-3;
  if (ray[2] > kAway || ray.dot(m_before.axis()) <= 0) return false;
  const double t = m_before.position[2] / -ray[2];
  sourceX = m_before.position[0] + t * ray[0];
  sourceY = m_before.position[1] + t * ray[1];
  return true;
}

}  // namespace swaplight
