#include "core/capture/capture_pixels.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/capture/mosaic_saturation.h"
#include "core/capture/response_curve.h"
#include "core/capture/sensor_limits.h"
#include "core/color/chromaticities.h"
#include "core/image/cropped_image.h"
#include "core/image/finite_image.h"
#include "core/image/images_in_files.h"
#include "core/image/io/image_format.h"
#include "core/image/rgb_image.h"
#include "core/ocio/color_config.h"

namespace swaplight {
namespace {

constexpr float kNoClip = std::numeric_limits<float>::infinity();
constexpr int kRowsAtOnce = 64;  // rows

/// The light of half the code over that of the whole is 1/2 where codes are linear, .214 in sRGB, less in
/// logs.
constexpr float kProportional = 0.45F;

/// In steps of a file's coding: values this little below white are saturated too. They stand for it after a
/// decoder's rounding; a whole step below is a value of its own.
constexpr float kWhiteMargin = 0.25F;

constexpr int kRoundings = 17;           // codes, evenly, whose rounding is looked at
constexpr float kLeastRounding = 1e-4F;  // of the variance at white: no pixel is known better than that

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

/// A picture of the capture, as read and in linear light.
struct Picture {
  std::filesystem::path file;
  Image image;
  ImageFileInfo info;
  PixelRect window;  ///< of the image: what the file holds of it
  bool hasOverscan = false;
  PixelCounts counts;
  float clip = kNoClip;  ///< of integer files
  float quantum = 0;
  std::vector<ValueVariance> rounding;     ///< of codes that are not proportional to light
  std::vector<ValueVariance> codingError;  ///< linear light
  std::shared_ptr<CarriedData> carried;
  std::vector<std::string> inexact;  ///< channels
  std::vector<std::string> warnings;
};

/// A code value, the same in all channels, in linear light.
float linearOf(const Coding& coding, float code) {
  Image pixel(ImageSpec::rgb(1, 1), code);
  coding.toLight(pixel.span());
  return std::min({pixel.plane(0)[0], pixel.plane(1)[0], pixel.plane(2)[0]});
}

/// Where an integer file saturates, and the step below that, in linear light.
void describeCoding(const Coding& coding, Picture& picture) {
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
void measureCodingError(const Coding& coding, Picture& picture) {
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
void warnOfPixels(Picture& picture) {
  const PixelCounts& counts = picture.counts;
  if (counts.notFinite > 0)
    picture.warnings.push_back(fmt::format("{}: {} pixel{} not finite", picture.file.string(),
                                           counts.notFinite, counts.notFinite == 1 ? " is" : "s are"));
  if (counts.negative > 0)
    picture.warnings.push_back(fmt::format("{}: {} pixel{} negative", picture.file.string(), counts.negative,
                                           counts.negative == 1 ? " is" : "s are"));
}

/// Describes colours that are not what the capture calls them. What a person named is taken, and said.
void warnOfColors(const std::string& colorSpace, Picture& picture) {
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

PixelRect boundsOf(const Image& image) {
  return {0, 0, image.width(), image.height()};
}

Picture readPicture(const ColorConfig& config, const Capture& capture, const ResponseCurve* response,
                    const std::string& path) {
  Picture picture;
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
  const PixelRect whole = boundsOf(picture.image);
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

/// The paths of a capture's pictures: its shots, then ambient, then dark.
struct PictureList {
  explicit PictureList(const Capture& capture) {
    for (const Shot& shot : capture.shots) paths.push_back(shot.image);
    if (capture.ambient) paths.push_back(*capture.ambient);
    if (capture.dark) paths.push_back(*capture.dark);
  }
  std::vector<std::string> paths;
};

void checkSizes(std::span<const Picture> pictures) {
  const Picture& first = pictures.front();
  for (const Picture& picture : pictures)
    if (picture.image.width() != first.image.width() || picture.image.height() != first.image.height())
      throw InputError("{} is {} x {} pixels, {} is {} x {}. Export all pictures of a capture at one size.",
                       picture.file.string(), picture.image.width(), picture.image.height(),
                       first.file.string(), first.image.width(), first.image.height());
}

/// What all pictures hold of the picture.
PixelRect commonWindow(std::span<const Picture> pictures) {
  PixelRect common = pictures.front().window;
  for (const Picture& picture : pictures) {
    common = intersection(common, picture.window);
    if (common.empty())
      throw InputError(
          "{}: its data window holds nothing of what the crop and the photographs before it leave. Export "
          "all "
          "pictures of a capture with the same data window.",
          picture.file.string());
  }
  return common;
}

/// A rectangle of a picture that is scaled: the pixels that nothing outside has gone into.
PixelRect scaledWindow(const PixelRect& window, const PixelRect& from, const PixelRect& to) {
  const auto first = [](int64_t begin, int size, int scaled) {
    return static_cast<int>((begin * scaled + size - 1) / size);
  };
  const auto last = [](int64_t end, int size, int scaled) { return static_cast<int>(end * scaled / size); };
  const int x = first(window.x, from.width, to.width), y = first(window.y, from.height, to.height);
  return {x, y, last(window.right(), from.width, to.width) - x,
          last(window.bottom(), from.height, to.height) - y};
}

/// Where the pictures leave out a part, keeps with the pixels what is left.
void keepWindow(std::span<const Picture> pictures, const PixelRect& whole, CapturePixels& pixels) {
  const PixelRect common = commonWindow(pictures);
  const PixelRect bounds = boundsOf(pixels.shots.front());
  const PixelRect window = bounds == whole ? common : scaledWindow(common, whole, bounds);
  if (window == bounds) return;
  if (window.empty())
    throw InputError("{}: the scale leaves no pixel of its data window. Choose a larger one.",
                     pictures.front().file.string());
  const auto carried = pictures.front().carried ? pictures.front().carried : std::make_shared<CarriedData>();
  carried->dataWindow = window;
  pixels.carried = carried;
  const auto differs = [&](const Picture& picture) { return picture.window != common; };
  if (std::any_of(pictures.begin(), pictures.end(), differs))
    pixels.warnings.push_back(fmt::format(
        "the data windows of the photographs differ: only what all of them hold is solved, {},{},{},{}",
        window.x, window.y, window.width, window.height));
}

/// The picture is the display window.
void warnOfOverscan(std::span<const Picture> pictures, CapturePixels& pixels) {
  if (std::any_of(pictures.begin(), pictures.end(), std::mem_fn(&Picture::hasOverscan)))
    pixels.warnings.emplace_back(
        "the photographs hold pixels outside of their display window (overscan): they are left out");
}

/// Takes the dark picture off. Saturated pixels stay: they tell nothing but that they are saturated. Where
/// the dark picture is not finite, nothing is taken off.
void subtractDark(Image& image, const Image& dark, float clip) {
  parallelRows(image.height(), kRowsAtOnce, [&](int begin, int end) {
    const size_t first = static_cast<size_t>(begin) * static_cast<size_t>(image.width());
    const size_t last = static_cast<size_t>(end) * static_cast<size_t>(image.width());
    for (int c = 0; c < 3; ++c) {
      float* value = image.plane(c);
      const float* offset = dark.plane(c);
      for (size_t p = first; p < last; ++p)
        if (value[p] < clip && std::isfinite(offset[p])) value[p] -= offset[p];
    }
  });
}

void scaleDown(CapturePixels& pixels, double scale) {
  // Between noise of single pixels (scale^2) and one that all neighbours share: blocks, colour of several
  // pixels. Measured: .55 of the variance in means of 2 x 2 pixels, .2 in those of 4 x 4.
  for (ValueVariance& at : pixels.codingError) at.variance *= float(scale);
  for (size_t k = 0; k < pixels.shots.size(); ++k)
    pixels.shots[k] = scaledImage(pixels.shots[k], scale, pixels.clipLevel[k]);
  if (pixels.ambient) pixels.ambient = scaledImage(*pixels.ambient, scale, kNoClip);
}

/// All pictures of a capture are of one size: the first one says what all of them take.
void checkAllFit(const Capture& capture, size_t pictures) {
  constexpr double kShare = 0.8;       // of the memory
  constexpr double kBytesAPixel = 12;  // of R G B
  const std::filesystem::path file = capture.folder / capture.shots.front().image;
  const ImageSpec spec = readImageSpec(file);
  const double gigabytes = 1e-9 * kBytesAPixel * double(spec.width) * double(spec.height) * double(pictures);
  if (ImagesInFiles::areBounded()) return;  // the disk has room, or says so
  if (gigabytes > kShare * machineGigabytes())
    throw InputError(
        "{}: is {} x {} pixels, and there are {} pictures of that size: they take {:.1f} GB, this machine "
        "has {:.1f} GB. Scale or crop them; swaplight solve --memory takes larger ones.",
        file.string(), spec.width, spec.height, pictures, gigabytes, machineGigabytes());
}

/// Reads every picture, several at a time: most decoders use one core.
std::vector<Picture> readPictures(const ColorConfig& config, const Capture& capture,
                                  const ResponseCurve* response, const Progress& progress) {
  const std::vector<std::string> paths = PictureList(capture).paths;
  checkAllFit(capture, paths.size());
  std::vector<Picture> pictures(paths.size());
  std::atomic<int> done = 0;
  progress.update(0, "reading pictures");
  parallelEach(static_cast<int>(paths.size()), [&](int i) {
    const auto index = static_cast<size_t>(i);
    pictures[index] = readPicture(config, capture, response, paths[index]);
    progress.update(static_cast<float>(++done) / static_cast<float>(paths.size()), "reading pictures");
  });
  return pictures;
}

}  // namespace

std::string linearSpaceOf(const std::string& colorSpace) {
  return chromaticitiesOf(colorSpace) ? colorSpace : "lin_rec709";
}

std::vector<ValueVariance> roundingErrors(const std::function<float(float)>& light, float step) {
  constexpr float kAround = 0.5F / (kRoundings - 1);
  const auto slopeAt = [&](float code) {
    const float below = std::max(code - kAround, 0.0F), above = std::min(code + kAround, 1.0F);
    return (light(above) - light(below)) / (above - below);
  };
  const float white = (light(1) - light(1 - step)) / step;
  if (!(white > 0)) return {};
  std::vector<ValueVariance> errors;
  for (int j = 0; j < kRoundings; ++j) {
    const float code = static_cast<float>(j) / (kRoundings - 1);
    const float times = slopeAt(code) / white;
    errors.push_back({std::max(light(code), 0.0F), std::max(times * times, kLeastRounding)});
  }
  return errors;
}

CapturePixels withoutShots(const CapturePixels& pixels) {
  return {{},
          pixels.ambient ? std::optional(pixels.ambient->clone()) : std::nullopt,
          pixels.clipLevel,
          pixels.quantum,
          pixels.rounding,
          pixels.codingError,
          pixels.carried,
          pixels.warnings,
          pixels.clippedLift};
}

CapturePixels loadCapturePixels(const ColorConfig& config, const Capture& capture, const Progress& progress) {
  std::optional<ResponseCurve> response;
  if (isResponseFile(capture.colorSpace)) response = readResponse(capture.folder / capture.colorSpace);
  try {
    if (!response) config.checkColorSpace(capture.colorSpace);
  } catch (const InputError& error) {
    throw InputError("{}: {}", capture.file.empty() ? "the capture" : capture.file.string(), error.what());
  }
  std::vector<Picture> pictures = readPictures(config, capture, response ? &*response : nullptr, progress);
  checkSizes(pictures);
  const PixelRect whole = boundsOf(pictures.front().image);

  CapturePixels pixels;
  pixels.carried = pictures.front().carried;
  std::vector<PixelCounts> counts;
  const size_t shotCount = capture.shots.size();
  for (size_t k = 0; k < shotCount; ++k) {
    pixels.shots.push_back(std::move(pictures[k].image));
    pixels.clipLevel.push_back(pictures[k].clip);
    pixels.quantum.push_back(pictures[k].quantum);
    counts.push_back(pictures[k].counts);
    if (pixels.rounding.empty()) pixels.rounding = std::move(pictures[k].rounding);
    const auto& error = pictures[k].codingError;
    pixels.codingError.insert(pixels.codingError.end(), error.begin(), error.end());
  }
  const float floatClip = floatClipLevel(pixels.shots, counts);
  for (size_t k = 0; k < shotCount; ++k)
    if (pictures[k].info.isFloat) pixels.clipLevel[k] = floatClip;

  size_t next = shotCount;
  if (capture.ambient) pixels.ambient = std::move(pictures[next++].image);
  if (capture.dark) {
    const Image& dark = pictures[next].image;
    for (size_t k = 0; k < shotCount; ++k) subtractDark(pixels.shots[k], dark, pixels.clipLevel[k]);
    if (pixels.ambient) subtractDark(*pixels.ambient, dark, kNoClip);
  }
  if (pixels.ambient) makeFinite(*pixels.ambient);
  if (capture.frame.scale != 1) scaleDown(pixels, capture.frame.scale);
  keepWindow(pictures, whole, pixels);
  warnOfOverscan(pictures, pixels);
  if (const Picture& first = pictures.front(); !first.inexact.empty())
    pixels.warnings.push_back(
        fmt::format("{}: whole numbers above 16777216 are carried rounded, as float: {}", first.file.string(),
                    fmt::join(first.inexact, ", ")));
  for (Picture& picture : pictures)
    for (std::string& warning : picture.warnings) pixels.warnings.push_back(std::move(warning));
  return pixels;
}

}  // namespace swaplight
