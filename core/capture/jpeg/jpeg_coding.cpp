#include "core/capture/jpeg/jpeg_coding.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <vector>

namespace swaplight {
namespace {

using Bytes = std::vector<uint8_t>;
constexpr int kCoefficients = JpegCoding::kCoefficients;
constexpr size_t kTables = 4;
constexpr int kComponents = 3;

enum Marker : uint8_t {
  kBaseline = 0xC0,
  kExtended = 0xC1,
  kProgressive = 0xC2,
  kStartOfImage = 0xD8,
  kStartOfScan = 0xDA,
  kQuantisation = 0xDB,
  kAdobe = 0xEE,
  kFill = 0xFF
};

/// What the segments before the first scan say.
struct Header {
  std::array<std::array<uint16_t, kCoefficients>, kTables> tables{};
  std::array<bool, kTables> defined{};
  struct Component {
    int id = 0, x = 0, y = 0;  ///< x, y: sampling factors
    size_t table = 0;
  };
  std::vector<Component> components;
  std::optional<int> adobeTransform;
  bool eightBits = false;
};

/// Where the coefficients of a table lie, which follow each other along diagonals of alternate directions.
const std::array<size_t, kCoefficients>& zigzag() {
  static const auto order = [] {
    std::array<size_t, kCoefficients> places{};
    size_t next = 0;
    for (int diagonal = 0; diagonal < 15; ++diagonal)
      for (int j = std::max(diagonal - 7, 0); j <= std::min(diagonal, 7); ++j) {
        const int row = diagonal % 2 ? j : diagonal - j;
        places[next++] = size_t(8 * row + diagonal - row);
      }
    return places;
  }();
  return order;
}

void readTables(const Bytes& bytes, Header& header) {
  size_t at = 0;
  while (at < bytes.size()) {
    const size_t table = bytes[at] & 15;
    const size_t width = bytes[at] >> 4 ? 2 : 1;
    ++at;
    if (table >= kTables || at + kCoefficients * width > bytes.size()) return;
    for (const size_t place : zigzag()) {
      uint16_t step = bytes[at++];
      if (width == 2) step = uint16_t(step << 8 | bytes[at++]);
      header.tables[table][place] = step;
    }
    header.defined[table] = true;
  }
}

void readFrame(const Bytes& bytes, Header& header) {
  constexpr size_t kFixed = 6, kEach = 3;  // bytes: of the frame, of each component
  if (bytes.size() < kFixed || bytes.size() < kFixed + kEach * bytes[5]) return;
  header.eightBits = bytes[0] == 8;
  header.components.clear();
  for (size_t at = kFixed; header.components.size() < bytes[5]; at += kEach)
    header.components.push_back({bytes[at], bytes[at + 1] >> 4, bytes[at + 1] & 15, bytes[at + 2]});
}

void readSegment(uint8_t marker, const Bytes& bytes, Header& header) {
  constexpr size_t kTransform = 11;  // of Adobe's segment: 0 means RGB
  if (marker == kQuantisation) readTables(bytes, header);
  if (marker == kBaseline || marker == kExtended || marker == kProgressive) readFrame(bytes, header);
  if (marker == kAdobe && bytes.size() > kTransform &&
      std::string_view(reinterpret_cast<const char*>(bytes.data()), 5) == "Adobe")
    header.adobeTransform = bytes[kTransform];
}

/// False where the file ends before its first scan.
bool readHeader(std::istream& in, Header& header) {
  const auto byte = [&] { return uint8_t(in.get()); };
  if (byte() != kFill || byte() != kStartOfImage) return false;
  while (in) {
    if (byte() != kFill) return false;
    uint8_t marker = kFill;
    while (in && marker == kFill) marker = byte();
    if (marker == kStartOfScan) return bool(in);
    const size_t high = byte();
    const size_t length = high << 8 | byte();
    if (!in || length < 2) return false;
    Bytes bytes(length - 2);
    in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    if (in) readSegment(marker, bytes, header);
  }
  return false;
}

bool isYCbCr(const Header& header) {
  const auto& parts = header.components;
  if (!header.eightBits || parts.size() != kComponents || header.adobeTransform == 0) return false;
  return !(parts[0].id == 'R' && parts[1].id == 'G' && parts[2].id == 'B');
}

}  // namespace

std::optional<JpegCoding> readJpegCoding(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  Header header;
  if (!in || !readHeader(in, header) || !isYCbCr(header)) return std::nullopt;
  const Header::Component& y = header.components[0];
  const Header::Component& cb = header.components[1];
  const Header::Component& cr = header.components[2];
  if (cb.x < 1 || cb.y < 1 || cb.x != cr.x || cb.y != cr.y || y.x % cb.x || y.y % cb.y) return std::nullopt;
  JpegCoding coding;
  coding.chromaX = y.x / cb.x;
  coding.chromaY = y.y / cb.y;
  if (coding.chromaX < 1 || coding.chromaY < 1) return std::nullopt;
  for (size_t part = 0; part < kComponents; ++part) {
    const size_t table = header.components[part].table;
    if (table >= kTables || !header.defined[table]) return std::nullopt;
    coding.steps[part] = header.tables[table];
  }
  return coding;
}

}  // namespace swaplight
