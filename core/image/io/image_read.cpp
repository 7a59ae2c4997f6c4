#include <algorithm>
#include <optional>

#include "core/base/parallel.h"
#include "core/image/io/image_format.h"
#include "core/image/io/image_io.h"
#include "core/image/io/picture_decoder.h"
#include "core/image/io/picture_process.h"
#include "core/image/orientation.h"
#include "core/image/pixel_pack.h"

namespace swaplight {
namespace {

/// A picture that is decoded in this process.
class PictureHere : public PictureSource {
 public:
  explicit PictureHere(const std::filesystem::path& file) : m_decoder(file) {
    const ImageSpec& spec = contents().spec;
    checkImageFits(file.string(), spec.width, spec.height, spec.channelCount());
    checkBandFits(file.string(), m_decoder.bandBytes());
  }
  [[nodiscard]] const PictureContents& contents() const override { return m_decoder.contents(); }
  void eachBand(const Take& take) override {
    std::vector<std::byte> rows(m_decoder.bandBytes());
    while (const auto band = m_decoder.next(rows.data())) take(*band, rows.data());
  }

 private:
  PictureDecoder m_decoder;
};

/// Where a part's pixels go: planes of the image's size.
struct PartTarget {
  std::span<float* const> planes;
  int width = 0;
  int height = 0;
};

/// Unpacks rows y..y+rows of a part's data window into the display window.
void unpackPixelRows(const PicturePart& part, const PictureBand& band, const std::byte* bytes,
                     const PartTarget& target) {
  const int top = std::max(0, part.y + band.y);
  const int bottom = std::min(target.height, part.y + band.y + band.rows);
  const int left = std::max(0, part.x);
  const int right = std::min(target.width, part.x + part.width);
  if (top >= bottom || left >= right) return;
  const ptrdiff_t first = ptrdiff_t{top} * target.width + left;
  std::vector<float*> planes(target.planes.begin(), target.planes.end());
  for (float*& plane : planes)
    if (plane) plane += first;
  const auto skippedRows = static_cast<size_t>(top - (part.y + band.y));
  unpackPixels(bytes + skippedRows * part.rowBytes(), PackedLayout(part.types), part.width, left - part.x,
               {planes, target.width, right - left, bottom - top});
}

/// Rows that hold their channels one after the other, of a part that fills the image.
void unpackChannelRows(const PicturePart& part, const PictureBand& band, const std::byte* bytes,
                       const PartTarget& target) {
  const size_t rowBytes = part.rowBytes();
  parallelRows(band.rows, 16, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::byte* from = bytes + rowBytes * static_cast<size_t>(y);
      for (size_t c = 0; c < part.types.size(); ++c) {
        float* plane = target.planes[static_cast<size_t>(part.channels[c])];
        if (plane) unpackRow(from, part.types[c], plane + ptrdiff_t{band.y + y} * target.width, part.width);
        from += bytesOf(part.types[c]) * static_cast<size_t>(part.width);
      }
    }
  });
}

bool coversImage(const PicturePart& part, const ImageSpec& spec) {
  return part.x <= 0 && part.y <= 0 && part.x + int64_t{part.width} >= spec.width &&
         part.y + int64_t{part.height} >= spec.height;
}

void readParts(PictureSource& source, std::span<float* const> planes, const Progress& progress) {
  const PictureContents& contents = source.contents();
  const ImageSpec& spec = contents.spec;
  std::vector<PartTarget> targets;
  int64_t total = 0, read = 0;
  size_t channel = 0;
  for (const PicturePart& part : contents.parts) {
    targets.push_back({planes.subspan(channel, part.channels.size()), spec.width, spec.height});
    channel += part.channels.size();
    total += part.height;
    if (!coversImage(part, spec))
      for (float* plane : targets.back().planes)
        if (plane) std::fill_n(plane, spec.pixelCount(), 0.0F);
  }
  source.eachBand([&](const PictureBand& band, const std::byte* bytes) {
    const auto index = static_cast<size_t>(band.part);
    const PicturePart& part = contents.parts[index];
    (part.rowsByChannel ? unpackChannelRows : unpackPixelRows)(part, band, bytes, targets[index]);
    read += band.rows;
    progress.update(static_cast<float>(read) / static_cast<float>(total), "reading");
  });
  if (read != total) throw InputError("it was not read as a whole");
}

}  // namespace

std::unique_ptr<PictureSource> openPicture(const std::filesystem::path& file) {
  if (auto apart = openPictureApart(file)) return apart;
  return std::make_unique<PictureHere>(file);
}

ImageSpec readImageSpec(const std::filesystem::path& file, ImageFileInfo* info) {
  PictureContents contents = openPicture(file)->contents();
  if (info) *info = std::move(contents.info);
  if (turnsBySide(contents.orientation)) std::swap(contents.spec.width, contents.spec.height);
  return contents.spec;
}

void readChannels(const std::filesystem::path& file,
                  const std::function<std::vector<float*>(const ImageSpec&, const ImageFileInfo&)>& planes,
                  const Progress& progress) {
  const auto source = openPicture(file);
  readParts(*source, planes(source->contents().spec, source->contents().info), progress);
}

ImageFile readImage(const std::filesystem::path& file) {
  const auto source = openPicture(file);
  Image image(source->contents().spec);
  std::vector<float*> planes;
  planes.reserve(source->contents().spec.channels.size());
  for (int c = 0; c < image.channelCount(); ++c) planes.push_back(image.plane(c));
  readParts(*source, planes, {});
  return {uprightImage(std::move(image), source->contents().orientation), source->contents().info};
}

}  // namespace swaplight
