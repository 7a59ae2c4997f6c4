#include "core/image/io/picture_decoder.h"

#include <algorithm>
#include <numeric>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

// Of a band. Two bands are memory that no other picture has touched: more costs more than handing over more
// often.
constexpr size_t kDecodedBytes = size_t{4} << 20;
constexpr size_t kLargestBand = size_t{256} << 20;

/// The types to ask for: as stored where we unpack them ourselves, else float; `asked` is what OpenImageIO is
/// told.
std::vector<PixelType> typesOf(const OIIO::ImageSpec& spec, OIIO::TypeDesc& asked) {
  std::vector<PixelType> types;
  asked = OIIO::TypeUnknown;  // as stored
  for (int c = 0; c < spec.nchannels; ++c) {
    const auto type = pixelTypeOf(spec.channelformat(c));
    if (!type) asked = OIIO::TypeFloat;
    types.push_back(type.value_or(PixelType::Float));
  }
  if (asked == OIIO::TypeFloat) std::fill(types.begin(), types.end(), PixelType::Float);
  return types;
}

bool fillsImage(const ImagePart& part, const ImageSpec& spec) {
  return part.x == 0 && part.y == 0 && part.spec.width == spec.width && part.spec.height == spec.height;
}

}  // namespace

size_t PicturePart::rowBytes() const {
  size_t pixel = 0;
  for (const PixelType type : types) pixel += bytesOf(type);
  return pixel * static_cast<size_t>(width);
}

PictureDecoder::PictureDecoder(const std::filesystem::path& file) : m_input(file) {
  ImageContents contents = contentsOf(m_input);
  if (m_input.format() == "openexr") m_exr.emplace(file);
  for (const ImagePart& part : contents.parts) {
    const OIIO::ImageSpec& spec = part.spec;
    PicturePart known{part.x, part.y, spec.width, spec.height, {}, {}, false};
    OIIO::TypeDesc& asked = m_asked.emplace_back();
    const std::vector<std::string>& names = spec.channelnames;
    if (m_exr && fillsImage(part, contents.spec) &&
        m_exr->canRead(part.index, names, contents.spec.width, contents.spec.height)) {
      known.rowsByChannel = true;
      m_exr->layout(part.index, names, known.types, known.channels);
    } else {
      known.types = typesOf(spec, asked);
      known.channels.resize(known.types.size());
      std::iota(known.channels.begin(), known.channels.end(), 0);
    }
    m_contents.parts.push_back(std::move(known));
    m_specs.push_back(spec);
  }
  m_contents.spec = std::move(contents.spec);
  m_contents.orientation = contents.orientation;
  m_contents.info = std::move(contents.info);
}

int PictureDecoder::bandRows(size_t part) const {
  const PicturePart& known = m_contents.parts[part];
  const size_t tile = static_cast<size_t>(m_specs[part].tile_height);
  const size_t step = known.rowsByChannel ? size_t{16} : tile > 0 ? tile : size_t{16};
  const size_t stepBytes = std::max<size_t>(1, known.rowBytes() * step);
  // Every thread is to have two pieces of its own.
  const size_t busy = std::min(2 * static_cast<size_t>(threadCount()), kLargestBand / stepBytes);
  const size_t steps = std::max({size_t{1}, kDecodedBytes / stepBytes, busy});
  return static_cast<int>(std::min(step * steps, static_cast<size_t>(known.height)));
}

size_t PictureDecoder::bandBytes() const {
  size_t most = 0;
  for (size_t part = 0; part < m_contents.parts.size(); ++part)
    most = std::max(most, m_contents.parts[part].rowBytes() * static_cast<size_t>(bandRows(part)));
  return most;
}

void PictureDecoder::decode(const PictureBand& band, std::byte* rows) {
  const auto part = static_cast<size_t>(band.part);
  if (m_contents.parts[part].rowsByChannel) return m_exr->readRows(band.part, band.y, band.rows, rows);
  const OIIO::ImageSpec& spec = m_specs[part];
  const int first = spec.y + band.y;
  const bool read =
      spec.tile_width > 0
          ? m_input->read_tiles(band.part, 0, spec.x, spec.x + spec.width, first, first + band.rows, spec.z,
                                spec.z + 1, 0, spec.nchannels, m_asked[part], rows)
          : m_input->read_scanlines(band.part, 0, first, first + band.rows, spec.z, 0, spec.nchannels,
                                    m_asked[part], rows);
  if (!read || m_input->has_error()) m_input.fail();  // a truncated TIFF succeeds with an error
}

std::optional<PictureBand> PictureDecoder::next(std::byte* rows) {
  const auto part = static_cast<size_t>(m_next.part);
  if (part == m_contents.parts.size()) return std::nullopt;
  const int height = m_contents.parts[part].height;
  m_next.rows = std::min(bandRows(part), height - m_next.y);
  const PictureBand band = m_next;
  decode(band, rows);
  m_next.y += band.rows;
  if (m_next.y == height) m_next = {band.part + 1, 0, 0};
  return band;
}

}  // namespace swaplight
