#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/color/chromaticities.h"
#include "core/error.h"
#include "core/image/exr_file.h"
#include "core/image/image_format.h"
#include "core/image/image_io.h"
#include "core/image/orientation.h"
#include "core/image/pixel_pack.h"

namespace swaplight {
namespace {

constexpr int kMostParts = 4096;
constexpr size_t kBandBytes = size_t{32} << 20;

/// An open file. Fetches every error message of OpenImageIO, which would otherwise print it.
class Input {
 public:
  explicit Input(const std::filesystem::path& file)
      : m_file(file), m_format(imageFormatOf(file)), m_input(OIIO::ImageInput::create(m_format)) {
    if (!m_input) fail(OIIO::geterror());
    checkIntegrity(file, m_format);
    OIIO::attribute("debug", 0);  // it prints
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    hints.attribute("raw:ColorSpace", "raw");
    hints.attribute("raw:use_camera_wb", 0);
    const std::array<float, 4> unit = {1, 1, 1, 1};
    hints.attribute("raw:user_mul", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 4), unit.data());
    hints.attribute("raw:auto_bright", 0);
    hints.attribute("raw:HighlightMode", 1);
    OIIO::ImageSpec first;
    if (!m_input->open(file.string(), first, hints)) fail(m_input->geterror());
  }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  ~Input() {
    if (!m_input) return;
    m_input->close();
    (void)m_input->geterror();
    (void)OIIO::geterror();
  }

  [[nodiscard]] const std::string& format() const { return m_format; }
  [[nodiscard]] std::string name() const { return m_file.string(); }
  OIIO::ImageInput* operator->() { return m_input.get(); }

  /// Throws the first line of OpenImageIO's words.
  [[noreturn]] void fail(std::string words) const {
    words = words.substr(0, words.find('\n'));
    throw InputError("{}: is broken or no {} file: {}", name(), m_format,
                     words.empty() ? "it cannot be read" : words);
  }
  [[noreturn]] void fail() { fail(m_input->geterror()); }

 private:
  std::filesystem::path m_file;
  std::string m_format;
  std::unique_ptr<OIIO::ImageInput> m_input;
};

/// A part of the file, and where its pixels belong in the image.
struct Part {
  OIIO::ImageSpec spec;
  int index = 0;
  int x = 0, y = 0;  ///< of the data window in the display window
  std::vector<std::string> channels;
};

/// All the parts that make up one image.
struct Contents {
  ImageSpec spec;  ///< as stored
  int orientation = 1;
  ImageFileInfo info;
  std::vector<Part> parts;
};

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

std::string colorSpaceOfFile(const OIIO::ImageSpec& spec, const std::string& format) {
  if (format == "raw") return "raw";
  const auto* attribute = spec.find_attribute("chromaticities");
  if (attribute && attribute->type() == OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8)) {
    Chromaticities xy;
    std::copy_n(static_cast<const float*>(attribute->data()), xy.size(), xy.begin());
    if (const std::string known = colorSpaceOf(xy); !known.empty()) return known;
  }
  return spec.format.is_floating_point() ? "lin_rec709" : "srgb";
}

ImageFileInfo infoOf(const OIIO::ImageSpec& spec, const std::string& format) {
  ImageFileInfo info;
  info.format = format;
  const OIIO::TypeDesc type = spec.channelformat(0);
  info.pixelType = type.c_str();
  info.isFloat = type.is_floating_point();
  info.bits = spec.get_int_attribute("oiio:BitsPerSample", static_cast<int>(type.size()) * 8);
  for (const auto& attribute : spec.extra_attribs)
    if (attribute.type() == OIIO::TypeString) info.text[attribute.name().string()] = attribute.get_string();
  return info;
}

/// Puts the data window of a part into the image's display window.
void place(Part& part, const OIIO::ImageSpec& display, const Input& input) {
  if (input.format() != "openexr") return;
  part.x = part.spec.x - display.full_x;
  part.y = part.spec.y - display.full_y;
  const bool apart = part.x >= display.full_width || part.y >= display.full_height ||
                     part.x + int64_t{part.spec.width} <= 0 || part.y + int64_t{part.spec.height} <= 0;
  if (apart) throw InputError("{}: its data window lies outside of its display window.", input.name());
}

Contents contentsOf(Input& input) {
  Contents contents;
  const bool layered = input.format() == "openexr";
  for (int index = 0; index < (layered ? kMostParts : 1); ++index) {
    OIIO::ImageSpec spec = input->spec_dimensions(index);
    if (spec.undefined()) break;
    spec = input->spec(index);
    if (spec.deep) throw InputError("{}: is a deep picture. Flatten it first.", input.name());
    Part part{spec, index, 0, 0, spec.channelnames};
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
    checkImageFits(input.name(), spec.width, spec.height, spec.nchannels);
    contents.spec.channels.insert(contents.spec.channels.end(), part.channels.begin(), part.channels.end());
    checkImageFits(input.name(), contents.spec.width, contents.spec.height, contents.spec.channelCount());
    place(part, contents.parts.empty() ? spec : contents.parts.front().spec, input);
    contents.parts.push_back(std::move(part));
  }
  (void)input->geterror();  // of the part behind the last
  if (contents.parts.empty()) input.fail("it has no picture in it");
  contents.info.parts = static_cast<int>(contents.parts.size());
  return contents;
}

std::optional<PixelType> pixelTypeOf(OIIO::TypeDesc type) {
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

/// The types to ask for: as stored where we unpack them ourselves, else float; `asked` is what OpenImageIO is
/// told.
PackedLayout layoutOf(const OIIO::ImageSpec& spec, OIIO::TypeDesc& asked) {
  std::vector<PixelType> types;
  asked = OIIO::TypeUnknown;  // as stored
  for (int c = 0; c < spec.nchannels; ++c) {
    const auto type = pixelTypeOf(spec.channelformat(c));
    if (!type) asked = OIIO::TypeFloat;
    types.push_back(type.value_or(PixelType::Float));
  }
  if (asked == OIIO::TypeFloat) std::fill(types.begin(), types.end(), PixelType::Float);
  return PackedLayout(std::move(types));
}

/// Where a part's pixels go: planes of the image's size.
struct PartTarget {
  std::span<float* const> planes;
  int width = 0;
  int height = 0;
};

/// Unpacks rows y..y+rows of a part's data window into the display window.
void unpackBand(const Part& part, int y, int rows, const PackedLayout& layout, const std::byte* band,
                const PartTarget& target) {
  const int top = std::max(0, part.y + y);
  const int bottom = std::min(target.height, part.y + y + rows);
  const int left = std::max(0, part.x);
  const int right = std::min(target.width, part.x + part.spec.width);
  if (top >= bottom || left >= right) return;
  const ptrdiff_t first = ptrdiff_t{top} * target.width + left;
  std::vector<float*> planes(target.planes.begin(), target.planes.end());
  for (float*& plane : planes)
    if (plane) plane += first;
  const size_t skippedRows = static_cast<size_t>(top - (part.y + y));
  const size_t rowBytes = layout.pixelBytes * static_cast<size_t>(part.spec.width);
  unpackPixels(band + skippedRows * rowBytes, layout, part.spec.width, left - part.x,
               {planes, target.width, right - left, bottom - top});
}

/// Reads a part band by band: big enough that the decoder's threads have work, small enough for the memory.
void readPart(Input& input, const Part& part, const PartTarget& target,
              const std::function<void(int rows)>& done) {
  const OIIO::ImageSpec& spec = part.spec;
  OIIO::TypeDesc asked;
  const PackedLayout layout = layoutOf(spec, asked);
  const int step = spec.tile_height > 0 ? spec.tile_height : 16;
  const size_t rowBytes = layout.pixelBytes * static_cast<size_t>(spec.width);
  const int bandRows =
      step * std::max(1, static_cast<int>(kBandBytes / (rowBytes * static_cast<size_t>(step))));
  std::vector<std::byte> band(rowBytes * static_cast<size_t>(std::min(bandRows, spec.height)));
  for (int y = 0; y < spec.height; y += bandRows) {
    const int rows = std::min(bandRows, spec.height - y);
    const int first = spec.y + y;
    const bool read = spec.tile_width > 0
                          ? input->read_tiles(part.index, 0, spec.x, spec.x + spec.width, first, first + rows,
                                              spec.z, spec.z + 1, 0, spec.nchannels, asked, band.data())
                          : input->read_scanlines(part.index, 0, first, first + rows, spec.z, 0,
                                                  spec.nchannels, asked, band.data());
    if (!read || input->has_error()) input.fail();  // a truncated TIFF succeeds with an error
    unpackBand(part, y, rows, layout, band.data(), target);
    done(rows);
  }
}

bool coversImage(const Part& part, const ImageSpec& spec) {
  return part.x <= 0 && part.y <= 0 && part.x + int64_t{part.spec.width} >= spec.width &&
         part.y + int64_t{part.spec.height} >= spec.height;
}

bool fillsImage(const Part& part, const ImageSpec& spec) {
  return part.x == 0 && part.y == 0 && part.spec.width == spec.width && part.spec.height == spec.height;
}

void readParts(Input& input, const Contents& contents, std::span<float* const> planes,
               const Progress& progress) {
  const ImageSpec& spec = contents.spec;
  int64_t total = 0;
  for (const Part& part : contents.parts) total += part.spec.height;
  int64_t read = 0;
  size_t channel = 0;
  std::optional<ExrZipReader> exr;
  if (input.format() == "openexr") exr.emplace(input.name());
  for (const Part& part : contents.parts) {
    const PartTarget target{planes.subspan(channel, part.channels.size()), spec.width, spec.height};
    channel += part.channels.size();
    if (!coversImage(part, spec))
      for (float* plane : target.planes)
        if (plane) std::fill_n(plane, spec.pixelCount(), 0.0F);
    const auto done = [&](int rows) {
      read += rows;
      progress.update(static_cast<float>(read) / static_cast<float>(total), "reading");
    };
    const std::vector<std::string>& names = part.spec.channelnames;
    if (exr && fillsImage(part, spec) && exr->canRead(part.index, names, spec.width, spec.height))
      exr->read(part.index, names, target.planes, done);
    else
      readPart(input, part, target, done);
  }
}

}  // namespace

ImageSpec readImageSpec(const std::filesystem::path& file, ImageFileInfo* info) {
  Input input(file);
  Contents contents = contentsOf(input);
  if (info) *info = std::move(contents.info);
  if (turnsBySide(contents.orientation)) std::swap(contents.spec.width, contents.spec.height);
  return contents.spec;
}

void readChannels(const std::filesystem::path& file,
                  const std::function<std::vector<float*>(const ImageSpec&, const ImageFileInfo&)>& planes,
                  const Progress& progress) {
  Input input(file);
  const Contents contents = contentsOf(input);
  readParts(input, contents, planes(contents.spec, contents.info), progress);
}

ImageFile readImage(const std::filesystem::path& file) {
  Input input(file);
  Contents contents = contentsOf(input);
  Image image(contents.spec);
  std::vector<float*> planes;
  for (int c = 0; c < image.channelCount(); ++c) planes.push_back(image.plane(c));
  readParts(input, contents, planes, {});
  return {uprightImage(std::move(image), contents.orientation), std::move(contents.info)};
}

}  // namespace swaplight
