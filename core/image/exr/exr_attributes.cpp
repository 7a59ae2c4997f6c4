#include "core/image/exr/exr_attributes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

namespace swaplight {
namespace {

constexpr int kMostAttributes = 1 << 16;
constexpr size_t kLongestName = 255;
constexpr int64_t kLongestSide = 1 << 17;  // as of every picture
constexpr uint32_t kMultiPart = 0x1000;

/// Attributes of these types have one size, which OpenEXR reads whatever the header says.
struct SizedType {
  std::string_view type;
  uint32_t bytes;
};
constexpr std::array kSizedTypes = std::to_array<SizedType>({{"box2f", 16},
                                                             {"box2i", 16},
                                                             {"chromaticities", 32},
                                                             {"compression", 1},
                                                             {"deepImageState", 1},
                                                             {"double", 8},
                                                             {"envmap", 1},
                                                             {"float", 4},
                                                             {"int", 4},
                                                             {"keycode", 28},
                                                             {"lineOrder", 1},
                                                             {"m33d", 72},
                                                             {"m33f", 36},
                                                             {"m44d", 128},
                                                             {"m44f", 64},
                                                             {"rational", 8},
                                                             {"tiledesc", 9},
                                                             {"timecode", 8},
                                                             {"v2d", 16},
                                                             {"v2f", 8},
                                                             {"v2i", 8},
                                                             {"v3d", 24},
                                                             {"v3f", 12},
                                                             {"v3i", 12}});

/// Reads a header bit by bit; every answer is false where the file has ended.
class HeaderWalk {
 public:
  explicit HeaderWalk(const std::filesystem::path& file) : m_in(file, std::ios::binary) {
    m_in.seekg(0, std::ios::end);
    m_size = static_cast<int64_t>(m_in.tellg());
    m_in.seekg(0);
  }
  bool number(uint32_t& value) {
    std::array<unsigned char, 4> bytes{};
    if (!m_in.read(reinterpret_cast<char*>(bytes.data()), bytes.size())) return false;
    value = bytes[0] | uint32_t{bytes[1]} << 8 | uint32_t{bytes[2]} << 16 | uint32_t{bytes[3]} << 24;
    return true;
  }
  /// Where the next byte lies; -1 after the end.
  [[nodiscard]] int64_t at() { return m_in.tellg(); }
  /// Up to the zero that ends it.
  bool name(std::string& text) {
    text.clear();
    for (char c = 0; m_in.get(c) && text.size() <= kLongestName; text += c)
      if (c == '\0') return true;
    return false;
  }
  /// Whether so many bytes are there; passes over them.
  bool skip(uint32_t bytes) {
    const int64_t here = at();
    if (here < 0 || int64_t{bytes} > m_size - here) return false;
    m_in.seekg(bytes, std::ios::cur);
    return static_cast<bool>(m_in);
  }

 private:
  std::ifstream m_in;
  int64_t m_size = 0;
};

/// Passes over a list of channels, which OpenEXR reads up to the empty name that ends it. A channel has one
/// of three types: OpenImageIO ends the process at another one.
bool skipChannels(HeaderWalk& walk) {
  constexpr uint32_t kTypes = 3, kSampling = 12;
  std::string channel;
  while (walk.name(channel)) {
    if (channel.empty()) return true;
    uint32_t type = 0;
    if (!walk.number(type) || type >= kTypes || !walk.skip(kSampling)) return false;
  }
  return false;
}

/// Passes over a small picture of the picture: OpenEXR makes room for as many pixels as it says it has.
bool skipPreview(HeaderWalk& walk) {
  uint32_t width = 0, height = 0;
  if (!walk.number(width) || !walk.number(height)) return false;
  const uint64_t bytes = uint64_t{width} * height * 4;
  return bytes <= UINT32_MAX && walk.skip(static_cast<uint32_t>(bytes));
}

/// Passes over an attribute's value as OpenEXR reads it; false where that is not as long as the header says:
/// what comes then would be read out of step. A string vector's lengths are held against the attribute's by
/// the library.
bool skipValue(HeaderWalk& walk, std::string_view type, uint32_t size) {
  const int64_t end = walk.at() + size;
  if (type == "chlist") return skipChannels(walk) && walk.at() == end;
  if (type == "preview") return skipPreview(walk) && walk.at() == end;
  const auto* sized = std::ranges::find(kSizedTypes, type, &SizedType::type);
  return (sized == kSizedTypes.end() || sized->bytes == size) && walk.skip(size);
}

/// Passes over the window of the pixels, whose sides it gives. OpenEXR makes room for its lines as soon as
/// the file is opened, for every part, whichever is asked for.
bool skipWindow(HeaderWalk& walk, std::array<int64_t, 2>& sides) {
  std::array<uint32_t, 4> corners{};
  for (uint32_t& corner : corners)
    if (!walk.number(corner)) return false;
  for (size_t i = 0; i < 2; ++i)
    sides[i] = int64_t{static_cast<int32_t>(corners[i + 2])} - static_cast<int32_t>(corners[i]) + 1;
  return true;
}

std::string headerFault(HeaderWalk& walk, bool& empty) {
  std::string name, type;
  empty = true;
  for (int i = 0; i < kMostAttributes; ++i) {
    if (!walk.name(name)) return "its header is cut";
    if (name.empty()) return {};
    empty = false;
    uint32_t size = 0;
    if (!walk.name(type) || !walk.number(size)) return "its header is cut";
    if (name == "dataWindow" && type == "box2i" && size == 16) {
      std::array<int64_t, 2> sides{};
      if (!skipWindow(walk, sides)) return "its header is cut";
      if (std::ranges::any_of(sides, [](int64_t side) { return side < 1 || side > kLongestSide; }))
        return "the header says that the picture has " + std::to_string(sides[0]) + " x " +
               std::to_string(sides[1]) + " pixels, expected sides from 1 to " + std::to_string(kLongestSide);
      continue;
    }
    if (!skipValue(walk, type, size))
      return "the header's " + name + ", of " + std::to_string(size) + " bytes, is not what it should be";
  }
  return "its header has no end";
}

}  // namespace

std::string exrHeaderFault(const std::filesystem::path& file) {
  HeaderWalk walk(file);
  uint32_t magic = 0, version = 0;
  if (!walk.number(magic) || !walk.number(version)) return "its header is cut";
  bool empty = false;
  if ((version & kMultiPart) == 0) return headerFault(walk, empty);
  constexpr int kMostParts = 4096;
  for (int part = 0; part < kMostParts; ++part) {  // an empty header ends the list
    std::string fault = headerFault(walk, empty);
    if (!fault.empty() || empty) return fault;
  }
  return "it has too many parts";
}

}  // namespace swaplight
