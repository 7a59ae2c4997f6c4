#include "core/image/exr/exr_attributes.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace swaplight {
namespace {

constexpr int kMostAttributes = 1 << 16;
constexpr size_t kLongestName = 255;
constexpr uint32_t kMultiPart = 0x1000;

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
  /// Up to the zero that ends it.
  bool name(std::string& text) {
    text.clear();
    for (char c = 0; m_in.get(c) && text.size() <= kLongestName; text += c)
      if (c == '\0') return true;
    return false;
  }
  /// Whether so many bytes are there; passes over them.
  bool skip(uint32_t bytes) {
    const auto at = static_cast<int64_t>(m_in.tellg());
    if (at < 0 || int64_t{bytes} > m_size - at) return false;
    m_in.seekg(bytes, std::ios::cur);
    return static_cast<bool>(m_in);
  }

 private:
  std::ifstream m_in;
  int64_t m_size = 0;
};

/// A string vector is made of lengths and letters: each length is held against what is left of the attribute
/// by the library; the attribute's own size is what it trusts.
std::string headerFault(HeaderWalk& walk, bool& empty) {
  std::string name, type;
  empty = true;
  for (int i = 0; i < kMostAttributes; ++i) {
    if (!walk.name(name)) return "its header is cut";
    if (name.empty()) return {};
    empty = false;
    uint32_t size = 0;
    if (!walk.name(type) || !walk.number(size)) return "its header is cut";
    if (!walk.skip(size))
      return "the header says " + name + " has " + std::to_string(size) + " bytes, more than are there";
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
