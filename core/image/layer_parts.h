#pragma once

#include <span>
#include <string>

#include "core/image/image.h"
#include "core/image/image_parts.h"

namespace swaplight {

/// Whether half float holds the image: no value is NaN or beyond +-65504.
[[nodiscard]] bool fitsHalf(const Image& image);

/// Whether the sum of images of one size is darker than this in the mean of its colours (the first three
/// channels), and not black, so that half float's steps (6e-8) show. Of a sample of the pixels; what is not
/// finite is left out.
[[nodiscard]] bool isDarkerThan(double mean, std::span<const Image* const> images);

/// Of a frame of this mean half float holds the mean to .6 %, a tenth of it to 6 %: a darker one is written
/// as float.
inline constexpr double kDarkestInHalf = 1e-5;

/// The type to write images in that belong together: the one asked for, or Float where that is Half and one
/// of them does not fit into it.
[[nodiscard]] PixelType typeThatHolds(std::span<const Image> images, PixelType asked);

/// The sum of R, G, B layers (one at least, all of one size) as a reader of their file will see them: each
/// rounded to `type` (Half or Float) first and added in their order, in float, so that it equals what a
/// compositor gets by adding them up. It may be brighter than half can hold where no layer is.
[[nodiscard]] Image sumOfLayers(std::span<const Image* const> layers, PixelType type);

/// An image as a part of a file, its channels under these names. Refers to the image's pixels.
[[nodiscard]] PartToWrite imagePart(const std::string& name, const Image& image,
                                    std::span<const std::string> channels, PixelType type);
/// The same of a picture: R, G and B.
[[nodiscard]] PartToWrite colorPart(const std::string& name, const Image& picture, PixelType type);

/// What the part of the sum is called, whose channels are plain R, G and B in a file of one part.
inline constexpr const char* kSumPart = "rgb";

/// One part of several; their names become layers (`name.R`), but for a first one called rgb.
[[nodiscard]] PartToWrite mergedParts(std::span<const PartToWrite> parts);

}  // namespace swaplight
