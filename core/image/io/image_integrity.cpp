#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/image/exr/exr_attributes.h"
#include "core/image/io/image_format.h"

namespace swaplight {
namespace {

/// A file read forward, a block at a time, whatever its length.
class ByteStream {
 public:
  explicit ByteStream(const std::filesystem::path& file)
      : m_in(file, std::ios::binary), m_block(size_t{1} << 18) {}

  /// What is at hand, at least one byte; empty at the end of the file.
  std::string_view peek() {
    if (m_at == m_size) {
      m_in.read(m_block.data(), static_cast<std::streamsize>(m_block.size()));
      m_size = static_cast<size_t>(m_in.gcount());
      m_at = 0;
    }
    return {m_block.data() + m_at, m_size - m_at};
  }
  void take(size_t count) { m_at += count; }

  bool next(unsigned& byte) {
    const std::string_view bytes = peek();
    if (bytes.empty()) return false;
    byte = static_cast<unsigned char>(bytes.front());
    take(1);
    return true;
  }
  bool bigEndian32(uint32_t& value) {
    value = 0;
    for (int i = 0; i < 4; ++i) {
      unsigned byte = 0;
      if (!next(byte)) return false;
      value = value << 8 | byte;
    }
    return true;
  }
  /// Gives `use` the next `count` bytes, piece by piece; false where the file ends before.
  template <typename Use>
  bool each(size_t count, const Use& use) {
    while (count > 0) {
      const std::string_view bytes = peek().substr(0, count);
      if (bytes.empty()) return false;
      use(bytes);
      take(bytes.size());
      count -= bytes.size();
    }
    return true;
  }
  bool skip(size_t count) {
    return each(count, [](std::string_view) {});
  }

 private:
  std::ifstream m_in;
  std::vector<char> m_block;
  size_t m_at = 0, m_size = 0;
};

/// Walks the segments and the entropy-coded scans to the end-of-image marker. A thumbnail lies inside a
/// segment, so that its marker does not count.
bool jpegIsComplete(ByteStream& in) {
  if (!in.skip(2)) return false;
  while (true) {
    // Inside a scan: on to the next 0xff.
    const std::string_view bytes = in.peek();
    if (bytes.empty()) return false;
    const void* found = std::memchr(bytes.data(), 0xff, bytes.size());
    if (!found) {
      in.take(bytes.size());
      continue;
    }
    in.take(static_cast<size_t>(static_cast<const char*>(found) - bytes.data()) + 1);
    unsigned marker = 0xff;
    while (marker == 0xff)
      if (!in.next(marker)) return false;
    if (marker == 0xd9) return true;
    const bool alone = marker == 0 || marker == 1 || (marker >= 0xd0 && marker <= 0xd8);
    if (alone) continue;
    unsigned high = 0, low = 0;
    if (!in.next(high) || !in.next(low)) return false;
    const unsigned length = high << 8 | low;
    if (length < 2 || !in.skip(length - 2)) return false;
  }
}

/// Walks the chunks to IEND; says what is wrong, or nothing.
std::string pngFault(ByteStream& in) {
  const std::string cut = "the file ends in the middle of the picture";
  if (!in.skip(8)) return cut;
  while (true) {
    uint32_t length = 0, checksum = 0;
    if (!in.bigEndian32(length)) return cut;
    std::string type, begin;
    uLong crc = ::crc32(0, nullptr, 0);
    const auto add = [&crc](std::string_view bytes) {
      crc = crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    };
    const bool whole = in.each(4, [&](std::string_view bytes) {
      type += bytes, add(bytes);
    }) && in.each(length, [&](std::string_view bytes) {
      begin += bytes.substr(0, 8 - std::min<size_t>(begin.size(), 8)), add(bytes);
    }) && in.bigEndian32(checksum);
    if (!whole) return cut;
    if (crc != checksum) return "a checksum is wrong: the file is damaged";
    const bool noPixels =
        type == "IHDR" && begin.size() == 8 &&
        (begin.substr(0, 4) == std::string(4, '\0') || begin.substr(4) == std::string(4, '\0'));
    if (noPixels) return "it has no pixels";
    if (type == "IEND") return {};
  }
}

}  // namespace

void checkIntegrity(const std::filesystem::path& file, const std::string& format) {
  if (format == "openexr")
    if (const std::string fault = exrHeaderFault(file); !fault.empty())
      throw InputError("{}: is damaged or not a valid openexr file: {}. Copy it again.", file.string(),
                       fault);
  std::string fault;
  if (format == "png" || format == "jpeg") {
    ByteStream in(file);
    if (format == "png") fault = pngFault(in);
    if (format == "jpeg" && !jpegIsComplete(in)) fault = "the file ends in the middle of the picture";
  }
  if (!fault.empty())
    throw InputError("{}: is not a complete {} file: {}. Copy it again.", file.string(), format, fault);
}

}  // namespace swaplight
