#include "core/image/exr/exr_header.h"
#include "core/base/version.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace swaplight {
namespace {

using Kind = HeaderValue::Kind;

/// OpenEXR's standard attributes that OpenImageIO calls otherwise.
std::string exrName(const std::string& name) {
  struct Name {
    std::string_view oiio, exr;
  };
  constexpr std::array<Name, 14> kNames = {{{"DateTime", "capDate"},
                                            {"Copyright", "owner"},
                                            {"ImageDescription", "comments"},
                                            {"XResolution", "xDensity"},
                                            {"ExposureTime", "expTime"},
                                            {"FNumber", "aperture"},
                                            {"Exif:PhotographicSensitivity", "isoSpeed"},
                                            {"Exif:ISOSpeedRatings", "isoSpeed"},
                                            {"smpte:TimeCode", "timeCode"},
                                            {"smpte:KeyCode", "keyCode"},
                                            {"FramesPerSecond", "framesPerSecond"},
                                            {"worldtocamera", "worldToCamera"},
                                            {"worldtoscreen", "worldToNDC"},
                                            {"SubjectDistance", "focus"}}};
  for (const Name& known : kNames)
    if (known.oiio == name) return std::string(known.exr);
  return name;
}

bool isScreenWindow(const std::string& name) {
  return name == "screenWindowCenter" || name == "screenWindowWidth";
}

exr_result_t setIntegers(exr_context_t exr, int part, const char* name, const HeaderValue& value) {
  const std::vector<int>& n = value.integers;
  if (value.kind == Kind::Rational && n.size() == 2) {
    const exr_attr_rational_t rational{n[0], static_cast<uint32_t>(n[1])};
    return exr_attr_set_rational(exr, part, name, &rational);
  }
  if (value.kind == Kind::Timecode && n.size() == 2) {
    const exr_attr_timecode_t timecode{static_cast<uint32_t>(n[0]), static_cast<uint32_t>(n[1])};
    return exr_attr_set_timecode(exr, part, name, &timecode);
  }
  if (value.kind == Kind::Keycode && n.size() == 7) {
    const exr_attr_keycode_t keycode{n[0], n[1], n[2], n[3], n[4], n[5], n[6]};
    return exr_attr_set_keycode(exr, part, name, &keycode);
  }
  if (n.size() == 1) return exr_attr_set_int(exr, part, name, n[0]);
  if (n.size() == 2) {
    const exr_attr_v2i_t pair{{{n[0], n[1]}}};
    return exr_attr_set_v2i(exr, part, name, &pair);
  }
  const exr_attr_v3i_t triple{{{n[0], n[1], n[2]}}};
  return exr_attr_set_v3i(exr, part, name, &triple);
}

exr_result_t setFloats(exr_context_t exr, int part, const char* name, const std::vector<float>& n) {
  if (n.size() == 1) return exr_attr_set_float(exr, part, name, n[0]);
  if (n.size() == 2) {
    const exr_attr_v2f_t pair{{{n[0], n[1]}}};
    return exr_attr_set_v2f(exr, part, name, &pair);
  }
  if (n.size() == 3) {
    const exr_attr_v3f_t triple{{{n[0], n[1], n[2]}}};
    return exr_attr_set_v3f(exr, part, name, &triple);
  }
  if (n.size() == 9) {
    exr_attr_m33f_t matrix;
    std::copy(n.begin(), n.end(), matrix.m);
    return exr_attr_set_m33f(exr, part, name, &matrix);
  }
  exr_attr_m44f_t matrix;
  std::copy(n.begin(), n.end(), matrix.m);
  return exr_attr_set_m44f(exr, part, name, &matrix);
}

exr_result_t setValue(exr_context_t exr, int part, const std::string& name, const HeaderValue& value) {
  if (value.kind == Kind::Text) return exr_attr_set_string(exr, part, name.c_str(), value.text.c_str());
  if (value.kind == Kind::Floats) return setFloats(exr, part, name.c_str(), value.floats);
  return setIntegers(exr, part, name.c_str(), value);
}

}  // namespace

exr_result_t setExrWindows(exr_context_t exr, int part, const FileToWrite& contents,
                           exr_compression_t compression) {
  const PixelRect data = contents.window();
  const exr_attr_box2i_t display{{{{0, 0}}}, {{{contents.width - 1, contents.height - 1}}}};
  const exr_attr_box2i_t window{{{{data.x, data.y}}}, {{{data.right() - 1, data.bottom() - 1}}}};
  exr_attr_v2f_t center{{{0, 0}}};
  float width = 1;
  const auto carried = [&](const char* name, size_t count) {
    const auto found = contents.header.find(name);
    const bool fits = found != contents.header.end() && found->second.floats.size() == count;
    return fits ? found->second.floats.data() : nullptr;
  };
  if (const float* xy = carried("screenWindowCenter", 2)) center = {{{xy[0], xy[1]}}};
  if (const float* value = carried("screenWindowWidth", 1)) width = *value;
  return exr_initialize_required_attr(exr, part, &display, &window, contents.pixelAspect, &center, width,
                                      EXR_LINEORDER_INCREASING_Y, compression);
}

exr_result_t setExrValues(exr_context_t exr, int part, const FileToWrite& contents) {
  std::map<std::string, HeaderValue> values;  // by name, so that the same contents give the same bytes
  for (const auto& [name, text] : contents.text) values[exrName(name)].text = text;
  for (const auto& [name, value] : contents.header)
    if (!isScreenWindow(name)) values.emplace(exrName(name), value);
  values.try_emplace("Software").first->second.text = std::string("swaplight ") + version();
  for (const auto& [name, value] : values) {
    const exr_result_t result = setValue(exr, part, name, value);
    // A standard name with a value of another type is left out: it would make the file unreadable to others.
    if (result != EXR_ERR_SUCCESS && result != EXR_ERR_ATTR_TYPE_MISMATCH) return result;
  }
  return EXR_ERR_SUCCESS;
}

}  // namespace swaplight
