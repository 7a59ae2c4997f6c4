#include "core/image/io/image_input.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/color/chromaticities.h"
#include "core/image/io/header_oiio.h"
#include "core/image/io/image_format.h"
#include "core/image/io/tiff_layout.h"

namespace swaplight {
namespace {

constexpr int kMostParts = 4096;

/// Camera raw: linear numbers of the sensor, each channel as it is. Alpha: not multiplied in.
OIIO::ImageSpec readingHints() {
  OIIO::ImageSpec hints;
  hints.attribute("oiio:UnassociatedAlpha", 1);
  hints.attribute("raw:ColorSpace", "raw");
  hints.attribute("raw:use_camera_wb", 0);
  const std::array<float, 4> unit = {1, 1, 1, 1};
  hints.attribute("raw:user_mul", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 4), unit.data());
  hints.attribute("raw:auto_bright", 0);
  hints.attribute("raw:HighlightMode", 1);
  return hints;
}

bool hasPlainName(const std::string& part) {
  const std::array<const char*, 7> plain = {"", "rgb", "rgba", "main", "beauty", "RGB", "RGBA"};
  return std::find(plain.begin(), plain.end(), part) != plain.end();
}

/// The channels' names, with the part's name as layer where the file has several parts.
std::vector<std::string> channelNames(const OIIO::ImageSpec& spec, int index) {
  std::vector<std::string> names = spec.channelnames;
  const std::string part = spec.get_string_attribute("oiio:subimagename");
  if (index == 0 && hasPlainName(part)) return names;
  const std::string layer = (part.empty() ? fmt::format("part{}", index + 1) : part) + ".";
  for (std::string& name : names)
    if (!name.starts_with(layer)) name.insert(0, layer);
  return names;
}

std::optional<Chromaticities> statedChromaticities(const OIIO::ImageSpec& spec) {
  const auto* attribute = spec.find_attribute("chromaticities");
  if (!attribute || attribute->type() != OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8)) return std::nullopt;
  Chromaticities xy;
  std::copy_n(static_cast<const float*>(attribute->data()), xy.size(), xy.begin());
  return xy;
}

std::string colorSpaceOfFile(const OIIO::ImageSpec& spec, const std::string& format) {
  if (format == "raw") return "raw";
  const auto xy = statedChromaticities(spec);
  const std::string known = xy ? colorSpaceOf(*xy) : "";
  if (!known.empty()) return known;
  return spec.format.is_floating_point() ? "lin_rec709" : "srgb";
}

std::string statedColors(const OIIO::ImageSpec& spec) {
  if (const auto xy = statedChromaticities(spec)) {
    const std::string known = colorSpaceOf(*xy);
    return known.empty() ? fmt::format("primaries {:.4g}", fmt::join(*xy, " ")) : known;
  }
  const std::string profile = spec.get_string_attribute("ICCProfile:profile_description");
  return profile.empty() || lowerCase(profile).find("srgb") != std::string::npos
             ? ""
             : fmt::format("the profile \"{}\"", profile);
}

ImageFileInfo infoOf(const OIIO::ImageSpec& spec, const std::string& format) {
  ImageFileInfo info;
  info.format = format;
  const OIIO::TypeDesc type = spec.channelformat(0);
  info.pixelType = type.c_str();
  info.isFloat = type.is_floating_point();
  info.bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(type.size()) * 8);
  info.statedColors = statedColors(spec);
  info.header = headerValuesOf(spec);
  info.pixelAspect = spec.get_float_attribute("PixelAspectRatio", 1);
  for (const auto& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    if (attribute.type() == OIIO::TypeString)
      info.text[name] = attribute.get_string();
    else if (attribute.type().numelements() == 1 && attribute.type().aggregate == OIIO::TypeDesc::SCALAR)
      info.numbers[name] =
          attribute.type().is_floating_point() ? double{attribute.get_float()} : double(attribute.get_int());
  }
  return info;
}

/// A part's data window in the picture's pixels, where it is not the picture: smaller, or larger (overscan).
std::optional<PixelRect> otherWindow(const ImagePart& part, const ImageSpec& picture) {
  const PixelRect window{part.x, part.y, part.spec.width, part.spec.height};
  const bool whole = window == PixelRect{0, 0, picture.width, picture.height};
  return whole ? std::nullopt : std::optional(window);
}

/// Puts the data window of a part into the image's display window.
void place(ImagePart& part, const OIIO::ImageSpec& display, const ImageInput& input) {
  if (input.format() != "openexr") return;
  part.x = part.spec.x - display.full_x;
  part.y = part.spec.y - display.full_y;
  const bool apart = part.x >= display.full_width || part.y >= display.full_height ||
                     part.x + int64_t{part.spec.width} <= 0 || part.y + int64_t{part.spec.height} <= 0;
  if (apart) throw InputError("{}: its data window lies outside of its display window.", input.name());
}

/// The image is the display window: one that is huge around a little data makes a small file take all memory.
void checkDisplayWindow(const std::string& name, const ImageContents& contents) {
  constexpr double kMuch = double{1 << 30};  // bytes
  constexpr double kLargestShare = 64;       // of the data: a crop render leaves out less
  double data = 0;
  for (const ImagePart& part : contents.parts) data += double(part.spec.width) * part.spec.height;
  const double display = double(contents.spec.width) * contents.spec.height;
  if (4 * display * contents.spec.channelCount() > kMuch && display > kLargestShare * data)
    throw InputError(
        "{}: its display window of {} x {} pixels is far larger than what is in it ({} x {}). Crop the "
        "display window.",
        name, contents.spec.width, contents.spec.height, contents.parts.front().spec.width,
        contents.parts.front().spec.height);
}

}  // namespace

std::optional<PixelType> pixelTypeOf(const OIIO::TypeDesc& type) {
  switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
      return PixelType::UInt8;
    case OIIO::TypeDesc::UINT16:
      return PixelType::UInt16;
    case OIIO::TypeDesc::UINT32:
      return PixelType::UInt32;
    case OIIO::TypeDesc::HALF:
      return PixelType::Half;
    case OIIO::TypeDesc::FLOAT:
      return PixelType::Float;
    default:
      return std::nullopt;
  }
}

ImageContents contentsOf(ImageInput& input) {
  ImageContents contents;
  const bool layered = input.format() == "openexr";
  for (int index = 0; index < (layered ? kMostParts : 1); ++index) {
    OIIO::ImageSpec spec = input->spec_dimensions(index);
    if (spec.undefined()) break;
    spec = input->spec(index);
    if (spec.deep) throw InputError("{}: is a deep picture. Flatten it first.", input.name());
    if (input.format() == "tiff") checkTiffLayout(input.name(), spec);
    ImagePart part{spec, index, 0, 0, spec.channelnames};
    if (layered) part.channels = channelNames(spec, index);
    if (index == 0) {
      contents.info = infoOf(spec, input.format());
      // OpenEXR and camera raw come upright.
      const bool asHeld = input.format() == "jpeg" || input.format() == "tiff" || input.format() == "png";
      if (asHeld) contents.orientation = spec.get_int_attribute("Orientation", 1);
      contents.spec = {layered ? spec.full_width : spec.width,
                       layered ? spec.full_height : spec.height,
                       {},
                       colorSpaceOfFile(spec, input.format())};
    }
    checkImageSides(input.name(), spec.width, spec.height, spec.nchannels);
    contents.spec.channels.insert(contents.spec.channels.end(), part.channels.begin(), part.channels.end());
    checkImageSides(input.name(), contents.spec.width, contents.spec.height, contents.spec.channelCount());
    place(part, contents.parts.empty() ? spec : contents.parts.front().spec, input);
    for (int c = 0; c < spec.nchannels; ++c)
      contents.info.channelTypes.push_back(pixelTypeOf(spec.channelformat(c)).value_or(PixelType::Float));
    if (index == 0) contents.info.dataWindow = otherWindow(part, contents.spec);
    contents.parts.push_back(std::move(part));
  }
  (void)input->geterror();  // of the part behind the last
  if (contents.parts.empty()) input.fail("it has no picture in it");
  checkDisplayWindow(input.name(), contents);
  contents.info.parts = static_cast<int>(contents.parts.size());
  return contents;
}

ImageInput::ImageInput(const std::filesystem::path& file)
    : m_file(file), m_format(imageFormatOf(file)), m_input(OIIO::ImageInput::create(m_format)) {
  if (!m_input && m_format == "raw")
    throw InputError(
        "{}: camera raw cannot be read here: OpenImageIO was built without LibRaw. Develop the "
        "photographs to 16-bit TIFF or EXR with a linear curve, all with the same white balance.",
        name());
  if (!m_input) fail(OIIO::geterror());
  checkIntegrity(file, m_format);
  OIIO::attribute("debug", 0);  // it prints
  OIIO::ImageSpec first;
  if (!m_input->open(file.string(), first, readingHints())) fail();
}

ImageInput::~ImageInput() {
  if (!m_input) return;
  m_input->close();
  (void)m_input->geterror();
  (void)OIIO::geterror();
}

void ImageInput::fail(std::string words) const {
  words = words.substr(0, words.find('\n'));
  throw InputError("{}: damaged or not a valid {} file: {}", name(), m_format,
                   words.empty() ? "it cannot be read" : words);
}

}  // namespace swaplight
