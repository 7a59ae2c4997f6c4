#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/exr/exr_context.h"
#include "core/image/exr/exr_file.h"
#include "core/image/exr/exr_zip.h"

namespace swaplight {
namespace {

PixelType typeOf(exr_pixel_type_t type) {
  if (type == EXR_PIXEL_HALF) return PixelType::Half;
  return type == EXR_PIXEL_FLOAT ? PixelType::Float : PixelType::UInt32;
}

bool isZip(exr_context_t exr, int part) {
  exr_storage_t storage = EXR_STORAGE_TILED;
  exr_compression_t compression = EXR_COMPRESSION_NONE;
  return exr_get_storage(exr, part, &storage) == EXR_ERR_SUCCESS && storage == EXR_STORAGE_SCANLINE &&
         exr_get_compression(exr, part, &compression) == EXR_ERR_SUCCESS &&
         (compression == EXR_COMPRESSION_ZIP || compression == EXR_COMPRESSION_ZIPS);
}

}  // namespace

struct ExrZipReader::Impl {
  std::string name;
  ExrContext exr;

  [[noreturn]] void fail() const {
    throw InputError("{}: damaged or not a valid openexr file: pixels are missing. Copy it again.", name);
  }
  /// Reads and unpacks the chunk that begins at line y of the part, `bytes` of them, into `to`.
  void readChunk(int part, int y, size_t bytes, std::byte* to) const;
};

void ExrZipReader::Impl::readChunk(int part, int y, size_t bytes, std::byte* to) const {
  thread_local std::vector<std::byte> packed;
  exr_chunk_info_t info;
  if (exr_read_scanline_chunk_info(exr.get(), part, y, &info) != EXR_ERR_SUCCESS) fail();
  if (info.start_y != y || info.unpacked_size != bytes || info.packed_size > bytes) fail();
  if (info.packed_size == bytes) {  // stored raw
    if (exr_read_chunk(exr.get(), part, &info, to) != EXR_ERR_SUCCESS) fail();
    return;
  }
  packed.resize(info.packed_size);
  if (exr_read_chunk(exr.get(), part, &info, packed.data()) != EXR_ERR_SUCCESS) fail();
  if (!unpackExrZip(packed, {to, bytes})) fail();
}

ExrZipReader::ExrZipReader(const std::filesystem::path& file) : m_impl(std::make_unique<Impl>()) {
  m_impl->name = file.string();
  // A context that could not be opened is empty, and every question to it fails.
  (void)m_impl->exr.startRead(file.c_str());
}

ExrZipReader::~ExrZipReader() = default;

bool ExrZipReader::canRead(int part, const std::vector<std::string>& channels, int width, int height) const {
  const exr_context_t exr = m_impl->exr.get();
  if (!exr || !isZip(exr, part)) return false;
  exr_attr_box2i_t window;
  const exr_attr_chlist_t* list = nullptr;
  if (exr_get_data_window(exr, part, &window) != EXR_ERR_SUCCESS) return false;
  if (exr_get_channels(exr, part, &list) != EXR_ERR_SUCCESS) return false;
  if (int64_t{window.max.x} - window.min.x + 1 != width || int64_t{window.max.y} - window.min.y + 1 != height)
    return false;
  if (static_cast<size_t>(list->num_channels) != channels.size()) return false;
  return std::all_of(list->entries, list->entries + list->num_channels,
                     [&](const exr_attr_chlist_entry_t& entry) {
                       return entry.x_sampling == 1 && entry.y_sampling == 1 &&
                              std::find(channels.begin(), channels.end(), entry.name.str) != channels.end();
                     });
}

void ExrZipReader::layout(int part, const std::vector<std::string>& channels, std::vector<PixelType>& types,
                          std::vector<int>& places) const {
  const exr_attr_chlist_t* list = nullptr;
  if (exr_get_channels(m_impl->exr.get(), part, &list) != EXR_ERR_SUCCESS) m_impl->fail();
  for (int c = 0; c < list->num_channels; ++c) {
    types.push_back(typeOf(list->entries[c].pixel_type));
    const auto named = std::find(channels.begin(), channels.end(), list->entries[c].name.str);
    places.push_back(static_cast<int>(named - channels.begin()));
  }
}

void ExrZipReader::readRows(int part, int y, int rows, std::byte* to) const {
  const exr_context_t exr = m_impl->exr.get();
  exr_attr_box2i_t window;
  const exr_attr_chlist_t* list = nullptr;
  int32_t lines = 0;
  if (exr_get_data_window(exr, part, &window) != EXR_ERR_SUCCESS ||
      exr_get_channels(exr, part, &list) != EXR_ERR_SUCCESS ||
      exr_get_scanlines_per_chunk(exr, part, &lines) != EXR_ERR_SUCCESS || lines <= 0)
    m_impl->fail();
  size_t lineBytes = 0;
  for (int c = 0; c < list->num_channels; ++c)
    lineBytes += bytesOf(typeOf(list->entries[c].pixel_type)) *
                 static_cast<size_t>(int64_t{window.max.x} - window.min.x + 1);
  parallelEach((rows + lines - 1) / lines, [&](int chunk) {
    const int first = chunk * lines;
    const auto count = static_cast<size_t>(std::min(lines, rows - first));
    m_impl->readChunk(part, window.min.y + y + first, lineBytes * count,
                      to + lineBytes * static_cast<size_t>(first));
  });
}

}  // namespace swaplight
