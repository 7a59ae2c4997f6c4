#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace swaplight::test {

/// A TIFF of one colour, of kinds that no library writes: uncompressed, 64 x 64 pixels, one strip or tile.
struct MadeTiff {
  static constexpr uint32_t kSide = 64;

  int photometric = 5;  ///< 0 white is 0, 1 black is 0, 2 RGB, 3 palette, 5 inks
  int bits = 8;
  std::vector<uint64_t> codes = {0, 0, 0, 0};  ///< the one pixel: a number of `bits` bits for each channel
  bool separate = false;                       ///< a channel after the other
  bool tiled = false;
  int sampleFormat = 1;                ///< 1 whole numbers, 3 floats
  bool alpha = false;                  ///< the last channel is
  std::string xmp = {};                ///< its XMP packet
  std::vector<uint16_t> palette = {};  ///< 2^bits reds, greens, blues

  void write(const std::filesystem::path& file) const {
    const uint32_t planes = separate ? static_cast<uint32_t>(codes.size()) : 1;
    const auto samples = static_cast<uint32_t>(codes.size());
    std::vector<Tag> tags = {{256, kLong, numbers({kSide}, 4)},
                             {257, kLong, numbers({kSide}, 4)},
                             {258, kShort, repeated(static_cast<uint32_t>(bits), samples, 2)},
                             {259, kShort, numbers({1}, 2)},
                             {262, kShort, numbers({static_cast<uint32_t>(photometric)}, 2)},
                             {277, kShort, numbers({samples}, 2)},
                             {284, kShort, numbers({separate ? 2U : 1U}, 2)}};
    std::string body;
    std::vector<uint32_t> starts;
    for (uint32_t p = 0; p < planes; ++p) {
      starts.push_back(8 + static_cast<uint32_t>(body.size()));
      body += pixels(separate ? static_cast<int>(p) : -1);
    }
    const auto bytes = static_cast<uint32_t>(body.size() / planes);
    if (tiled) {
      tags.push_back({322, kLong, numbers({kSide}, 4)});
      tags.push_back({323, kLong, numbers({kSide}, 4)});
    } else {
      tags.push_back({278, kLong, numbers({kSide}, 4)});
    }
    tags.push_back({tiled ? uint16_t{324} : uint16_t{273}, kLong, numbers(starts, 4)});
    tags.push_back({tiled ? uint16_t{325} : uint16_t{279}, kLong, repeated(bytes, planes, 4)});
    tags.push_back({339, kShort, repeated(static_cast<uint32_t>(sampleFormat), samples, 2)});
    if (alpha) tags.push_back({338, kShort, numbers({2}, 2)});
    if (!palette.empty()) tags.push_back({320, kShort, numbers({palette.begin(), palette.end()}, 2)});
    if (!xmp.empty()) tags.push_back({700, kByte, xmp});
    writeBytes(file, withTags(body, std::move(tags)));
  }

 private:
  static constexpr uint16_t kByte = 1, kShort = 3, kLong = 4;
  struct Tag {
    uint16_t tag, type;
    std::string bytes;
  };

  static std::string numbers(const std::vector<uint32_t>& values, int size) {
    std::string text;
    for (const uint32_t value : values)
      for (int i = 0; i < size; ++i) text += static_cast<char>(value >> 8 * i);
    return text;
  }
  static std::string repeated(uint32_t value, uint32_t count, int size) {
    return numbers(std::vector<uint32_t>(count, value), size);
  }

  /// The rows of all channels (-1), or of one: whole bytes little-endian, others packed from the highest bit
  /// on.
  [[nodiscard]] std::string pixels(int only) const {
    std::vector<bool> row;
    for (uint32_t x = 0; x < kSide; ++x)
      for (size_t c = 0; c < codes.size(); ++c) {
        if (only >= 0 && c != static_cast<size_t>(only)) continue;
        for (int bit = bits - 1; bit >= 0; --bit) {
          const int at = bits % 8 == 0 ? bits - 8 - bit / 8 * 8 + bit % 8 : bit;
          row.push_back((codes[c] >> at & 1) != 0);
        }
      }
    std::string bytes((row.size() + 7) / 8, '\0');
    for (size_t i = 0; i < row.size(); ++i)
      if (row[i]) bytes[i / 8] = static_cast<char>(bytes[i / 8] | 128 >> i % 8);
    std::string all;
    for (uint32_t y = 0; y < kSide; ++y) all += bytes;
    return all;
  }

  static std::string withTags(const std::string& body, std::vector<Tag> tags) {
    std::sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) { return a.tag < b.tag; });
    const auto list = static_cast<uint32_t>(8 + body.size() + body.size() % 2);
    auto end = static_cast<uint32_t>(list + 2 + 12 * tags.size() + 4);
    std::string directory = numbers({static_cast<uint32_t>(tags.size())}, 2);
    std::string values;
    for (const Tag& tag : tags) {
      const uint32_t size = tag.type == kByte ? 1 : tag.type == kShort ? 2 : 4;
      directory += numbers({tag.tag, tag.type}, 2);
      directory += numbers({static_cast<uint32_t>(tag.bytes.size()) / size}, 4);
      if (tag.bytes.size() <= 4) {
        directory += tag.bytes + std::string(4 - tag.bytes.size(), '\0');
      } else {
        directory += numbers({end}, 4);
        values += tag.bytes;
        end += static_cast<uint32_t>(tag.bytes.size());
      }
    }
    directory += std::string(4, '\0');
    return std::string("II*\0", 4) + numbers({list}, 4) + body + std::string(body.size() % 2, '\0') +
           directory + values;
  }
};

/// A TIFF that crashes OpenImageIO while it is opened: its XMP is half a million elements inside of each
/// other, which the reader follows by calling itself (repaired in its pull request 5405).
inline void writeCrashingTiff(const std::filesystem::path& file) {
  constexpr int kDepth = 500000;
  MadeTiff tiff{.photometric = 1, .codes = {0}};
  tiff.xmp = "<rdf:Description>";
  for (int i = 0; i < kDepth; ++i) tiff.xmp += "<a>";
  for (int i = 0; i < kDepth; ++i) tiff.xmp += "</a>";
  tiff.xmp += "</rdf:Description>";
  tiff.write(file);
}

}  // namespace swaplight::test
