#pragma once

#include <map>
#include <string>
#include <vector>

namespace swaplight {

/// A value of a picture's header, of the kinds that cameras and compositors write.
struct HeaderValue {
  enum class Kind {
    Text,
    Integers,  ///< 1, 2 or 3
    Floats,    ///< 1, 2, 3, or a matrix of 9 or 16
    Rational,  ///< 2 integers: numerator, denominator
    Timecode,  ///< 2 integers: SMPTE 12M time and flags, user data
    Keycode,   ///< 7 integers: SMPTE 254
  };
  Kind kind = Kind::Text;
  std::string text;
  std::vector<int> integers;
  std::vector<float> floats;
  bool operator==(const HeaderValue&) const = default;
};

/// By name, as OpenImageIO calls them (smpte:TimeCode, ExposureTime, DateTime ...).
using HeaderValues = std::map<std::string, HeaderValue>;

}  // namespace swaplight
