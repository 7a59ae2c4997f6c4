#pragma once

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/image/io/image_io.h"

namespace swaplight {

/// The type that unpacks what OpenImageIO calls `type`; nothing where we have none.
[[nodiscard]] std::optional<PixelType> pixelTypeOf(const OIIO::TypeDesc& type);

/// An open file. Fetches every error message of OpenImageIO, which would otherwise print it.
class ImageInput {
 public:
  /// Throws InputError where the file cannot be opened.
  explicit ImageInput(const std::filesystem::path& file);
  ImageInput(const ImageInput&) = delete;
  ImageInput& operator=(const ImageInput&) = delete;
  ~ImageInput();

  [[nodiscard]] const std::string& format() const { return m_format; }
  [[nodiscard]] std::string name() const { return m_file.string(); }
  OIIO::ImageInput* operator->() { return m_input.get(); }

  /// Throws InputError with the first line of OpenImageIO's words.
  [[noreturn]] void fail(std::string words) const;
  [[noreturn]] void fail() const { fail(m_input->geterror()); }

 private:
  std::filesystem::path m_file;
  std::string m_format;
  std::unique_ptr<OIIO::ImageInput> m_input;
};

/// A part of the file, and where its pixels belong in the image.
struct ImagePart {
  OIIO::ImageSpec spec;
  int index = 0;
  int x = 0, y = 0;  ///< of the data window in the display window
  std::vector<std::string> channels;
};

/// All the parts that make up one image.
struct ImageContents {
  ImageSpec spec;       ///< as stored
  int orientation = 1;  ///< EXIF's, where the picture has to be turned upright
  ImageFileInfo info;
  std::vector<ImagePart> parts;
};

/// Reads the headers. Throws InputError: nothing in it, deep, too large, windows that do not meet.
[[nodiscard]] ImageContents contentsOf(ImageInput& input);

}  // namespace swaplight
