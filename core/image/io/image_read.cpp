#include <algorithm>
#include <optional>

#include "core/image/exr/exr_file.h"
#include "core/image/io/image_input.h"
#include "core/image/io/image_io.h"
#include "core/image/orientation.h"
#include "core/image/pixel_pack.h"

namespace swaplight {
namespace {

constexpr size_t kBandBytes = size_t{32} << 20;

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
void unpackBand(const ImagePart& part, int y, int rows, const PackedLayout& layout, const std::byte* band,
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
void readPart(ImageInput& input, const ImagePart& part, const PartTarget& target,
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

bool coversImage(const ImagePart& part, const ImageSpec& spec) {
  return part.x <= 0 && part.y <= 0 && part.x + int64_t{part.spec.width} >= spec.width &&
         part.y + int64_t{part.spec.height} >= spec.height;
}

bool fillsImage(const ImagePart& part, const ImageSpec& spec) {
  return part.x == 0 && part.y == 0 && part.spec.width == spec.width && part.spec.height == spec.height;
}

void readParts(ImageInput& input, const ImageContents& contents, std::span<float* const> planes,
               const Progress& progress) {
  const ImageSpec& spec = contents.spec;
  int64_t total = 0;
  for (const ImagePart& part : contents.parts) total += part.spec.height;
  int64_t read = 0;
  size_t channel = 0;
  std::optional<ExrZipReader> exr;
  if (input.format() == "openexr") exr.emplace(input.name());
  for (const ImagePart& part : contents.parts) {
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
  ImageInput input(file);
  ImageContents contents = contentsOf(input);
  if (info) *info = std::move(contents.info);
  if (turnsBySide(contents.orientation)) std::swap(contents.spec.width, contents.spec.height);
  return contents.spec;
}

void readChannels(const std::filesystem::path& file,
                  const std::function<std::vector<float*>(const ImageSpec&, const ImageFileInfo&)>& planes,
                  const Progress& progress) {
  ImageInput input(file);
  const ImageContents contents = contentsOf(input);
  readParts(input, contents, planes(contents.spec, contents.info), progress);
}

ImageFile readImage(const std::filesystem::path& file) {
  ImageInput input(file);
  ImageContents contents = contentsOf(input);
  Image image(contents.spec);
  std::vector<float*> planes;
  planes.reserve(contents.spec.channels.size());
  for (int c = 0; c < image.channelCount(); ++c) planes.push_back(image.plane(c));
  readParts(input, contents, planes, {});
  return {uprightImage(std::move(image), contents.orientation), std::move(contents.info)};
}

}  // namespace swaplight
