#include "core/bench/bench_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "core/base/parallel.h"
#include "core/color/rgb.h"

namespace swaplight {
namespace {

using Vec = glm::vec3;

constexpr float kPi = 3.14159265F;
constexpr int kSubpixels = 2;    // a side
constexpr int kShadowRays = 8;   // a subpixel
constexpr int kBounceRays = 24;  // a subpixel
constexpr float kWallDepth = 3;  // the wall's z; the floor is y = 0
constexpr float kLampRadius = .25F;
constexpr float kLampDistance = 4.5F;

struct Ray {
  Vec from, to;  ///< `to` is a direction of length 1
};

struct Ball {
  Vec center;
  float radius;
};

/// A point of a surface that a ray meets.
struct Hit {
  Vec point, normal;
  Rgb albedo;
  float gloss;     ///< 0..1, before the picture's own
  float exponent;  ///< of the highlight
};

uint32_t hash(uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352dU;
  x = (x ^ (x >> 15)) * 0x846ca68bU;
  return x ^ (x >> 16);
}

/// 0..1, of a lattice point.
float lattice(int x, int y, int z, uint32_t seed) {
  return float(hash(uint32_t(x) + hash(uint32_t(y) + hash(uint32_t(z) + seed))) >> 8) / float(1 << 24);
}

float smoothNoise(const Vec& p, uint32_t seed) {
  const Vec cell(std::floor(p.x), std::floor(p.y), std::floor(p.z));
  const Vec f = p - cell;
  float sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int dx = corner & 1;
    const int dy = corner >> 1 & 1;
    const int dz = corner >> 2;
    const float weight = (dx ? f.x : 1 - f.x) * (dy ? f.y : 1 - f.y) * (dz ? f.z : 1 - f.z);
    sum += weight * lattice(int(cell.x) + dx, int(cell.y) + dy, int(cell.z) + dz, seed);
  }
  return sum;
}

/// Detail of every size from half a metre down to a pixel, the larger the stronger; about 0..1.
float speckle(const Vec& p, uint32_t seed) {
  float sum = 0;
  float weights = 0;
  float weight = 1;
  float frequency = 2;
  for (int octave = 0; octave < 6; ++octave, weight *= .65F, frequency *= 2.1F) {
    sum += weight * smoothNoise(frequency * p, seed + uint32_t(octave));
    weights += weight;
  }
  const float x = .5F + 1.6F * (sum / weights - .5F);
  return std::fmin(std::fmax(x, 0.0F), 1.0F);
}

Rgb paint(uint32_t seed) {
  const auto unit = [&](uint32_t n) { return float(hash(seed * 3 + n) >> 8) / float(1 << 24); };
  return {.08F + .8F * unit(0), .08F + .8F * unit(1), .08F + .8F * unit(2)};
}

std::vector<Ball> balls(bool moved) {
  std::vector<Ball> all{{{-2.1F, .8F, .9F}, .8F},     {{-.6F, .55F, -.3F}, .55F}, {{.75F, .95F, 1.3F}, .95F},
                        {{2.0F, .6F, .1F}, .6F},      {{-1.5F, .3F, -1.3F}, .3F}, {{.6F, .33F, -1.2F}, .33F},
                        {{1.35F, .22F, -1.5F}, .22F}, {{-.2F, .25F, -1.7F}, .25F}};
  if (moved) all[5].center += Vec(.45F, 0, -.15F);
  return all;
}

// Varnish, a billiard ball, satin; the rest is chalk.
constexpr std::array<float, 8> kGloss{.5F, 0, 1, 0, 0, 1, .6F, 0};
constexpr std::array<float, 8> kExponent{12, 1, 150, 1, 1, 50, 8, 1};

Hit ballHit(const Ball& ball, size_t index, const Vec& point) {
  const Vec local = (point - ball.center) / ball.radius;
  const auto seed = uint32_t(index) * 17 + 5;
  Rgb albedo = paint(seed);
  if (index % 4 == 1 && std::fmod(std::floor(5 * local.y + 20), 2.0F) == 0) albedo = paint(seed + 1);
  if (index % 2 == 0) albedo *= .35F + .65F * speckle(point, seed);
  return {point, local, albedo, kGloss[index], kExponent[index]};
}

Hit floorHit(const Vec& point) {
  const int x = int(std::floor(1.4F * point.x));
  const int z = int(std::floor(1.4F * point.z));
  const bool dark = (x + z) % 2 != 0;
  const Rgb albedo =
      (dark ? Rgb(.25F, .16F, .1F) : Rgb(.75F, .68F, .58F)) * (.45F + .55F * speckle(point, 3));
  return {point, {0, 1, 0}, albedo, dark ? .7F : 0.0F, 20};
}

/// Posters on plaster.
Hit wallHit(const Vec& point) {
  const float u = .9F * point.x + 40;
  const float v = 1.1F * point.y;
  const auto seed = hash(uint32_t(int(u)) * 7 + uint32_t(int(v))) & 255U;
  const float x = u - std::floor(u);
  const float y = v - std::floor(v);
  const bool poster = x > .12F && x < .85F && y > .15F && y < .9F;
  Rgb albedo = poster ? paint(seed) : Rgb(.7F, .7F, .66F);
  if (poster && std::fmod(std::floor(9 * x) + std::floor(7 * y), 3.0F) == 0) albedo = paint(seed + 300);
  return {point, {0, 0, -1}, albedo * (.55F + .45F * speckle(point, 11)), poster ? .4F : 0.0F, 10};
}

/// A still life and its lamps.
class StillLife {
 public:
  explicit StillLife(const BenchPicture& picture) : m_picture(picture), m_balls(balls(picture.moved)) {
    for (int i = 0; i < picture.lights; ++i) {
      const float angle = (-.27F + .54F * float(i) / float(std::max(picture.lights - 1, 1))) * kPi;
      const float height = i % 2 == 0 ? 2.4F : 3.6F;
      m_lamps.emplace_back(kLampDistance * std::sin(angle), height, -kLampDistance * std::cos(angle) * .8F);
    }
  }

  /// Of the picture as it is computed.
  [[nodiscard]] int width() const { return kSubpixels * m_picture.width; }
  [[nodiscard]] int height() const { return kSubpixels * m_picture.height; }

  [[nodiscard]] Ray eyeRay(float x, float y) const {
    const float u = (x + kSubpixels * m_picture.shiftX - .5F * float(width())) / float(width());
    const float v = (y + kSubpixels * m_picture.shiftY - .5F * float(height())) / float(width());
    return {{0, 1.7F, -6}, glm::normalize(Vec(.95F * u, -.13F - .95F * v, 1))};
  }

  [[nodiscard]] std::optional<Hit> hit(const Ray& ray) const {
    float nearest = std::numeric_limits<float>::infinity();
    std::optional<size_t> ball;
    for (size_t b = 0; b < m_balls.size(); ++b)
      if (const float t = distance(m_balls[b], ray); t < nearest) nearest = t, ball = b;
    if (ball && nearest < planes(ray)) return ballHit(m_balls[*ball], *ball, ray.from + nearest * ray.to);
    nearest = planes(ray);
    if (!std::isfinite(nearest)) return std::nullopt;
    const Vec point = ray.from + nearest * ray.to;
    return point.z < kWallDepth - 1e-3F ? floorHit(point) : wallHit(point);
  }

  /// What a lamp sends to the eye from a surface, without other surfaces' help.
  [[nodiscard]] Rgb direct(const Hit& at, const Vec& toEye, int light, int shadowRays, uint32_t seed) const {
    const Vec to = m_lamps[size_t(light)] - at.point;
    const float distance2 = glm::dot(to, to);
    const Vec towards = to / std::sqrt(distance2);
    const float cosine = glm::dot(towards, at.normal);
    if (cosine <= 0) return Rgb(0);
    const float arriving =
        .5F * cosine * kLampDistance * kLampDistance / distance2 * visible(at, light, shadowRays, seed);
    Rgb sum = arriving * at.albedo;
    if (const float gloss = m_picture.gloss * at.gloss; gloss > 0) {
      const float lobe = glm::dot(glm::normalize(towards + toEye), at.normal);
      sum += Rgb(arriving * gloss * (at.exponent + 20) / 25 * std::pow(std::fmax(lobe, 0.0F), at.exponent));
    }
    return sum;
  }

  /// The same with reflections and bounced light, where the picture has them.
  [[nodiscard]] Rgb radiance(const Hit& at, const Vec& toEye, int light, uint32_t seed) const {
    Rgb sum = direct(at, toEye, light, kShadowRays, seed);
    if (const float gloss = m_picture.gloss * at.gloss; gloss > 0) {
      const float cosine = std::fmax(glm::dot(toEye, at.normal), 0.0F);
      const Ray mirrored{lifted(at), 2 * glm::dot(toEye, at.normal) * at.normal - toEye};
      if (const auto seen = hit(mirrored))
        sum +=
            gloss * (.08F + .9F * std::pow(1 - cosine, 5.0F)) * direct(*seen, -mirrored.to, light, 2, seed);
    }
    if (!m_picture.bounced) return sum;
    Rgb gathered(0);
    for (int r = 0; r < kBounceRays; ++r) {
      const Ray out{lifted(at), scattered(at.normal, r, kBounceRays, 0)};
      if (const auto seen = hit(out)) gathered += direct(*seen, -out.to, light, 1, seed);
    }
    return sum + at.albedo * gathered / float(kBounceRays);
  }

  /// The part of an even dome that a surface sees.
  [[nodiscard]] float openness(const Hit& at) const {
    int open = 0;
    for (int r = 0; r < kBounceRays; ++r) {
      const auto seen = hit({lifted(at), scattered(at.normal, r, kBounceRays, 0)});
      open += !seen || glm::distance(seen->point, at.point) > 1.5F;
    }
    return float(open) / kBounceRays;
  }

 private:
  static float distance(const Ball& ball, const Ray& ray) {
    const Vec to = ball.center - ray.from;
    const float along = glm::dot(to, ray.to);
    const float square = along * along - glm::dot(to, to) + ball.radius * ball.radius;
    const float t = along - std::sqrt(std::fmax(square, 0.0F));
    return square > 0 && t > 1e-3F ? t : std::numeric_limits<float>::infinity();
  }
  static float planes(const Ray& ray) {
    const float below = ray.to.y < 0 ? -ray.from.y / ray.to.y : std::numeric_limits<float>::infinity();
    const float behind =
        ray.to.z > 0 ? (kWallDepth - ray.from.z) / ray.to.z : std::numeric_limits<float>::infinity();
    return std::fmin(below, behind);
  }
  static Vec lifted(const Hit& at) { return at.point + 2e-3F * at.normal; }

  /// Directions about a normal, evenly spread by the cosine.
  static Vec scattered(const Vec& normal, int index, int count, uint32_t seed) {
    const float height = 1 - 2 * (float(index) + .5F) / float(count);
    const float angle = 2.3999632F * float(index) + float(seed % 1024) * (2 * kPi / 1024);
    const float radius = std::sqrt(1 - height * height);
    return glm::normalize(normal + .999F * Vec(radius * std::cos(angle), radius * std::sin(angle), height));
  }

  /// The visible part of a lamp.
  [[nodiscard]] float visible(const Hit& at, int light, int rays, uint32_t seed) const {
    const Vec from = lifted(at);
    int seen = 0;
    for (int r = 0; r < rays; ++r) {
      Vec lamp = m_lamps[size_t(light)];
      if (rays > 1) lamp += kLampRadius * scattered(glm::normalize(from - lamp), r, rays, seed);
      const float length = glm::distance(lamp, from);
      const Ray ray{from, (lamp - from) / length};
      bool blocked = false;
      for (const Ball& ball : m_balls) blocked |= distance(ball, ray) < length;
      seen += !blocked;
    }
    return float(seen) / float(rays);
  }

  BenchPicture m_picture;
  std::vector<Ball> m_balls;
  std::vector<Vec> m_lamps;
};

/// What a camera makes of a picture twice as large: lens and sensor spread a point over two pixels.
Image halved(const Image& fine) {
  constexpr std::array<float, 4> kTent{.125F, .375F, .375F, .125F};
  Image image(ImageSpec::rgb(fine.width() / 2, fine.height() / 2));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        float sum = 0;
        for (int j = 0; j < 4; ++j)
          for (int i = 0; i < 4; ++i)
            sum += kTent[size_t(i)] * kTent[size_t(j)] *
                   fine.view().at(c, std::clamp(2 * x + i - 1, 0, fine.width() - 1),
                                  std::clamp(2 * y + j - 1, 0, fine.height() - 1));
        image.span().at(c, x, y) = sum;
      }
  return image;
}

/// Calls shade(hit, direction to the eye, random number, answers) for each point of twice the size that shows
/// something; gives as many pictures as there are answers.
template <int kMost, typename Shade>
std::vector<Image> render(const StillLife& set, int count, const Shade& shade) {
  const int width = set.width();
  const int height = set.height();
  std::vector<Image> fine;
  fine.reserve(size_t(count));
  for (int i = 0; i < count; ++i) fine.emplace_back(ImageSpec::rgb(width, height), 0);
  parallelRows(height, 4, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < width; ++x) {
        const Ray ray = set.eyeRay(float(x) + .5F, float(y) + .5F);
        const auto at = set.hit(ray);
        if (!at) continue;
        std::array<Rgb, kMost> answer{};
        shade(*at, -ray.to, hash(uint32_t(y * width + x)), answer);
        for (size_t i = 0; i < fine.size(); ++i)
          for (int c = 0; c < 3; ++c) fine[i].span().at(c, x, y) = answer[i][c];
      }
  });
  std::vector<Image> pictures;
  pictures.reserve(fine.size());
  for (const Image& image : fine) pictures.push_back(halved(image));
  return pictures;
}

}  // namespace

std::vector<Image> renderBenchPicture(const BenchPicture& picture) {
  const StillLife set(picture);
  constexpr int kMostLights = 16;
  return render<kMostLights>(
      set, picture.lights,
      [&](const Hit& at, const Vec& toEye, uint32_t seed, std::array<Rgb, kMostLights>& answer) {
        for (int i = 0; i < picture.lights; ++i) answer[size_t(i)] = set.radiance(at, toEye, i, seed);
      });
}

Image renderBenchAmbient(const BenchPicture& picture, float level) {
  const StillLife set(picture);
  auto ambient = render<1>(set, 1, [&](const Hit& at, const Vec&, uint32_t, std::array<Rgb, 1>& answer) {
    answer[0] = level * set.openness(at) * at.albedo;
  });
  return std::move(ambient.front());
}

}  // namespace swaplight
