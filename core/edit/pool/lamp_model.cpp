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

// Of the distance: the geometric means of the lamps of eleven rendered sets (docs/edits.md). How wide the
// edges of shadows are does not tell how large a lamp is.
constexpr double kSpot = 0.01;
constexpr double kSoftbox = 0.15;

/// Points that lie evenly on a lamp's front.
LampFront frontOf(const LampModel& lamp, double diameter) {
  const cv::Vec3d axis = lamp.axis();
  const cv::Vec3d across =
      cv::normalize(axis.cross(std::abs(axis[1]) < .9 ? cv::Vec3d(0, 1, 0) : cv::Vec3d(1, 0, 0)));
  const cv::Vec3d along = axis.cross(across);
  constexpr double kGolden = 2.399963;  // radians: as on a sunflower
  LampFront front;
  const auto count = static_cast<double>(front.size());
  for (size_t k = 0; k < front.size(); ++k) {
    const auto turn = kGolden * static_cast<double>(k);
    const double radius = .5 * diameter * std::sqrt((static_cast<double>(k) + .5) / count);
    front[k] = lamp.position + radius * (std::cos(turn) * across + std::sin(turn) * along);
  }
  return front;
}

/// n.l / d^2 times the beam, the mean over a front: what of it is behind the plane gives none.
double frontLevel(const LampFront& front, const cv::Vec3d& axis, double lobe, double x, double y) {
  double sum = 0;
  for (const cv::Vec3d& place : front) {
    if (place[2] <= 0) continue;
    const cv::Vec3d ray(x - place[0], y - place[1], -place[2]);
    const double square = ray.dot(ray);
    const double length = std::sqrt(square);
    const double cosine = std::max(ray.dot(axis) / length, kLeastCosine);
    const double beam = lobe == 0 ? 1 : lobe == 1 ? cosine : std::pow(cosine, lobe);
    sum += place[2] / (square * length) * beam;
  }
  return std::max(sum / static_cast<double>(front.size()), 1e-12);
}

}  // namespace

double usualDiameter(const LampModel& lamp) {
  return lamp.lobe == 0 ? kSpot : kSoftbox;
}

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
  m_diameter = before.distance() * (change.diameter > 0 ? double{change.diameter} : usualDiameter(before));
  m_size = change.size;
  m_axis = m_after.axis();
  m_front = frontOf(m_after, m_diameter);
  m_sizedFront = frontOf(m_after, m_size * m_diameter);
}

double ChangedLamp::logGain(double x, double y) const {
  const double before = logLevel(m_before, x, y);
  double gain = logLevel(m_after, x, y) - before;
  // A beam that is wider falls off less: a Gaussian's logarithm goes with the inverse square of its width.
  if (m_before.lobe != 0 && m_contrast != 1) gain += (m_contrast - 1) * (before - m_middle);
  if (m_size != 1)
    gain += std::log(frontLevel(m_sizedFront, m_axis, m_after.lobe, x, y) /
                     frontLevel(m_front, m_axis, m_after.lobe, x, y));
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
