#include "core/image/exr/exr_zip.h"

#include <libdeflate.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <new>

#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kLevel = 1;  // higher levels save 3 % and take a quarter longer

struct FreeCompressor {
  void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};
struct FreeDecompressor {
  void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
};

/// Each thread keeps its own tools: making them costs as much as a chunk.
libdeflate_compressor* compressor() {
  thread_local const std::unique_ptr<libdeflate_compressor, FreeCompressor> own(
      libdeflate_alloc_compressor(kLevel));
  if (!own) throw std::bad_alloc();
  return own.get();
}

libdeflate_decompressor* decompressor() {
  thread_local const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> own(
      libdeflate_alloc_decompressor());
  if (!own) throw std::bad_alloc();
  return own.get();
}

std::vector<uint8_t>& scratch(size_t size) {
  thread_local std::vector<uint8_t> own;
  own.resize(size);
  return own;
}

SWAPLIGHT_SIMD(void, splitBytes, (const uint8_t* in, uint8_t* out, size_t count), (in, out, count)) {
  uint8_t* even = out;
  uint8_t* odd = out + (count + 1) / 2;
  for (size_t i = 0; i < count / 2; ++i) {
    even[i] = in[2 * i];
    odd[i] = in[2 * i + 1];
  }
  if (count % 2 == 1) even[count / 2] = in[count - 1];
}

SWAPLIGHT_SIMD(void, joinBytes, (const uint8_t* in, uint8_t* out, size_t count), (in, out, count)) {
  const uint8_t* even = in;
  const uint8_t* odd = in + (count + 1) / 2;
  for (size_t i = 0; i < count / 2; ++i) {
    out[2 * i] = even[i];
    out[2 * i + 1] = odd[i];
  }
  if (count % 2 == 1) out[count - 1] = even[count / 2];
}

SWAPLIGHT_SIMD(void, differences, (const uint8_t* in, uint8_t* out, size_t count), (in, out, count)) {
  out[0] = in[0];
  for (size_t i = 1; i < count; ++i) out[i] = static_cast<uint8_t>(in[i] - in[i - 1] + 128);
}

void sums(uint8_t* bytes, size_t count) {
  uint8_t last = bytes[0];
  for (size_t i = 1; i < count; ++i) bytes[i] = last = static_cast<uint8_t>(last + bytes[i] - 128);
}

}  // namespace

void packExrZip(std::span<const std::byte> raw, std::vector<std::byte>& packed) {
  packed.clear();
  if (raw.empty()) return;
  std::vector<uint8_t>& bytes = scratch(2 * raw.size());
  uint8_t* split = bytes.data();
  uint8_t* predicted = split + raw.size();
  splitBytes(reinterpret_cast<const uint8_t*>(raw.data()), split, raw.size());
  differences(split, predicted, raw.size());
  packed.resize(raw.size());
  packed.resize(libdeflate_zlib_compress(compressor(), predicted, raw.size(), packed.data(), raw.size() - 1));
}

bool unpackExrZip(std::span<const std::byte> packed, std::span<std::byte> raw) {
  if (raw.empty()) return packed.empty();
  std::vector<uint8_t>& bytes = scratch(raw.size());
  const libdeflate_result result = libdeflate_zlib_decompress(decompressor(), packed.data(), packed.size(),
                                                              bytes.data(), raw.size(), nullptr);
  if (result != LIBDEFLATE_SUCCESS) return false;
  sums(bytes.data(), raw.size());
  joinBytes(bytes.data(), reinterpret_cast<uint8_t*>(raw.data()), raw.size());
  return true;
}

}  // namespace swaplight
