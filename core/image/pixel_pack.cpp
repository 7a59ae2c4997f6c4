#include "core/image/pixel_pack.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/half.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kGrain = 16;  // rows

template <typename T>
inline T load(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

template <typename T>
inline void store(std::byte* to, T value) {
  std::memcpy(to, &value, sizeof(T));
}

inline float quantised(float value, float steps) {
  const float scaled = value * steps + 0.5F;
  return scaled > 0 ? (scaled < steps ? scaled : steps) : 0;  // NaN fails the first comparison
}

SWAPLIGHT_SIMD(void, unpackRow, (const std::byte* in, size_t stride, PixelType type, float* out, int width),
               (in, stride, type, out, width)) {
  const auto count = static_cast<size_t>(width);
  switch (type) {
    case PixelType::UInt8:
      for (size_t i = 0; i < count; ++i) out[i] = static_cast<float>(load<uint8_t>(in + i * stride)) / 255.0F;
      break;
    case PixelType::UInt16:
      for (size_t i = 0; i < count; ++i)
        out[i] = static_cast<float>(load<uint16_t>(in + i * stride)) / 65535.0F;
      break;
    case PixelType::UInt32:
      for (size_t i = 0; i < count; ++i) out[i] = static_cast<float>(load<uint32_t>(in + i * stride));
      break;
    case PixelType::Half:
      for (size_t i = 0; i < count; ++i) out[i] = floatFromHalf(load<uint16_t>(in + i * stride));
      break;
    case PixelType::Float:
      for (size_t i = 0; i < count; ++i) out[i] = load<float>(in + i * stride);
      break;
  }
}

SWAPLIGHT_SIMD(void, packRow, (const float* in, PixelType type, std::byte* out, size_t stride, int width),
               (in, type, out, stride, width)) {
  const auto count = static_cast<size_t>(width);
  switch (type) {
    case PixelType::UInt8:
      for (size_t i = 0; i < count; ++i) store(out + i * stride, static_cast<uint8_t>(quantised(in[i], 255)));
      break;
    case PixelType::UInt16:
      for (size_t i = 0; i < count; ++i)
        store(out + i * stride, static_cast<uint16_t>(quantised(in[i], 65535)));
      break;
    case PixelType::UInt32:
      for (size_t i = 0; i < count; ++i) store(out + i * stride, static_cast<uint32_t>(in[i]));
      break;
    case PixelType::Half:
      for (size_t i = 0; i < count; ++i) store(out + i * stride, halfFromFloat(clampedToHalf(in[i])));
      break;
    case PixelType::Float:
      for (size_t i = 0; i < count; ++i) store(out + i * stride, in[i]);
      break;
  }
}

SWAPLIGHT_SIMD(void, clampRow, (const float* in, float* out, size_t count), (in, out, count)) {
  for (size_t i = 0; i < count; ++i) out[i] = clampedToHalf(in[i]);
}

/// Side by side, which the processor converts by itself.
void packHalves(const float* in, uint16_t* out, size_t count) {
  constexpr size_t kBlock = 1024;
  std::array<float, kBlock> clamped;
  for (size_t i = 0; i < count; i += kBlock) {
    const size_t length = std::min(kBlock, count - i);
    clampRow(in + i, clamped.data(), length);
    halfFromFloat(clamped.data(), out + i, length);
  }
}

constexpr std::array<std::pair<PixelType, const char*>, 5> kNames = {{{PixelType::UInt8, "uint8"},
                                                                      {PixelType::UInt16, "uint16"},
                                                                      {PixelType::UInt32, "uint32"},
                                                                      {PixelType::Half, "half"},
                                                                      {PixelType::Float, "float"}}};

}  // namespace

size_t bytesOf(PixelType type) {
  if (type == PixelType::UInt8) return 1;
  return type == PixelType::UInt16 || type == PixelType::Half ? 2 : 4;
}

std::string pixelTypeName(PixelType type) {
  for (const auto& [known, name] : kNames)
    if (known == type) return name;
  return {};
}

PixelType pixelTypeFromName(const std::string& name) {
  for (const auto& [type, known] : kNames)
    if (name == known && type != PixelType::UInt32) return type;
  throw InputError("the pixel type \"{}\" is not known. Known types: uint8, uint16, half, float.", name);
}

PackedLayout::PackedLayout(std::vector<PixelType> channelTypes) : types(std::move(channelTypes)) {
  for (const PixelType type : types) {
    offsets.push_back(pixelBytes);
    pixelBytes += bytesOf(type);
  }
}

void unpackRow(const std::byte* in, PixelType type, float* out, int width) {
  const auto count = static_cast<size_t>(width);
  if (type == PixelType::Half)
    floatFromHalf(reinterpret_cast<const uint16_t*>(in), out, count);
  else
    unpackRow(in, bytesOf(type), type, out, width);
}

void packRow(const float* in, PixelType type, std::byte* out, int width) {
  if (type == PixelType::Half)
    packHalves(in, reinterpret_cast<uint16_t*>(out), static_cast<size_t>(width));
  else
    packRow(in, type, out, bytesOf(type), width);
}

void unpackPixels(const std::byte* rows, const PackedLayout& layout, int packedWidth, int firstX,
                  const UnpackTarget& target) {
  const size_t rowBytes = layout.pixelBytes * static_cast<size_t>(packedWidth);
  const size_t skipped = layout.pixelBytes * static_cast<size_t>(firstX);
  parallelRows(target.height, kGrain, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (size_t c = 0; c < target.planes.size(); ++c) {
        if (!target.planes[c]) continue;
        const std::byte* row = rows + static_cast<size_t>(y) * rowBytes + skipped + layout.offsets[c];
        unpackRow(row, layout.pixelBytes, layout.types[c], target.planes[c] + y * target.rowStride,
                  target.width);
      }
  });
}

void packPixels(const PackSource& source, const PackedLayout& layout, std::byte* rows) {
  const size_t rowBytes = layout.pixelBytes * static_cast<size_t>(source.width);
  parallelRows(source.height, kGrain, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (size_t c = 0; c < source.planes.size(); ++c) {
        const float* row = source.planes[c] + y * source.rowStride;
        std::byte* packed = rows + static_cast<size_t>(y) * rowBytes + layout.offsets[c];
        packRow(row, layout.types[c], packed, layout.pixelBytes, source.width);
      }
  });
}

}  // namespace swaplight
