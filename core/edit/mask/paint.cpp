#include "core/edit/mask/paint.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

constexpr float kSpacing = .25f;  // of the radius

// How much of the brush reaches a distance from its centre (1 = its rim): full within the hard core, then a
// smooth fall.
float brushProfile(float distance, float hardness) {
  if (distance >= 1) return 0;
  if (distance <= hardness) return 1;
  const float t = (1 - distance) / (1 - hardness);
  return t * t * (3 - 2 * t);
}

}  // namespace

void Painting::begin(Stroke stroke) {
  const std::vector<StrokePoint> points = std::move(stroke.points);
  stroke.points.clear();
  m_strokes.push_back(std::make_shared<Stroke>(std::move(stroke)));
  m_toNextDab = 0;
  for (const StrokePoint& point : points) add(point);
}

PixelRect Painting::add(const StrokePoint& point) {
  // The stroke in hand may be shared with an older state: that one keeps its points.
  auto grown = std::make_shared<Stroke>(*m_strokes.back());
  grown->points.push_back(point);
  m_strokes.back() = grown;
  const auto& points = grown->points;
  return points.size() == 1 ? follow(point, point) : follow(points[points.size() - 2], point);
}

PixelRect Painting::follow(const StrokePoint& from, const StrokePoint& to) {
  const Stroke& stroke = *m_strokes.back();
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  const bool first = stroke.points.size() == 1;
  PixelRect changed;
  while (first ? m_toNextDab <= 0 : m_toNextDab <= length) {
    const float t = length > 0 ? m_toNextDab / length : 0;
    const StrokePoint at{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                         from.pressure + t * (to.pressure - from.pressure)};
    changed = enclosing(changed, dab(at));
    const float radius = stroke.radius * (stroke.pressureToRadius ? at.pressure : 1.f);
    m_toNextDab += std::max(kSpacing * radius, .5f);
  }
  m_toNextDab -= length;
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

  // Tile by tile, move each pixel some way towards the target, never past it.
  for (int row = area.y / kMaskTile; !area.empty() && row <= (area.bottom() - 1) / kMaskTile; ++row)
    for (int column = area.x / kMaskTile; column <= (area.right() - 1) / kMaskTile; ++column) {
      uint16_t* tile = m_mask.writableTile(column, row);
      const PixelRect part = intersection(area, {column * kMaskTile, row * kMaskTile, kMaskTile, kMaskTile});
      for (int y = part.y; y < part.bottom(); ++y)
        for (int x = part.x; x < part.right(); ++x) {
          const float dx = (static_cast<float>(x) + .5f - at.x) / radius;
          const float dy = (static_cast<float>(y) + .5f - at.y) / radius;
          const float share = flow * brushProfile(std::sqrt(dx * dx + dy * dy), hardness);
          uint16_t& pixel = tile[y % kMaskTile * kMaskTile + x % kMaskTile];
          const auto now = static_cast<float>(pixel);
          const float step = share * (stroke.erase ? stroke.opacity : 1.f) * (target - now);
          if (stroke.erase ? step < 0 : step > 0) pixel = static_cast<uint16_t>(std::lround(now + step));
        }
    }
  return area;
}

Json jsonFromStroke(const Stroke& stroke) {
  Json points = Json::array();
  for (const StrokePoint& p : stroke.points)
    points.push_back({jsonNumber(p.x), jsonNumber(p.y), jsonNumber(p.pressure)});
  return {{"radius", jsonNumber(stroke.radius)},
          {"hardness", jsonNumber(stroke.hardness)},
          {"flow", jsonNumber(stroke.flow)},
          {"opacity", jsonNumber(stroke.opacity)},
          {"erase", stroke.erase},
          {"pressure_to_radius", stroke.pressureToRadius},
          {"pressure_to_flow", stroke.pressureToFlow},
          {"points", std::move(points)}};
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
  for (const Json& p : fields.list("points", "the places of the brush as [x, y, pressure]")) {
    const bool numbers = p.is_array() && p.size() >= 2 && p.size() <= 3 &&
                         std::all_of(p.begin(), p.end(), [](const Json& v) { return v.is_number(); });
    if (!numbers) throw InputError("{}: a point is {}, expected [x, y, pressure]", where, describeJson(p));
    stroke.points.push_back({p[0].get<float>(), p[1].get<float>(), p.size() > 2 ? p[2].get<float>() : 1.f});
  }
  return stroke;
}

}  // namespace swaplight
