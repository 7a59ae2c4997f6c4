#include "core/edit/shapes/paint.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/guide/edge_guide.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

constexpr float kSpacing = .25f;  // of the radius
constexpr float kLeastSpacing = .5f;
constexpr double kFarthest = 1e6;  // pixels: what a stroke's coordinates can be

// How much of the brush reaches a distance from its centre (1 = its rim): full within the hard core, then a
// smooth fall.
float brushProfile(float distance, float hardness) {
  if (distance >= 1) return 0;
  if (distance <= hardness) return 1;
  const float t = (1 - distance) / (1 - hardness);
  return t * t * (3 - 2 * t);
}

// The part of the way, in pixels along it, on which a brush can reach the picture.
std::pair<double, double> reaching(const StrokePoint& from, const StrokePoint& to, double length,
                                   float radius, int width, int height) {
  double enter = 0, leave = length;
  const auto clip = [&](double start, double end, double low, double high) {
    const double slope = length > 0 ? (end - start) / length : 0;
    if (slope == 0) {
      if (start < low || start > high) leave = -1;
      return;
    }
    const double a = (low - start) / slope, b = (high - start) / slope;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  const double air = double{radius} + 1;
  clip(from.x, to.x, -air, width + air);
  clip(from.y, to.y, -air, height + air);
  return {std::min(enter, leave), leave};
}

}  // namespace

Painting Painting::guidedBy(std::shared_ptr<const EdgeGuide> guide) const {
  Painting again(m_mask.width(), m_mask.height(), std::move(guide));
  for (const auto& stroke : m_strokes) again.begin(*stroke);
  return again;
}

bool Painting::followsEdges() const {
  return std::any_of(m_strokes.begin(), m_strokes.end(), [](const auto& stroke) { return stroke->edges; });
}

void Painting::begin(Stroke stroke) {
  const std::vector<StrokePoint> points = std::move(stroke.points);
  stroke.points.clear();
  m_strokes.push_back(std::make_shared<Stroke>(std::move(stroke)));
  m_toNextDab = 0;
  for (const StrokePoint& point : points) add(point);
}

PixelRect Painting::add(const StrokePoint& point) {
  // The stroke in hand may be shared with an older state: that one keeps its points.
  if (m_strokes.back().use_count() > 1) m_strokes.back() = std::make_shared<Stroke>(*m_strokes.back());
  auto& points = std::const_pointer_cast<Stroke>(m_strokes.back())->points;
  points.push_back(point);
  return points.size() == 1 ? follow(point, point) : follow(points[points.size() - 2], point);
}

PixelRect Painting::follow(const StrokePoint& from, const StrokePoint& to) {
  const Stroke& stroke = *m_strokes.back();
  const double length = std::hypot(double{to.x} - from.x, double{to.y} - from.y);
  // Nothing before `enter` or behind `leave` reaches the picture: those dabs are counted, not made.
  const auto [enter, leave] = reaching(from, to, length, stroke.radius, m_mask.width(), m_mask.height());
  PixelRect changed;
  double next = m_toNextDab;
  while (next <= length) {
    const auto t = static_cast<float>(length > 0 ? next / length : 0);
    const StrokePoint at{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                         from.pressure + t * (to.pressure - from.pressure)};
    const float radius = stroke.radius * (stroke.pressureToRadius ? at.pressure : 1.f);
    const double spacing = std::max(kSpacing * radius, kLeastSpacing);
    const bool before = next < enter;
    if (!before && next <= leave) changed = enclosing(changed, dab(at));
    const double skipTo = before ? enter : next > leave ? length : next;
    next += spacing * std::max(1., std::floor((skipTo - next) / spacing));
  }
  m_toNextDab = static_cast<float>(next - length);
  return changed;
}

PixelRect Painting::dab(const StrokePoint& at) {
  const Stroke& stroke = *m_strokes.back();
  const float radius = stroke.radius * (stroke.pressureToRadius ? at.pressure : 1.f);
  const float flow = stroke.flow * (stroke.pressureToFlow ? at.pressure : 1.f);
  const float hardness = std::min(stroke.hardness, 1 - 1 / std::max(radius, 1.01f));
  const int left = static_cast<int>(std::floor(at.x - radius));
  const int top = static_cast<int>(std::floor(at.y - radius));
  const int right = static_cast<int>(std::ceil(at.x + radius));
  const int bottom = static_cast<int>(std::ceil(at.y + radius));
  const PixelRect area =
      intersection({left, top, right - left, bottom - top}, {0, 0, m_mask.width(), m_mask.height()});
  const float target = stroke.erase ? 0 : stroke.opacity * 65535.f;
  const EdgeGuide* guide = stroke.edges && !area.empty() ? m_guide.get() : nullptr;
  // As far apart as dabs lie: along the path every place is the middle of one.
  const EdgeGuide::Surface surface =
      guide ? guide->surfaceAt(at.x, at.y, kSpacing * radius) : EdgeGuide::Surface{};

  // Tile by tile, move each pixel some way towards the target, never past it.
  for (int row = area.y / kMaskTile; !area.empty() && row <= (area.bottom() - 1) / kMaskTile; ++row)
    for (int column = area.x / kMaskTile; column <= (area.right() - 1) / kMaskTile; ++column) {
      uint16_t* tile = m_mask.writableTile(column, row);
      const PixelRect part = intersection(area, {column * kMaskTile, row * kMaskTile, kMaskTile, kMaskTile});
      for (int y = part.y; y < part.bottom(); ++y)
        for (int x = part.x; x < part.right(); ++x) {
          const float dx = (static_cast<float>(x) + .5f - at.x) / radius;
          const float dy = (static_cast<float>(y) + .5f - at.y) / radius;
          float share = flow * brushProfile(std::sqrt(dx * dx + dy * dy), hardness);
          if (guide && share > 0) share *= guide->likeness(surface, x, y);
          uint16_t& pixel = tile[y % kMaskTile * kMaskTile + x % kMaskTile];
          const auto now = static_cast<float>(pixel);
          const float step = share * (stroke.erase ? stroke.opacity : 1.f) * (target - now);
          if (stroke.erase ? step < 0 : step > 0) pixel = static_cast<uint16_t>(std::lround(now + step));
        }
    }
  return area;
}

namespace {

StrokePoint pointFromJson(const Json& json, const std::string& where) {
  const auto number = [&](size_t index, double low, double high) {
    const double value = json[index].is_number() ? json[index].get<double>() : std::nan("");
    if (!(value >= low && value <= high))
      throw InputError("{}: a point has {}, expected a number from {} to {}", where,
                       describeJson(json[index]), low, high);
    return static_cast<float>(value);
  };
  if (!json.is_array() || json.size() < 2 || json.size() > 3)
    throw InputError("{}: a point is {}, expected [x, y, pressure]", where, describeJson(json));
  return {number(0, -kFarthest, kFarthest), number(1, -kFarthest, kFarthest),
          json.size() > 2 ? number(2, 0, 1) : 1.f};
}

}  // namespace

Json jsonFromStroke(const Stroke& stroke) {
  Json points = Json::array();
  for (const StrokePoint& p : stroke.points)
    points.push_back({jsonNumber(p.x), jsonNumber(p.y), jsonNumber(p.pressure)});
  Json json = {{"radius", jsonNumber(stroke.radius)},
               {"hardness", jsonNumber(stroke.hardness)},
               {"flow", jsonNumber(stroke.flow)},
               {"opacity", jsonNumber(stroke.opacity)},
               {"erase", stroke.erase},
               {"pressure_to_radius", stroke.pressureToRadius},
               {"pressure_to_flow", stroke.pressureToFlow},
               {"points", std::move(points)}};
  if (stroke.edges) json["edges"] = true;
  return json;
}

Stroke strokeFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  Stroke stroke;
  const auto read = [&](const char* key, float& value, double low, double high) {
    value = static_cast<float>(fields.number(key, low, high).value_or(value));
  };
  read("radius", stroke.radius, .1, 1e5);
  read("hardness", stroke.hardness, 0, 1);
  read("flow", stroke.flow, 0, 1);
  read("opacity", stroke.opacity, 0, 1);
  stroke.erase = fields.boolean("erase").value_or(stroke.erase);
  stroke.pressureToRadius = fields.boolean("pressure_to_radius").value_or(stroke.pressureToRadius);
  stroke.pressureToFlow = fields.boolean("pressure_to_flow").value_or(stroke.pressureToFlow);
  stroke.edges = fields.boolean("edges").value_or(stroke.edges);
  for (const Json& p : fields.list("points", "the places of the brush as [x, y, pressure]"))
    stroke.points.push_back(pointFromJson(p, where));
  return stroke;
}

}  // namespace swaplight
