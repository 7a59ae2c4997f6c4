#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/capture/capture.h"

namespace swaplight {

/// Photographs beside a capture's shots that are not used: "left_out" of its file, each as a shot with the
/// colours that are told of it.
[[nodiscard]] std::vector<Shot> leftOutOf(const Capture& capture);
[[nodiscard]] Capture withLeftOut(Capture capture, const std::vector<Shot>& leftOut);

/// A capture without the shots of these pictures, which join those that are left out, colours and all. The
/// exposures stay over the shot that was the first one. Throws InputError, which begins with `where`: a
/// picture that is no shot's, or nothing that remains.
[[nodiscard]] Capture withShotsLeftOut(Capture capture, const std::vector<std::string>& images,
                                       const std::string& where);

/// What is said where a photograph that is to be left out is not there, and where none would remain.
[[nodiscard]] InputError noPhotographToLeaveOut(const std::string& where, const std::string& image,
                                                const std::vector<std::string>& images);
[[nodiscard]] InputError nothingIsLeft(const std::string& where);

[[nodiscard]] std::vector<std::string> imagesOf(const std::vector<Shot>& shots);
/// "a.exr, b.exr"
[[nodiscard]] std::string leftOutWords(const std::vector<Shot>& leftOut);

}  // namespace swaplight
