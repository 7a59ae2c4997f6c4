#include "core/export/png_cicp.h"

#include <zlib.h>

#include <string_view>

#include "core/base/error.h"

namespace swaplight {
namespace {

std::string bigEndian(uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

std::string chunk(const CodePoints& points) {
  std::string typeAndData = "cICP";
  for (const uint8_t point : points) typeAndData += static_cast<char>(point);
  const auto* bytes = reinterpret_cast<const Bytef*>(typeAndData.data());
  const auto crc = static_cast<uint32_t>(crc32(0, bytes, static_cast<uInt>(typeAndData.size())));
  return bigEndian(static_cast<uint32_t>(points.size())) + typeAndData + bigEndian(crc);
}

}  // namespace

std::optional<CodePoints> codePointsOf(const std::string& display) {
  const auto has = [&](const char* word) { return display.find(word) != std::string::npos; };
  constexpr uint8_t kBt2020 = 9, kPq = 16, kHlg = 18;
  if (has("P3")) return std::nullopt;
  if (has("PQ")) return CodePoints{kBt2020, kPq, 0, 1};
  if (has("HLG")) return CodePoints{kBt2020, kHlg, 0, 1};
  return std::nullopt;
}

std::string withCicp(std::string png, const CodePoints& points, const std::string& name) {
  constexpr size_t kHeader = 8 + 4 + 4 + 13 + 4;  // signature; IHDR's length, type, data, check sum
  if (png.size() < kHeader || std::string_view(png).substr(12, 4) != "IHDR")
    throw InputError("{}: is no PNG.", name);
  png.insert(kHeader, chunk(points));
  return png;
}

}  // namespace swaplight
