#include <tbb/parallel_pipeline.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/exr/exr_context.h"
#include "core/image/exr/exr_file.h"
#include "core/image/exr/exr_header.h"
#include "core/image/exr/exr_zip.h"

namespace swaplight {
namespace {

constexpr size_t kLongName = 32;

void check(exr_result_t result, const AtomicFile& file) {
  if (result != EXR_ERR_SUCCESS) file.fail(exr_get_error_code_as_string(result));
}

exr_compression_t compressionOf(const FileToWrite& contents) {
  return contents.compression == "zips" ? EXR_COMPRESSION_ZIPS : EXR_COMPRESSION_ZIP;
}

void setChromaticities(exr_context_t exr, int part, const FileToWrite& contents, const AtomicFile& file) {
  const auto known = contents.saidChromaticities();
  if (!known) return;
  const Chromaticities& xy = *known;
  const exr_attr_chromaticities_t value = {xy[0], xy[1], xy[2], xy[3], xy[4], xy[5], xy[6], xy[7]};
  check(exr_attr_set_chromaticities(exr, part, "chromaticities", &value), file);
}

bool needsLongNames(const FileToWrite& contents) {
  for (const PartToWrite& part : contents.parts)
    for (const ChannelToWrite& channel : part.channels)
      if (channel.name.size() >= kLongName) return true;
  return false;
}

void writeHeader(exr_context_t exr, const FileToWrite& contents, const AtomicFile& file) {
  check(exr_set_longname_support(exr, needsLongNames(contents) ? 1 : 0), file);
  for (const PartToWrite& part : contents.parts) {
    int index = 0;
    const char* name = part.name.empty() ? nullptr : part.name.c_str();
    check(exr_add_part(exr, name, EXR_STORAGE_SCANLINE, &index), file);
    check(setExrWindows(exr, index, contents, compressionOf(contents)), file);
    for (const ChannelToWrite& channel : part.channels) {
      const exr_pixel_type_t type = channel.type == PixelType::Half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
      check(exr_add_channel(exr, index, channel.name.c_str(), type, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1),
            file);
    }
    setChromaticities(exr, index, contents, file);
    if (index == 0) check(setExrValues(exr, index, contents), file);
  }
  check(exr_write_header(exr), file);
}

/// In the order of the file: by name.
std::vector<ChannelToWrite> sorted(std::vector<ChannelToWrite> channels) {
  std::sort(channels.begin(), channels.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return channels;
}

/// A chunk on its way through the pipeline.
struct Chunk {
  int y = 0;
  int rows = 0;
  std::vector<std::byte> raw;
  std::vector<std::byte> packed;  ///< empty: stored raw
};

/// Lines of a chunk: for each line the channels' rows one after the other. `pitch` is the planes' width.
void gather(Chunk& chunk, const std::vector<ChannelToWrite>& channels, const PixelRect& window, int pitch) {
  size_t pixelBytes = 0;
  for (const ChannelToWrite& channel : channels) pixelBytes += bytesOf(channel.type);
  chunk.raw.resize(pixelBytes * static_cast<size_t>(window.width) * static_cast<size_t>(chunk.rows));
  std::byte* to = chunk.raw.data();
  for (int y = chunk.y; y < chunk.y + chunk.rows; ++y)
    for (const ChannelToWrite& channel : channels) {
      packRow(channel.plane + ptrdiff_t{y} * pitch + window.x, channel.type, to, window.width);
      to += bytesOf(channel.type) * static_cast<size_t>(window.width);
    }
}

void writePart(exr_context_t exr, int index, const FileToWrite& contents, const AtomicFile& file,
               const std::function<void(int rows)>& done) {
  const std::vector<ChannelToWrite> channels = sorted(contents.parts[static_cast<size_t>(index)].channels);
  const PixelRect window = contents.window();
  const int lines = compressionOf(contents) == EXR_COMPRESSION_ZIPS ? 1 : 16;
  // As many chunks as may be on their way; the one that is written last is free when the next one begins.
  std::vector<Chunk> ring(static_cast<size_t>(threadCount()) * 4);
  size_t count = 0;
  const auto begin = [&](tbb::flow_control& control) -> Chunk* {
    const int y = window.y + static_cast<int>(count) * lines;
    if (y >= window.bottom()) {
      control.stop();
      return nullptr;
    }
    Chunk& chunk = ring[count++ % ring.size()];
    chunk.y = y;
    chunk.rows = std::min(lines, window.bottom() - y);
    return &chunk;
  };
  const auto pack = [&](Chunk* chunk) {
    gather(*chunk, channels, window, contents.width);
    packExrZip(chunk->raw, chunk->packed);
    return chunk;
  };
  const auto write = [&](const Chunk* chunk) {
    const std::vector<std::byte>& bytes = chunk->packed.empty() ? chunk->raw : chunk->packed;
    check(exr_write_scanline_chunk(exr, index, chunk->y, bytes.data(), bytes.size()), file);
    done(chunk->rows);
  };
  tbb::parallel_pipeline(ring.size(),
                         tbb::make_filter<void, Chunk*>(tbb::filter_mode::serial_in_order, begin) &
                             tbb::make_filter<Chunk*, Chunk*>(tbb::filter_mode::parallel, pack) &
                             tbb::make_filter<Chunk*, void>(tbb::filter_mode::serial_in_order, write));
}

}  // namespace

bool isExrZip(const FileToWrite& contents) {
  return contents.compression.empty() || contents.compression == "zip" || contents.compression == "zips";
}

void writeExrZip(const FileToWrite& contents, const AtomicFile& file, const Progress& progress) {
  ExrContext exr;
  check(exr.startWrite(file.temporary().c_str()), file);
  writeHeader(exr.get(), contents, file);
  const auto total = static_cast<float>(contents.parts.size()) * static_cast<float>(contents.window().height);
  int64_t written = 0;
  for (size_t i = 0; i < contents.parts.size(); ++i)
    writePart(exr.get(), static_cast<int>(i), contents, file, [&](int rows) {
      written += rows;
      progress.update(static_cast<float>(written) / total, "writing");
    });
  check(exr.finish(), file);
}

}  // namespace swaplight
