#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace swaplight::test {

/// The bytes of an uncompressed DNG with an RGGB sensor, black 512, white 16383 and a daylight white balance
/// that is far from neutral: enough for LibRaw, small enough to be written here (Adobe DNG 1.4, TIFF 6.0).
inline std::string tinyDng(int width, int height, const std::function<uint16_t(int x, int y)>& sensor) {
  struct Entry {
    uint16_t tag, type;
    uint32_t count;
    std::string value;
  };
  const auto bytes = [](uint64_t value, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
  };
  const auto shorts = [&](uint16_t tag, const std::vector<uint16_t>& values) {
    Entry entry{tag, 3, static_cast<uint32_t>(values.size()), {}};
    for (const uint16_t value : values) entry.value += bytes(value, 2);
    return entry;
  };
  const auto longs = [&](uint16_t tag, uint32_t value) { return Entry{tag, 4, 1, bytes(value, 4)}; };
  const auto rationals = [&](uint16_t tag, uint16_t type, const std::vector<int>& tenThousandths) {
    Entry entry{tag, type, static_cast<uint32_t>(tenThousandths.size()), {}};
    for (const int value : tenThousandths)
      entry.value += bytes(static_cast<uint32_t>(value), 4) + bytes(10000, 4);
    return entry;
  };
  const auto text = [&](uint16_t tag, const std::string& value) {
    return Entry{tag, 2, static_cast<uint32_t>(value.size() + 1), value + '\0'};
  };
  std::string pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pixels += bytes(sensor(x, y), 2);

  const std::vector<Entry> entries = {
      longs(254, 0),
      longs(256, static_cast<uint32_t>(width)),
      longs(257, static_cast<uint32_t>(height)),
      shorts(258, {16}),
      shorts(259, {1}),
      shorts(262, {32803}),  // colour filter array
      text(271, "Swaplight"),
      text(272, "Test"),
      longs(273, 8),  // the pixels stand right behind the header
      shorts(274, {1}),
      shorts(277, {1}),
      longs(278, static_cast<uint32_t>(height)),
      longs(279, static_cast<uint32_t>(pixels.size())),
      shorts(284, {1}),
      shorts(33421, {2, 2}),
      Entry{33422, 1, 4, std::string("\0\1\1\2", 4)},
      Entry{50706, 1, 4, std::string("\1\4\0\0", 4)},
      text(50708, "Swaplight Test"),
      shorts(50714, {512}),
      shorts(50717, {16383}),
      rationals(50721, 10, {6722, -635, -963, -4287, 12460, 2028, -908, 2162, 5668}),
      rationals(50728, 5, {5000, 10000, 6000}),
      shorts(50778, {21}),
  };
  std::string directory = bytes(entries.size(), 2);
  std::string values;
  const size_t directoryAt = 8 + pixels.size();
  const size_t valuesAt = directoryAt + 2 + entries.size() * 12 + 4;
  for (const Entry& entry : entries) {
    directory += bytes(entry.tag, 2) + bytes(entry.type, 2) + bytes(entry.count, 4);
    if (entry.value.size() <= 4) {
      directory += entry.value + std::string(4 - entry.value.size(), '\0');
    } else {
      directory += bytes(valuesAt + values.size(), 4);
      values += entry.value + std::string(entry.value.size() % 2, '\0');
    }
  }
  return "II*" + std::string(1, '\0') + bytes(directoryAt, 4) + pixels + directory + bytes(0, 4) + values;
}

}  // namespace swaplight::test
