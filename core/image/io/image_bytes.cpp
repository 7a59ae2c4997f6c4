#include "core/image/io/image_bytes.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "core/image/io/image_format.h"
#include "core/image/pixel_pack.h"

namespace swaplight {
namespace {

std::string encoded(const Image& image, const std::string& format, int quality) {
  if (format == "jpeg" && std::max(image.width(), image.height()) > kLongestJpegSide)
    throw InputError("a picture of {} x {} pixels cannot be encoded as JPEG: no side may be longer than {}",
                     image.width(), image.height(), kLongestJpegSide);
  const PackedLayout layout({PixelType::UInt8, PixelType::UInt8, PixelType::UInt8});
  std::vector<std::byte> pixels(image.pixelCount() * layout.pixelBytes);
  const std::vector<const float*> planes = {image.plane(0), image.plane(1), image.plane(2)};
  packPixels({planes, image.width(), image.width(), image.height()}, layout, pixels.data());
  OIIO::ImageSpec spec(image.width(), image.height(), 3, OIIO::TypeUInt8);
  if (format == "jpeg") spec.attribute("compression", fmt::format("jpeg:{}", quality));
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(format);
  const bool written = output && output->set_ioproxy(&memory) && output->open("memory." + format, spec) &&
                       output->write_image(OIIO::TypeUInt8, pixels.data()) && output->close();
  if (!written)
    throw InputError("a picture cannot be encoded as {}: {}", format, output ? output->geterror() : "");
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string pngBytes(const Image& image) {
  return encoded(image, "png", 0);
}

std::string jpegBytes(const Image& image, int quality) {
  return encoded(image, "jpeg", quality);
}

}  // namespace swaplight
