#pragma once

#include <filesystem>
#include <string>

namespace swaplight {

/// The format of a picture by its first bytes (camera raw: by its extension): openexr, png, tiff, jpeg, hdr
/// or raw, as OpenImageIO calls them. Throws InputError where the file is missing, empty, or none of these.
[[nodiscard]] std::string imageFormatOf(const std::filesystem::path& file);

/// The format that a file's extension asks for when writing: openexr, png, tiff, jpeg or hdr. Throws
/// InputError that lists the extensions.
[[nodiscard]] std::string imageFormatForWriting(const std::filesystem::path& file);

/// libjpeg ends the process where it is asked for more.
inline constexpr int kLongestJpegSide = 65500;

/// This machine's memory.
[[nodiscard]] double machineGigabytes();

/// Throws InputError where a picture is empty or longer than any may be; `name` is the file.
void checkImageSides(const std::string& name, int width, int height, int channels);

/// The same, and where it would take more than half of this machine's memory; where images are bounded and
/// lie in files (ImagesInFiles), eight times the memory.
void checkImageFits(const std::string& name, int width, int height, int channels);

/// Throws InputError where the rows that are decoded at once, which are always in memory, would not fit.
void checkBandFits(const std::string& name, size_t bytes);

/// Finds what decoders pass over without a word or complain of on standard error: a JPEG that ends in the
/// middle of its picture (they pad it with grey), a PNG that ends early or whose checksums are wrong, an EXR
/// whose header lies about lengths. Takes no memory to speak of. Throws InputError.
void checkIntegrity(const std::filesystem::path& file, const std::string& format);

}  // namespace swaplight
