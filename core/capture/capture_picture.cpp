#include "core/capture/capture_picture.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/capture/capture_pixels.h"
#include "core/capture/jpeg/jpeg_coding.h"
#include "core/capture/mosaic_saturation.h"
#include "core/color/chromaticities.h"
#include "core/image/cropped_image.h"
#include "core/image/rgb_image.h"

namespace swaplight {
namespace {

/// The light of half the code over that of the whole is 1/2 where codes are linear, .214 in sRGB, less in
/// logs.
constexpr float kProportional = 0.45F;

/// In steps of a file's coding: values this little below white are saturated too. They stand for it after a
/// decoder's rounding; a whole step below is a value of its own.
constexpr float kWhiteMargin = 0.25F;

/// Noise makes dark pixels a little negative. What is darker is no noise, and is told: this part of full
/// scale (by judgement: a black level that is a little wrong is no damage), or this many standard deviations
/// of a read noise that is known, whichever is more: normal noise passes six in one of 10^9 pixels.
constexpr double kDarkest = 0.02;
constexpr double kReadDeviations = 6;

/// What brings the files' codes to linear light: a colour space of the configuration, or a measured response.
struct Coding {
  const ColorConfig& config;
  std::string from, to;
  const ResponseCurve* response = nullptr;

  void toLight(const ImageSpan& pixels) const {
    if (response)
      response->apply(pixels);
    else
      config.convert(pixels, from, to);
  }
};

/// A code value, the same in all channels, in linear light.
float linearOf(const Coding& coding, float code) {
  Image pixel(ImageSpec::rgb(1, 1), code);
  coding.toLight(pixel.span());
  return std::min({pixel.plane(0)[0], pixel.plane(1)[0], pixel.plane(2)[0]});
}

/// Where an integer file saturates, and the step below that, in linear light.
void describeCoding(const Coding& coding, CapturePicture& picture) {
  if (picture.info.isFloat) return;
  const int bits = codingBits(picture.image, picture.info.bits);
  const float step = 1.0F / static_cast<float>((1 << std::clamp(bits, 1, 16)) - 1);
  const float white = linearOf(coding, 1);
  picture.quantum = white - linearOf(coding, 1 - step);
  picture.clip = white - kWhiteMargin * picture.quantum;
  if (linearOf(coding, 0.5F) < kProportional * white)
    picture.rounding = roundingErrors([&](float code) { return linearOf(coding, code); }, step);
}

/// What the coding of a JPEG has left, in linear light: an error of code times the slope of the curve there.
void measureCodingError(const Coding& coding, CapturePicture& picture) {
  const auto jpeg = readJpegCoding(picture.file);
  if (!jpeg) return;
  picture.codingError = jpegError(picture.image.view(), *jpeg);
  constexpr float kAround = 0.5F / 255;
  const int count = static_cast<int>(picture.codingError.size());
  Image codes(ImageSpec::rgb(std::max(count, 1), 2), 0);
  for (int j = 0; j < count; ++j)
    for (int c = 0; c < 3; ++c) {
      const float code = picture.codingError[static_cast<size_t>(j)].value;
      codes.span().row(c, 0)[j] = std::max(code - kAround, 0.0F);
      codes.span().row(c, 1)[j] = std::max(code - kAround, 0.0F) + 2 * kAround;
    }
  coding.toLight(codes.span());
  for (int j = 0; j < count; ++j) {
    ValueVariance& at = picture.codingError[static_cast<size_t>(j)];
    const float below = codes.view().row(1, 0)[j];
    const float above = codes.view().row(1, 1)[j];
    const float slope = (above - below) / (2 * kAround);
    at = {(below + above) / 2, at.variance * slope * slope};
  }
}

/// No sensor's noise makes pixels more negative than this.
float lowestCredible(const Capture& capture) {
  return -static_cast<float>(std::max(kDarkest, capture.noise ? kReadDeviations * capture.noise->read : 0.0));
}

/// Describes a damaged picture.
void warnOfPixels(CapturePicture& picture) {
  const PixelCounts& counts = picture.counts;
  if (counts.notFinite > 0)
    picture.warnings.push_back(fmt::format("{}: {} pixel{} not finite", picture.file.string(),
                                           counts.notFinite, counts.notFinite == 1 ? " is" : "s are"));
  if (counts.negative > 0)
    picture.warnings.push_back(fmt::format("{}: {} pixel{} negative", picture.file.string(), counts.negative,
                                           counts.negative == 1 ? " is" : "s are"));
}

/// Describes colours that are not what the capture calls them. What a person named is taken, and said.
void warnOfColors(const std::string& colorSpace, CapturePicture& picture) {
  const std::string& stated = picture.info.statedColors;
  const bool known = colorSpace == "lin_rec709" || chromaticitiesOf(colorSpace) || colorSpace == "srgb";
  if (stated.empty() || stated == colorSpace || !known) return;
  picture.warnings.push_back(
      fmt::format("{}: says that its colours are {}; they are taken as {}, as the capture says. Where that "
                  "is wrong, name their colour space there",
                  picture.file.string(), stated, colorSpace));
}

/// Channels of whole numbers, such as IDs, that are too large for the float that they are carried as.
std::vector<std::string> inexactIntegers(const ImageFile& file) {
  constexpr float kMostExact = 1 << 24;
  std::vector<std::string> channels;
  for (int c = 0; c < file.image.channelCount(); ++c) {
    const float* plane = file.image.plane(c);
    const auto isLarge = [](float value) { return value >= kMostExact; };
    if (file.info.channelTypes[size_t(c)] == PixelType::UInt32 &&
        std::any_of(plane, plane + file.image.pixelCount(), isLarge))
      channels.push_back(file.image.spec().channels[size_t(c)]);
  }
  return channels;
}

}  // namespace

CapturePicture readCapturePicture(const ColorConfig& config, const Capture& capture,
                                  const ResponseCurve* response, const std::string& path) {
  CapturePicture picture;
  picture.file = capture.folder / path;
  ImageFile file = readImage(picture.file);
  picture.info = file.info;
  const std::array<int, 3> colors = rgbChannels(file.image, picture.file);
  if (capture.frame.isWhole()) {
    picture.carried = carriedData(file.image, picture.info, colors);
    picture.inexact = inexactIntegers(file);
  } else {  // channels beside the colour are of all its pixels
    std::vector<int> all(static_cast<size_t>(file.image.channelCount()));
    std::iota(all.begin(), all.end(), 0);
    picture.carried = carriedData(file.image, picture.info, all);
    if (picture.carried) picture.carried->dataWindow.reset();
  }
  picture.image = rgbImage(std::move(file.image), picture.file);
  const PixelRect whole{0, 0, picture.image.width(), picture.image.height()};
  const PixelRect held = picture.info.dataWindow.value_or(whole);
  picture.window = intersection(held, whole);
  picture.hasOverscan = enclosing(held, whole) != whole;
  const std::string to = linearSpaceOf(capture.colorSpace);
  // The coding's blocks begin at the corner of the whole picture.
  Coding coding{config, capture.colorSpace, to, response};
  if (picture.info.format == "jpeg") measureCodingError(coding, picture);
  if (const auto& crop = capture.frame.crop) {
    picture.image = croppedImage(picture.image, *crop, picture.file.string());
    picture.window = intersection(picture.window, *crop);
    picture.window.x -= crop->x, picture.window.y -= crop->y;
  }
  if (picture.info.format == "raw" && coding.from != to) {
    picture.warnings.push_back(fmt::format("{}: camera raw is linear: the colour space {} is not applied",
                                           picture.file.string(), coding.from));
    coding.from = to;
    coding.response = nullptr;
  }
  describeCoding(coding, picture);
  warnOfColors(coding.from, picture);
  if (picture.info.format == "raw") spreadSaturation(picture.image, picture.clip);
  coding.toLight(picture.image.span());
  picture.image.setColorSpace(to);
  picture.counts = countPixels(picture.image, lowestCredible(capture));
  warnOfPixels(picture);
  return picture;
}

}  // namespace swaplight
