#include "core/capture/left_out.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace swaplight {

std::vector<std::string> imagesOf(const std::vector<Shot>& shots) {
  std::vector<std::string> images;
  for (const Shot& shot : shots) images.push_back(shot.image);
  return images;
}

InputError noPhotographToLeaveOut(const std::string& where, const std::string& image,
                                  const std::vector<std::string>& images) {
  return InputError("{}: there is no photograph \"{}\" to leave out; those in use are {}", where, image,
                    fmt::join(images, ", "));
}

InputError nothingIsLeft(const std::string& where) {
  return InputError("{}: leaves out all photographs. Keep at least as many as there are lights.", where);
}

Capture withShotsLeftOut(Capture capture, const std::vector<std::string>& images, const std::string& where) {
  if (images.empty()) return capture;
  std::vector<Shot> leftOut = leftOutOf(capture);
  for (const std::string& image : images) {
    const auto found = std::find_if(capture.shots.begin(), capture.shots.end(),
                                    [&](const Shot& shot) { return shot.image == image; });
    if (found == capture.shots.end()) throw noPhotographToLeaveOut(where, image, imagesOf(capture.shots));
    leftOut.push_back(std::move(*found));
    capture.shots.erase(found);
    if (capture.shots.empty()) throw nothingIsLeft(where);
  }
  return withLeftOut(std::move(capture), leftOut);
}

std::string leftOutWords(const std::vector<Shot>& leftOut) {
  return fmt::format("{}", fmt::join(imagesOf(leftOut), ", "));
}

}  // namespace swaplight
