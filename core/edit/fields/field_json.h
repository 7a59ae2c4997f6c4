#pragma once

#include <string>

#include "core/base/json.h"
#include "core/color/rgb.h"
#include "core/edit/fields/field.h"
#include "core/file/json_fields.h"

namespace swaplight {

// A value in a file. Reading leaves the value as it is where the file does not have it (but points have to be
// there), and throws InputError that says where, what was found and what was expected.

[[nodiscard]] Json jsonFromValue(float value);
[[nodiscard]] Json jsonFromValue(int value);
[[nodiscard]] Json jsonFromValue(const std::string& value);
[[nodiscard]] Json jsonFromValue(const PointList& points);
[[nodiscard]] Json jsonFromValue(const Rgb& color);

void readValue(JsonFields& fields, const char* key, const Scale& scale, float& value);
void readValue(JsonFields& fields, const char* key, const Scale& scale, int& value);
void readValue(JsonFields& fields, const char* key, const Scale& scale, std::string& value);
void readValue(JsonFields& fields, const char* key, const Scale& scale, PointList& points);
void readValue(JsonFields& fields, const char* key, const Scale& scale, Rgb& color);

/// The place of a name in a list of names; `otherwise` where the file has none.
[[nodiscard]] size_t choiceFromJson(JsonFields& fields, const char* key, std::span<const char* const> names,
                                    size_t otherwise = 0);

/// [x, y]
[[nodiscard]] std::array<float, 2> pairFromJson(const Json& json, const std::string& where);
/// A pixel [x, y], of the picture or not, within a million of its corner; fractions are cut off. Throws
/// InputError that begins with `where`.
[[nodiscard]] std::array<int, 2> pixelFromJson(const Json& json, const std::string& where);

/// Adds the fields of an edit or a shape to `json`.
template <typename Owner>
void writeFields(const Owner& owner, Json& json) {
  forEachField(owner, [&](const auto& field, const auto& value) {
    if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>)
      json[field.key] = field.choices[static_cast<size_t>(value)];
    else
      json[field.key] = jsonFromValue(value);
  });
}

/// Reads them.
template <typename Owner>
void readFields(JsonFields& fields, Owner& owner) {
  forEachField(owner, [&](const auto& field, auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_enum_v<Value>)
      value =
          static_cast<Value>(choiceFromJson(fields, field.key, field.choices, static_cast<size_t>(value)));
    else
      readValue(fields, field.key, field.scale, value);
  });
}

}  // namespace swaplight
