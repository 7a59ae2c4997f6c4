#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/base/progress.h"
#include "core/capture/capture.h"
#include "core/capture/smooth_field.h"

namespace swaplight {

class JsonFields;

/// Pictures of an even grey surface, by which uneven lamps and lenses are put right. A capture keeps their
/// names among what it carries along: "flats" of all shots, or of one, where another gel has another field;
/// "vignetting".
struct FlatNames {
  std::map<std::string, std::string> lamps;               ///< light: its picture, lit by it alone
  std::vector<std::map<std::string, std::string>> shots;  ///< of one shot, instead; may be shorter
  std::optional<std::string> lens;                        ///< an evenly lit surface

  [[nodiscard]] bool empty() const { return lamps.empty() && shots.empty() && !lens; }
};

[[nodiscard]] FlatNames flatNamesOf(const Capture& capture);
/// The capture with these for all of its shots, beside those that it has. Throws InputError: no such light.
[[nodiscard]] Capture withFlats(Capture capture, const std::map<std::string, std::string>& lamps,
                                const std::string& lens);
/// The capture, these shots left out, without flat pictures of lights that it does not have, or that are not
/// in its folder.
[[nodiscard]] Capture withoutLostFlats(Capture capture, std::vector<Shot> leftOut);
/// What a manifest says of them, checked, to be carried along: an object, empty where it says nothing.
[[nodiscard]] Json flatsFromJson(JsonFields& fields, const std::vector<Light>& lights);

/// How the lamps and the lens change over the picture.
struct FlatFields {
  /// [shot][light]: the lamp's colour over its mean; empty: all are even.
  std::vector<std::vector<std::optional<SmoothField>>> lamps;
  std::optional<SmoothField> lens;    ///< what arrives of the light: 1 in the brightest place
  std::vector<std::string> warnings;  ///< pictures that are not even

  [[nodiscard]] bool empty() const { return lamps.empty() && !lens; }
  /// As SmoothField::within.
  [[nodiscard]] FlatFields within(const PixelRect& part, int width, int height) const;
};

/// Reads a capture's flat pictures, which are coded, cropped and scaled as its shots are. Throws InputError
/// as loadCapturePixels and colorFieldOf do, and where one has another size than the first shot.
[[nodiscard]] FlatFields loadFlatFields(const ColorConfig& config, const Capture& capture,
                                        const Progress& progress = {});

}  // namespace swaplight
