#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace swaplight {

/// How a JPEG file rounds what it keeps of a picture: YCbCr, the cosine transforms of 8 x 8 blocks.
struct JpegCoding {
  static constexpr int kCoefficients = 64;
  /// Of Y, Cb, Cr: the step of every coefficient, in 8-bit codes, [8 vertical + horizontal frequency].
  std::array<std::array<uint16_t, kCoefficients>, 3> steps{};
  int chromaX = 1, chromaY = 1;  ///< pixels that one value of Cb and Cr stands for
};

/// Of a JPEG file's header (ITU-T T.81, B.2: the segments DQT and SOF). Nothing for other files, for those
/// that hold no YCbCr of 8 bits, and for broken ones: readImage says what is wrong with them.
[[nodiscard]] std::optional<JpegCoding> readJpegCoding(const std::filesystem::path& file);

}  // namespace swaplight
