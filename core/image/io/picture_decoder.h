#pragma once

#include <optional>

#include "core/image/exr/exr_file.h"
#include "core/image/io/image_input.h"
#include "core/image/io/picture_source.h"

namespace swaplight {

/// Decodes in this process, by OpenImageIO and, what it can, by ExrZipReader.
class PictureDecoder {
 public:
  /// Throws InputError: nothing that can be decoded.
  explicit PictureDecoder(const std::filesystem::path& file);

  [[nodiscard]] const PictureContents& contents() const { return m_contents; }
  /// What the largest band takes.
  [[nodiscard]] size_t bandBytes() const;
  /// The next band, decoded into `rows`; nothing when all are. Throws InputError.
  [[nodiscard]] std::optional<PictureBand> next(std::byte* rows);

 private:
  /// How many rows of a part are decoded at a time.
  [[nodiscard]] int bandRows(size_t part) const;
  void decode(const PictureBand& band, std::byte* rows);

  ImageInput m_input;
  std::vector<OIIO::ImageSpec> m_specs;  ///< of each part
  std::vector<OIIO::TypeDesc> m_asked;   ///< of each part: as stored, or float
  std::optional<ExrZipReader> m_exr;
  PictureContents m_contents;
  PictureBand m_next;
};

}  // namespace swaplight
