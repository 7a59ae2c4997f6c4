#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/exr/exr_context.h"
#include "core/image/exr/exr_file.h"
#include "core/image/exr/exr_zip.h"

namespace swaplight {
namespace {

/// A channel of the file, in the file's order, and where its pixels go.
struct Row {
  PixelType type = PixelType::Half;
  float* plane = nullptr;
};

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
  /// Reads and unpacks the chunk that begins at line y of the part; returns its count of lines.
  int readChunk(int part, int y, size_t lineBytes, std::vector<std::byte>& packed,
                std::vector<std::byte>& raw) const;
};

int ExrZipReader::Impl::readChunk(int part, int y, size_t lineBytes, std::vector<std::byte>& packed,
                                  std::vector<std::byte>& raw) const {
  exr_chunk_info_t info;
  if (exr_read_scanline_chunk_info(exr.get(), part, y, &info) != EXR_ERR_SUCCESS) fail();
  const size_t expected = lineBytes * static_cast<size_t>(std::max(info.height, 0));
  if (info.height <= 0 || info.unpacked_size != expected || info.packed_size > expected) fail();
  raw.resize(expected);
  if (info.packed_size == expected) {  // stored raw
    if (exr_read_chunk(exr.get(), part, &info, raw.data()) != EXR_ERR_SUCCESS) fail();
    return info.height;
  }
  packed.resize(info.packed_size);
  if (exr_read_chunk(exr.get(), part, &info, packed.data()) != EXR_ERR_SUCCESS) fail();
  if (!unpackExrZip(packed, raw)) fail();
  return info.height;
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

void ExrZipReader::read(int part, const std::vector<std::string>& channels, std::span<float* const> planes,
                        const std::function<void(int rows)>& done) const {
  const exr_context_t exr = m_impl->exr.get();
  exr_attr_box2i_t window;
  const exr_attr_chlist_t* list = nullptr;
  int32_t lines = 0;
  if (exr_get_data_window(exr, part, &window) != EXR_ERR_SUCCESS ||
      exr_get_channels(exr, part, &list) != EXR_ERR_SUCCESS ||
      exr_get_scanlines_per_chunk(exr, part, &lines) != EXR_ERR_SUCCESS || lines <= 0)
    m_impl->fail();
  const int width = window.max.x - window.min.x + 1;
  const int height = window.max.y - window.min.y + 1;
  std::vector<Row> rows;
  size_t lineBytes = 0;
  for (int c = 0; c < list->num_channels; ++c) {
    const auto named = std::find(channels.begin(), channels.end(), list->entries[c].name.str);
    rows.push_back(
        {typeOf(list->entries[c].pixel_type), planes[static_cast<size_t>(named - channels.begin())]});
    lineBytes += bytesOf(rows.back().type) * static_cast<size_t>(width);
  }
  std::mutex reporting;
  parallelRows((height + lines - 1) / lines, 1, [&](int begin, int end) {
    thread_local std::vector<std::byte> packed;
    thread_local std::vector<std::byte> raw;
    for (int chunk = begin; chunk < end; ++chunk) {
      const int first = chunk * lines;
      const int count = m_impl->readChunk(part, window.min.y + first, lineBytes, packed, raw);
      if (first + count > height) m_impl->fail();
      const std::byte* from = raw.data();
      for (int y = first; y < first + count; ++y)
        for (const Row& row : rows) {
          if (row.plane) unpackRow(from, row.type, row.plane + ptrdiff_t{y} * width, width);
          from += bytesOf(row.type) * static_cast<size_t>(width);
        }
      const std::lock_guard lock(reporting);
      done(count);
    }
  });
}

}  // namespace swaplight
