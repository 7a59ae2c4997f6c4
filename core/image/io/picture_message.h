#pragma once

#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "core/image/io/picture_source.h"

namespace swaplight {

/// What the process that decodes a picture is asked, and what it says. Bytes that may come from a process
/// that a picture has taken over: whatever is read here is checked.

struct PictureRequest {
  std::filesystem::path file;
  int threads = 1;
};
[[nodiscard]] std::string messageOf(const PictureRequest& request);
[[nodiscard]] PictureRequest pictureRequestOf(const std::string& message);

struct PictureAnswer {
  PictureContents contents;
  size_t bandBytes = 0;
};
[[nodiscard]] std::string messageOf(const PictureAnswer& answer);

/// A band that is in the shared memory now, and in which half of it.
struct BandAnswer {
  PictureBand band;
  int slot = 0;
  bool last = false;  ///< no band: all are read
};
[[nodiscard]] std::string messageOf(const BandAnswer& answer);

/// What went wrong in the other process, to be thrown in this one.
[[nodiscard]] std::string messageOf(std::exception_ptr error);

/// These throw what the other process has thrown, and std::runtime_error for what is no such message.
/// Contents and bands fit together and into the memory when they come back.
[[nodiscard]] PictureAnswer pictureAnswerOf(const std::string& message, const std::string& file);
[[nodiscard]] BandAnswer bandAnswerOf(const std::string& message, const PictureAnswer& picture);

}  // namespace swaplight
