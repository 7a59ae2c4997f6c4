#include "core/edit/shapes/key_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/color/srgb.h"
#include "core/edit/fields/field_json.h"
#include "core/ocio/chosen_config.h"

namespace swaplight {
namespace {

constexpr float kLeastRamp = .001f;  // as the filters have it: a matte without a ramp is a step
constexpr double kMostFactor = 1e6;
constexpr const char* kCodesSpace = "lin_rec709";  // what the sRGB codes are of

/// Adds a light's rows from `top` on to as many as the band has.
void addRows(const Image& light, int top, const Rgb& factor, ImageSpan band) {
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < band.height; ++y) {
      const float* in = light.view().row(c, top + y);
      float* out = band.row(c, y);
      for (int x = 0; x < band.width; ++x) out[x] += factor[c] * in[x];
    }
}

/// Rows of the set as it is lit, in linear Rec.709.
Image litRows(const KeyShape& key, const SolvedSet& set, int top, int rows) {
  Image band(ImageSpec::rgb(set.width(), rows), 0.0f);
  for (size_t i = 0; i < set.contributions.size(); ++i) {
    const auto factor = key.lights.find(set.capture.lights[i].name);
    addRows(set.contributions[i], top, factor == key.lights.end() ? Rgb(1) : factor->second, band.span());
  }
  if (set.ambient) addRows(*set.ambient, top, Rgb(key.ambient), band.span());
  if (set.colorSpace() != kCodesSpace) sessionConfig({})->convert(band.span(), set.colorSpace(), kCodesSpace);
  return band;
}

float lumaOf(const Rgb& codes) {
  return .299f * codes.r + .587f * codes.g + .114f * codes.b;
}

/// Cb and Cr of BT.601, -0.5 to 0.5.
std::array<float, 2> chromaOf(const Rgb& codes) {
  const float y = lumaOf(codes);
  return {(codes.b - y) / 1.772f, (codes.r - y) / 1.402f};
}

float matteOf(const KeyShape& key, const Rgb& codes) {
  if (key.by == KeyShape::By::Luma) {
    const float high = std::max(key.to, key.from + kLeastRamp);
    const float t = std::clamp((lumaOf(codes) - key.from) / (high - key.from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
  }
  const auto here = chromaOf(codes), screen = chromaOf(key.color);
  const float far = std::hypot(here[0] - screen[0], here[1] - screen[1]);
  return std::clamp((far - key.from) / std::max(key.to - key.from, kLeastRamp), 0.0f, 1.0f);
}

}  // namespace

void KeyShape::writeMore(Json& json) const {
  if (!lights.empty())
    for (const auto& [name, factor] : lights) json["lights"][name] = jsonFromValue(factor);
  if (ambient != 1) json["ambient"] = jsonFromValue(ambient);
}

void KeyShape::readMore(JsonFields& fields, int /*width*/, int /*height*/) {
  ambient = static_cast<float>(fields.number("ambient", 0, kMostFactor).value_or(1));
  const Json* factors = fields.find("lights");
  if (!factors) return;
  if (!factors->is_object())
    throw InputError("{}: \"lights\" is {}, expected an object {{\"key\": [1, 1, 1], ...}}.", fields.where(),
                     describeJson(*factors));
  JsonFields named(*factors, fields.where() + ": lights");
  for (const auto& [name, value] : factors->items()) {
    Rgb factor(1);
    readValue(named, name.c_str(), {Scale::Unit::Factor, 0, kMostFactor, 0, 1}, factor);
    lights[name] = factor;
  }
}

void KeyShape::check(const std::string& where) const {
  const auto within = [](const Rgb& rgb, double most) {
    return std::min({rgb.r, rgb.g, rgb.b}) >= 0 &&
           std::max({rgb.r, rgb.g, rgb.b}) <= static_cast<float>(most);
  };
  if (!within(color, 1))
    throw InputError("{}: \"color\" is {} {} {}, expected sRGB codes from 0 to 1.", where, color.r, color.g,
                     color.b);
  for (const auto& [name, factor] : lights)
    if (!within(factor, kMostFactor))
      throw InputError("{}: \"lights\": {} is {} {} {}, expected factors from 0 to {}.", where, name,
                       factor.r, factor.g, factor.b, kMostFactor);
}

MaskRaster KeyShape::draw(const SolvedSet& set) const {
  MaskRaster raster(set.width(), set.height());
  std::vector<float> row(static_cast<size_t>(set.width()));
  for (int top = 0; top < set.height(); top += kMaskTile) {
    const Image band = litRows(*this, set, top, std::min(kMaskTile, set.height() - top));
    for (int y = 0; y < band.height(); ++y) {
      for (int x = 0; x < band.width(); ++x) {
        Rgb codes;
        for (int c = 0; c < 3; ++c)
          codes[c] = srgbFromLinear(std::clamp(band.view().at(c, x, y), 0.0f, 1.0f));
        row[static_cast<size_t>(x)] = matteOf(*this, codes);
      }
      raster.writeRow(0, top + y, band.width(), row.data());
    }
  }
  return raster;
}

}  // namespace swaplight
