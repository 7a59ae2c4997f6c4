#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/image/io/image_io.h"

namespace swaplight {

/// A part of a file: where its pixels belong in the picture, and how its bands hold them.
struct PicturePart {
  int x = 0, y = 0;  ///< of the data window in the display window
  int width = 0, height = 0;
  std::vector<PixelType> types;  ///< of each channel, in the order of the bands
  std::vector<int> channels;     ///< for each of those, which of the part's channels it is
  bool rowsByChannel = false;    ///< a row holds its channels one after the other, not pixel by pixel
  bool operator==(const PicturePart&) const = default;

  [[nodiscard]] size_t rowBytes() const;
};

/// All that is known of a picture before its pixels are.
struct PictureContents {
  ImageSpec spec;       ///< as stored; the channels of all parts, one part after the other
  int orientation = 1;  ///< EXIF's, where the picture has to be turned upright
  ImageFileInfo info;
  std::vector<PicturePart> parts;
  bool operator==(const PictureContents&) const = default;
};

/// Rows y .. y + rows of a part, as its file stores them.
struct PictureBand {
  int part = 0, y = 0, rows = 0;
};

/// An open picture: what is in it, then its pixels, band by band from top to bottom, part after part.
class PictureSource {
 public:
  PictureSource() = default;
  PictureSource(const PictureSource&) = delete;
  PictureSource& operator=(const PictureSource&) = delete;
  virtual ~PictureSource() = default;

  [[nodiscard]] virtual const PictureContents& contents() const = 0;
  using Take = std::function<void(const PictureBand&, const std::byte* rows)>;
  /// Decodes everything once. Throws InputError where something is broken.
  virtual void eachBand(const Take& take) = 0;
};

/// The one door through which every picture comes. Throws InputError that names the file.
[[nodiscard]] std::unique_ptr<PictureSource> openPicture(const std::filesystem::path& file);

}  // namespace swaplight
