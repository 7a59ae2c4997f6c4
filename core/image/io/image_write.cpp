#include "core/image/io/image_write.h"

#include <OpenImageIO/imageio.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/version.h"
#include "core/file/atomic_file.h"
#include "core/image/exr/exr_file.h"
#include "core/image/io/carried_data.h"
#include "core/image/io/file_proxy.h"
#include "core/image/io/header_oiio.h"
#include "core/image/io/image_format.h"
#include "core/image/io/image_io.h"
#include "core/image/io/image_write_progress.h"
#include "core/image/io/memory_file.h"

namespace swaplight {
namespace {

constexpr size_t kBandBytes = size_t{32} << 20;
constexpr int kPngLevel = 4;  // of 9: the usual 6 takes three times as long for a twentieth less

OIIO::TypeDesc oiioType(PixelType type) {
  return OIIO::TypeDesc(pixelTypeName(type));
}

std::vector<PixelType> typesOf(const PartToWrite& part) {
  std::vector<PixelType> types;
  for (const ChannelToWrite& channel : part.channels) types.push_back(channel.type);
  return types;
}

void setWindows(OIIO::ImageSpec& spec, const FileToWrite& contents) {
  const PixelRect window = contents.window();
  spec.full_x = spec.full_y = 0;
  spec.full_width = contents.width;
  spec.full_height = contents.height;
  spec.x = window.x;
  spec.y = window.y;
  spec.width = window.width;
  spec.height = window.height;
}

OIIO::ImageSpec specOf(const FileToWrite& contents, const PartToWrite& part, const std::string& format) {
  OIIO::ImageSpec spec(contents.width, contents.height, static_cast<int>(part.channels.size()),
                       oiioType(part.channels.front().type));
  spec.channelnames.clear();
  for (const ChannelToWrite& channel : part.channels) {
    spec.channelnames.push_back(channel.name);
    spec.channelformats.push_back(oiioType(channel.type));
  }
  const auto sameType = [&](const OIIO::TypeDesc& type) { return type == spec.format; };
  if (std::all_of(spec.channelformats.begin(), spec.channelformats.end(), sameType))
    spec.channelformats.clear();
  // Alpha is written as it is.
  const auto alpha = std::find(spec.channelnames.begin(), spec.channelnames.end(), "A");
  if (alpha != spec.channelnames.end())
    spec.alpha_channel = static_cast<int>(alpha - spec.channelnames.begin());
  if (format != "openexr") spec.attribute("oiio:UnassociatedAlpha", 1);

  if (!part.name.empty()) spec.attribute("oiio:subimagename", part.name);
  if (contents.colorSpace == "srgb") spec.attribute("oiio:ColorSpace", "sRGB");
  if (const auto xy = contents.saidChromaticities(); xy && format == "openexr")
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), xy->data());
  if (format == "jpeg") {
    spec.attribute("compression", fmt::format("jpeg:{}", contents.jpegQuality));
    spec.attribute("jpeg:subsampling", "4:4:4");
  } else if (format == "openexr" || format == "tiff") {
    spec.attribute("compression", contents.compression.empty() ? "zip" : contents.compression);
  } else if (format == "png") {
    spec.attribute("png:compressionLevel", kPngLevel);
  }
  spec.attribute("Software", std::string("swaplight ") + version());
  if (&part == contents.parts.data())
    for (const auto& [name, value] : contents.text) spec.attribute(name, value);
  addHeaderValues(spec, contents.header);
  if (contents.pixelAspect != 1) spec.attribute("PixelAspectRatio", contents.pixelAspect);
  if (!contents.iccProfile.empty() && format != "openexr")
    spec.attribute("ICCProfile",
                   OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(contents.iccProfile.size())),
                   contents.iccProfile.data());
  if (format == "openexr") setWindows(spec, contents);
  return spec;
}

/// Refuses what the format cannot hold, in words.
void checkSuits(const FileToWrite& contents, const std::string& format, const std::string& name) {
  checkImageFits(name, contents.width, contents.height, 1);
  if (contents.parts.empty() || contents.parts.front().channels.empty())
    throw InputError("{}: there is nothing to write: no channels.", name);
  const PartToWrite& part = contents.parts.front();
  const size_t channels = part.channels.size();
  const PixelType type = part.channels.front().type;
  const bool integer = type == PixelType::UInt8 || type == PixelType::UInt16;
  const auto refuse = [&](const std::string& why) {
    throw InputError("{}: {} Write .exr instead.", name, why);
  };
  if (format == "openexr") checkExrCompression(contents.compression, name);
  if (format == "openexr" && integer)
    throw InputError("{}: an EXR holds half or float, not {}.", name, pixelTypeName(type));
  if (format == "png" && (!integer || channels > 4))
    refuse("a PNG holds 8 or 16-bit pixels of 1 to 4 channels.");
  if (format == "tiff" && type == PixelType::Half)
    throw InputError("{}: a TIFF holds integers or 32-bit float, not half. Take float, or write .exr.", name);
  if (format == "jpeg" && std::max(contents.width, contents.height) > kLongestJpegSide)
    refuse(fmt::format("is {} x {} pixels; no side of a JPEG may be longer than {}.", contents.width,
                       contents.height, kLongestJpegSide));
  if (format == "jpeg" && (type != PixelType::UInt8 || (channels != 1 && channels != 3)))
    refuse("a JPEG holds 8-bit pixels of 1 or 3 channels.");
  if (format == "hdr" && (type != PixelType::Float || channels != 3))
    refuse("a Radiance HDR holds float pixels of 3 channels.");
}

/// An open output that fetches OpenImageIO's error messages, which it would otherwise print. A TIFF is
/// written into memory first: libtiff and OpenImageIO pass over disks that fail, and do not let it read back
/// through a proxy, as it has to.
class Output {
 public:
  Output(const AtomicFile& file, const std::string& format)
      : m_file(file), m_proxy(file.temporary()), m_output(OIIO::ImageOutput::create(format)) {
    check();
    if (!m_output) fail();
    if (format == "tiff")
      m_memory.emplace(file);
    else if (!m_output->set_ioproxy(&m_proxy))
      fail();
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() {
    if (!m_output) return;
    m_output->close();
    (void)m_output->geterror();
    (void)OIIO::geterror();
  }
  OIIO::ImageOutput* operator->() { return m_output.get(); }
  /// What OpenImageIO is to open.
  [[nodiscard]] std::string path() const { return m_memory ? m_memory->path() : m_file.temporary().string(); }
  /// Throws where the disk has failed, which the writer does not notice.
  void check() const {
    if (m_proxy.failure() != 0) m_file.fail(m_proxy.failure());
  }
  void close() {
    check();
    if (!m_output->close()) fail();
    const int unread = m_memory ? m_memory->copyTo(m_proxy) : 0;
    if (unread != 0) m_file.fail(unread);
    if (m_proxy.finish() != 0) m_file.fail(m_proxy.failure());
  }
  /// Throws where the writer has put another type in the place of one that was asked for: it would take the
  /// packed pixels for that.
  void checkTypes(const OIIO::ImageSpec& asked) {
    for (int c = 0; c < asked.nchannels; ++c)
      if (m_output->spec().channelformat(c) != asked.channelformat(c))
        m_file.fail(fmt::format("{} holds no {}", m_output->format_name(), asked.channelformat(c).c_str()));
  }
  [[noreturn]] void fail() {
    check();
    std::string words = m_output ? m_output->geterror() : OIIO::geterror();
    words = words.substr(0, words.find('\n'));
    m_file.fail(words.empty() ? "the writer gave no reason" : words);
  }

 private:
  const AtomicFile& m_file;
  FileProxy m_proxy;
  std::optional<MemoryFile> m_memory;
  std::unique_ptr<OIIO::ImageOutput> m_output;
};

void writePart(Output& output, const FileToWrite& contents, const PartToWrite& part,
               std::vector<std::byte>& band, const std::function<void(int rows)>& done) {
  const PackedLayout layout(typesOf(part));
  const PixelRect window = contents.window();
  const size_t rowBytes = layout.pixelBytes * static_cast<size_t>(window.width);
  const int bandRows = std::max(1, static_cast<int>(kBandBytes / (rowBytes * 64))) * 64;
  band.resize(rowBytes * static_cast<size_t>(std::min(bandRows, window.height)));
  std::vector<const float*> planes(part.channels.size());
  for (int y = window.y; y < window.bottom(); y += bandRows) {
    const int rows = std::min(bandRows, window.bottom() - y);
    for (size_t c = 0; c < planes.size(); ++c)
      planes[c] = part.channels[c].plane + static_cast<ptrdiff_t>(y) * contents.width + window.x;
    packPixels({planes, contents.width, window.width, rows}, layout, band.data());
    if (!output->write_scanlines(y, y + rows, 0, OIIO::TypeUnknown, band.data())) output.fail();
    output.check();
    done(rows);
  }
}

void writeByOpenImageIO(const FileToWrite& contents, const std::string& format, const AtomicFile& file,
                        const Progress& progress) {
  Output output(file, format);
  std::vector<OIIO::ImageSpec> specs;
  for (const PartToWrite& part : contents.parts) specs.push_back(specOf(contents, part, format));
  const std::string temporary = output.path();
  const int count = static_cast<int>(specs.size());
  if (!(count == 1 ? output->open(temporary, specs.front()) : output->open(temporary, count, specs.data())))
    output.fail();
  std::vector<std::byte> band;
  int64_t written = 0;
  for (size_t i = 0; i < specs.size(); ++i) {
    if (i > 0 && !output->open(temporary, specs[i], OIIO::ImageOutput::AppendSubimage)) output.fail();
    output.checkTypes(specs[i]);
    writePart(output, contents, contents.parts[i], band, [&](int rows) {
      written += rows;
      progress.update(
          static_cast<float>(written) / static_cast<float>(int64_t{contents.window().height} * count),
          "writing");
    });
  }
  output.close();
}

}  // namespace

/// OpenImageIO takes zip for a name that it does not know.
void checkExrCompression(const std::string& compression, const std::string& file) {
  const std::array<std::string_view, 10> known = {"none",  "rle", "zips", "zip",  "piz",
                                                  "pxr24", "b44", "b44a", "dwaa", "dwab"};
  const std::string_view method = std::string_view(compression).substr(0, compression.find(':'));
  if (compression.empty() || std::find(known.begin(), known.end(), method) != known.end()) return;
  throw InputError("{}: the compression \"{}\" is not known. Known: {}.", file, compression,
                   fmt::join(known, ", "));
}

void writeChannels(const FileToWrite& contents, const std::filesystem::path& path, const Progress& progress) {
  const std::string format = imageFormatForWriting(path);
  checkSuits(contents, format, path.string());
  AtomicFile file(path);
  if (format == "openexr" && isExrZip(contents))
    writeExrZip(contents, file, progress);
  else
    writeByOpenImageIO(contents, format, file, progress);
  file.commit();
}

void writeImage(const Image& image, const std::filesystem::path& file, const WriteOptions& options) {
  writeImage(image, file, options, {});
}

void writeImage(const Image& image, const std::filesystem::path& file, const WriteOptions& options,
                const Progress& progress) {
  const std::string format = imageFormatForWriting(file);
  const std::map<std::string, std::string> usual = {
      {"openexr", "half"}, {"hdr", "float"}, {"jpeg", "uint8"}, {"png", "uint8"}, {"tiff", "uint16"}};
  const std::string common = options.pixelType.empty() ? usual.at(format) : options.pixelType;
  FileToWrite contents{image.width(), image.height(),      {}, image.spec().colorSpace, options.compression,
                       options.text,  options.jpegQuality, {}};
  PartToWrite part;
  for (int c = 0; c < image.channelCount(); ++c) {
    const auto index = static_cast<size_t>(c);
    const std::string& type = options.channelTypes.empty() ? common : options.channelTypes.at(index);
    part.channels.push_back({image.spec().channels[index], image.plane(c), pixelTypeFromName(type)});
  }
  contents.parts.push_back(std::move(part));
  contents.iccProfile = options.iccProfile;
  contents.chromaticities = options.chromaticities;
  if (format == "openexr") contents.dataWindow = options.dataWindow;
  if (options.carried) addCarried(contents, *options.carried, format == "openexr");
  writeChannels(contents, file, progress);
}

}  // namespace swaplight
