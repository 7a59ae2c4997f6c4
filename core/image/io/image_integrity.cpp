#include <zlib.h>

#include <cstdint>
#include <fstream>
#include <string_view>

#include "core/base/error.h"
#include "core/image/io/image_format.h"

namespace swaplight {
namespace {

unsigned byteAt(std::string_view bytes, size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

uint32_t bigEndian32(std::string_view bytes, size_t at) {
  return byteAt(bytes, at) << 24 | byteAt(bytes, at + 1) << 16 | byteAt(bytes, at + 2) << 8 |
         byteAt(bytes, at + 3);
}

/// Walks the segments and the entropy-coded scans to the end-of-image marker. A thumbnail lies inside a
/// segment, so that its marker does not count.
bool jpegIsComplete(std::string_view bytes) {
  size_t at = 2;
  while (at + 1 < bytes.size()) {
    if (byteAt(bytes, at) != 0xff) {  // inside a scan
      ++at;
      continue;
    }
    const unsigned marker = byteAt(bytes, at + 1);
    if (marker == 0xd9) return true;
    const bool alone = marker == 0 || marker == 1 || marker == 0xff || (marker >= 0xd0 && marker <= 0xd8);
    if (alone) {
      at += marker == 0xff ? 1 : 2;
    } else {
      if (at + 3 >= bytes.size()) return false;
      at += 2 + (size_t{byteAt(bytes, at + 2)} << 8 | byteAt(bytes, at + 3));
    }
  }
  return false;
}

/// Walks the chunks to IEND; says what is wrong, or nothing.
std::string pngFault(std::string_view bytes) {
  size_t at = 8;
  while (at + 12 <= bytes.size()) {
    const size_t length = bigEndian32(bytes, at);
    if (length > bytes.size() - at - 12) break;
    const std::string_view typeAndData = bytes.substr(at + 4, length + 4);
    const auto* start = reinterpret_cast<const Bytef*>(typeAndData.data());
    if (crc32_z(0, start, typeAndData.size()) != bigEndian32(bytes, at + 8 + length))
      return "a checksum is wrong: the file is damaged";
    if (typeAndData.starts_with("IHDR") && length >= 8 &&
        (bigEndian32(bytes, at + 8) == 0 || bigEndian32(bytes, at + 12) == 0))
      return "it has no pixels";
    if (typeAndData.starts_with("IEND")) return {};
    at += length + 12;
  }
  return "the file ends in the middle of the picture";
}

}  // namespace

void checkIntegrity(const std::filesystem::path& file, const std::string& format) {
  if (format != "jpeg" && format != "png") return;
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  std::string fault;
  if (format == "png") fault = pngFault(bytes);
  if (format == "jpeg" && !jpegIsComplete(bytes)) fault = "the file ends in the middle of the picture";
  if (!fault.empty())
    throw InputError("{}: is no whole {} file: {}. Copy it again.", file.string(), format, fault);
}

}  // namespace swaplight
