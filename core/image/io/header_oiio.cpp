#include "core/image/io/header_oiio.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace swaplight {
namespace {

using Kind = HeaderValue::Kind;

/// About the file as it was written, or said otherwise by our own headers.
bool isAboutTheFile(std::string_view name) {
  const std::array<std::string_view, 12> names = {
      "PixelAspectRatio", "chromaticities", "compression", "Orientation",
      "Software",         "ICCProfile",     "name",        "type",
      "version",          "chunkCount",     "lineOrder",   "ResolutionUnit"};
  const std::array<std::string_view, 10> prefixes = {"oiio:", "openexr:",    "swaplight/", "ICCProfile:",
                                                     "jpeg:", "png:",        "tiff:",      "thumbnail",
                                                     "IPTC:", "planarconfig"};
  return std::find(names.begin(), names.end(), name) != names.end() ||
         std::any_of(prefixes.begin(), prefixes.end(), [&](auto prefix) { return name.starts_with(prefix); });
}

std::optional<HeaderValue> valueOf(const OIIO::ParamValue& attribute) {
  const OIIO::TypeDesc type = attribute.type();
  const size_t count = type.numelements() * static_cast<size_t>(type.aggregate);
  HeaderValue value;
  if (type == OIIO::TypeString) {
    value.text = attribute.get_string(0);
    return value;
  }
  const bool isInteger = type.basetype == OIIO::TypeDesc::INT || type.basetype == OIIO::TypeDesc::UINT;
  if (isInteger && count <= 7) {
    const auto* numbers = static_cast<const int*>(attribute.data());
    value.integers.assign(numbers, numbers + count);
    value.kind = type.vecsemantics == OIIO::TypeDesc::RATIONAL   ? Kind::Rational
                 : type.vecsemantics == OIIO::TypeDesc::TIMECODE ? Kind::Timecode
                 : type.vecsemantics == OIIO::TypeDesc::KEYCODE  ? Kind::Keycode
                                                                 : Kind::Integers;
    if (value.kind == Kind::Integers && count > 3) return std::nullopt;
    return value;
  }
  const bool knownCount = count <= 3 || count == 9 || count == 16;
  if (type.basetype != OIIO::TypeDesc::FLOAT || !knownCount) return std::nullopt;
  const auto* numbers = static_cast<const float*>(attribute.data());
  value.floats.assign(numbers, numbers + count);
  value.kind = Kind::Floats;
  return value;
}

OIIO::TypeDesc typeOf(const HeaderValue& value) {
  using OIIO::TypeDesc;
  const size_t count = value.kind == Kind::Floats ? value.floats.size() : value.integers.size();
  const auto aggregate = count == 2    ? TypeDesc::VEC2
                         : count == 3  ? TypeDesc::VEC3
                         : count == 9  ? TypeDesc::MATRIX33
                         : count == 16 ? TypeDesc::MATRIX44
                                       : TypeDesc::SCALAR;
  switch (value.kind) {
    case Kind::Text:
      return OIIO::TypeString;
    case Kind::Rational:
      return OIIO::TypeRational;
    case Kind::Timecode:
      return OIIO::TypeTimeCode;
    case Kind::Keycode:
      return OIIO::TypeKeyCode;
    case Kind::Integers:
      return {TypeDesc::INT, aggregate};
    case Kind::Floats:
      return {TypeDesc::FLOAT, aggregate};
  }
  return OIIO::TypeUnknown;
}

}  // namespace

HeaderValues headerValuesOf(const OIIO::ImageSpec& spec) {
  HeaderValues values;
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    if (isAboutTheFile(name)) continue;
    if (auto value = valueOf(attribute)) values[name] = std::move(*value);
  }
  return values;
}

void addHeaderValues(OIIO::ImageSpec& spec, const HeaderValues& values) {
  for (const auto& [name, value] : values) {
    if (spec.find_attribute(name)) continue;
    if (value.kind == Kind::Text)
      spec.attribute(name, value.text);
    else if (value.kind == Kind::Floats)
      spec.attribute(name, typeOf(value), value.floats.data());
    else
      spec.attribute(name, typeOf(value), value.integers.data());
  }
}

}  // namespace swaplight
