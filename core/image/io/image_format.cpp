#include "core/image/io/image_format.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/image/images_in_files.h"

namespace swaplight {
namespace {

constexpr std::array<std::string_view, 26> kRawExtensions = {
    "3fr", "arw", "cr2", "cr3", "crw", "dcr", "dng", "erf", "fff", "iiq", "kdc", "mef", "mos",
    "mrw", "nef", "nrw", "orf", "pef", "raf", "raw", "rw2", "rwl", "sr2", "srf", "srw", "x3f"};

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = lowerExtension(file);
  if (!extension.empty()) extension.erase(0, 1);
  return extension;
}

std::string firstBytes(const std::filesystem::path& file, size_t count) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError("{}: no such file.", file.string());
  if (!std::filesystem::exists(status))
    throw InputError("{}: cannot be read ({}).", file.string(), error.message());
  if (std::filesystem::is_directory(status))
    throw InputError("{}: is a folder, expected a picture.", file.string());
  if (!std::filesystem::is_regular_file(status))  // opening a pipe would wait for its writer
    throw InputError("{}: is no regular file, expected a picture.", file.string());
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError("{}: cannot be opened. Check its permissions.", file.string());
  std::string bytes(count, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<size_t>(in.gcount()));
  if (bytes.empty()) throw InputError("{}: is empty, expected a picture.", file.string());
  return bytes;
}

}  // namespace

std::string imageFormatOf(const std::filesystem::path& file) {
  using namespace std::string_view_literals;
  const std::string bytes = firstBytes(file, 16);
  const std::string extension = extensionOf(file);
  const auto startsWith = [&](std::string_view magic) { return bytes.starts_with(magic); };
  if (startsWith("\x76\x2f\x31\x01"sv)) return "openexr";
  if (startsWith("\x89PNG\r\n\x1a\n"sv)) return "png";
  if (startsWith("\xff\xd8\xff"sv)) return "jpeg";
  if (startsWith("#?RADIANCE"sv) || startsWith("#?RGBE"sv)) return "hdr";
  // Most raw files are TIFF files inside: only their names tell them apart.
  if (std::find(kRawExtensions.begin(), kRawExtensions.end(), extension) != kRawExtensions.end())
    return "raw";
  for (const auto magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
    if (startsWith(magic)) return "tiff";
  throw InputError(
      "{}: is not a picture that this program reads (EXR, PNG, TIFF, JPEG, Radiance HDR, camera raw).",
      file.string());
}

std::string imageFormatForWriting(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  if (extension == "exr") return "openexr";
  if (extension == "png") return "png";
  if (extension == "tif" || extension == "tiff") return "tiff";
  if (extension == "jpg" || extension == "jpeg") return "jpeg";
  if (extension == "hdr") return "hdr";
  throw InputError(
      "{}: the extension \"{}\" names no format that can be written. Use .exr, .png, .tif, .jpg or .hdr.",
      file.string(), extension);
}

double machineGigabytes() {
  return 1e-9 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void checkImageSides(const std::string& name, int width, int height, int channels) {
  constexpr int kLongestSide = 1 << 17;
  if (width <= 0 || height <= 0 || channels <= 0)
    throw InputError("{}: is {} x {} pixels with {} channels: there is nothing in it.", name, width, height,
                     channels);
  if (width > kLongestSide || height > kLongestSide)
    throw InputError("{}: is {} x {} pixels; no side may be longer than {}.", name, width, height,
                     kLongestSide);
}

void checkImageFits(const std::string& name, int width, int height, int channels) {
  checkImageSides(name, width, height, channels);
  const double gigabytes = 4e-9 * width * height * channels;
  const double memory = machineGigabytes();
  // In files, a set may be larger than the memory, but no set is so large as to fill the disk.
  if (gigabytes > (ImagesInFiles::areBounded() ? 8 : 0.5) * memory)
    throw InputError(
        "{}: is {} x {} pixels with {} channels: that takes {:.1f} GB, this machine has {:.1f} GB. "
        "Scale or crop it (--memory of solve, relight and export takes larger ones).",
        name, width, height, channels, gigabytes, memory);
}

void checkBandFits(const std::string& name, size_t bytes) {
  const double memory = machineGigabytes();
  if (1e-9 * double(bytes) > 0.25 * memory)
    throw InputError(
        "{}: is stored in pieces of {:.1f} GB, this machine has {:.1f} GB. Write it again with smaller "
        "tiles.",
        name, 1e-9 * double(bytes), memory);
}

}  // namespace swaplight
