#include "core/capture/capture_pixels.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/capture/capture_picture.h"
#include "core/capture/response_curve.h"
#include "core/capture/sensor_limits.h"
#include "core/color/chromaticities.h"
#include "core/image/finite_image.h"
#include "core/image/images_in_files.h"
#include "core/image/io/image_format.h"

namespace swaplight {
namespace {

constexpr float kNoClip = std::numeric_limits<float>::infinity();
constexpr int kRowsAtOnce = 64;  // rows

constexpr int kRoundings = 17;           // codes, evenly, whose rounding is looked at
constexpr float kLeastRounding = 1e-4F;  // of the variance at white: no pixel is known better than that

/// The paths of a capture's pictures: its shots, then ambient, then dark.
struct PictureList {
  explicit PictureList(const Capture& capture) {
    for (const Shot& shot : capture.shots) paths.push_back(shot.image);
    if (capture.ambient) paths.push_back(*capture.ambient);
    if (capture.dark) paths.push_back(*capture.dark);
  }
  std::vector<std::string> paths;
};

void checkSizes(std::span<const CapturePicture> pictures) {
  const CapturePicture& first = pictures.front();
  for (const CapturePicture& picture : pictures)
    if (picture.image.width() != first.image.width() || picture.image.height() != first.image.height())
      throw InputError("{} is {} x {} pixels, {} is {} x {}. Export all pictures of a capture at one size.",
                       picture.file.string(), picture.image.width(), picture.image.height(),
                       first.file.string(), first.image.width(), first.image.height());
}

PixelRect boundsOf(const Image& image) {
  return {0, 0, image.width(), image.height()};
}

/// What all pictures hold of the picture.
PixelRect commonWindow(std::span<const CapturePicture> pictures) {
  PixelRect common = pictures.front().window;
  for (const CapturePicture& picture : pictures) {
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
void keepWindow(std::span<const CapturePicture> pictures, const PixelRect& whole, CapturePixels& pixels) {
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
  const auto differs = [&](const CapturePicture& picture) { return picture.window != common; };
  if (std::any_of(pictures.begin(), pictures.end(), differs))
    pixels.warnings.push_back(fmt::format(
        "the data windows of the photographs differ: only what all of them hold is solved, {},{},{},{}",
        window.x, window.y, window.width, window.height));
}

/// The picture is the display window.
void warnOfOverscan(std::span<const CapturePicture> pictures, CapturePixels& pixels) {
  if (std::any_of(pictures.begin(), pictures.end(), std::mem_fn(&CapturePicture::hasOverscan)))
    pixels.warnings.emplace_back(
        "the photographs hold pixels outside of their display window (overscan): they are left out");
}

/// A photograph under a second name would count as taken under other lights. One of a single colour (a lens
/// cap) says nothing.
void checkPicturesDiffer(const Capture& capture, std::span<const CapturePicture> pictures) {
  const auto inEachChannel = [](const Image& image, const auto& holds) {
    for (int c = 0; c < 3; ++c)
      if (!holds(std::span(image.plane(c), image.pixelCount()), c)) return false;
    return true;
  };
  const auto isPlain = [&](const Image& image) {
    return inEachChannel(image, [](std::span<const float> values, int) {
      return std::count(values.begin(), values.end(), values.front()) == std::ssize(values);
    });
  };
  const auto isSame = [&](const Image& one, const Image& other) {
    return inEachChannel(one, [&](std::span<const float> values, int c) {
      return std::equal(values.begin(), values.end(), other.plane(c));
    });
  };
  for (size_t k = 0; k < capture.shots.size(); ++k)
    for (size_t j = 0; j < k; ++j)
      if (capture.shots[j].lightColors != capture.shots[k].lightColors &&
          capture.shots[j].crossed == capture.shots[k].crossed &&  // the solve of those says more
          isSame(pictures[j].image, pictures[k].image) && !isPlain(pictures[k].image))
        throw InputError(
            "{}: holds the same picture as {}, which was taken under other colours. Every shot has a "
            "photograph of its own: check the files.",
            pictures[k].file.string(), pictures[j].file.filename().string());
}

void checkHasNumbers(const CapturePicture& picture) {
  for (int c = 0; c < 3; ++c) {
    const float* values = picture.image.plane(c);
    if (std::none_of(values, values + picture.image.pixelCount(),
                     [](float value) { return std::isfinite(value); }))
      throw InputError("{}: no pixel of it is a number. Export it again, or leave it out.",
                       picture.file.string());
  }
}

/// Takes the dark picture off. Saturated pixels stay: they tell nothing but that they are saturated. Where
/// the dark picture is not finite nobody knows what to take off: there the picture is none, either.
void subtractDark(Image& image, const Image& dark, float clip) {
  parallelRows(image.height(), kRowsAtOnce, [&](int begin, int end) {
    const size_t first = static_cast<size_t>(begin) * static_cast<size_t>(image.width());
    const size_t last = static_cast<size_t>(end) * static_cast<size_t>(image.width());
    for (int c = 0; c < 3; ++c) {
      float* value = image.plane(c);
      const float* offset = dark.plane(c);
      for (size_t p = first; p < last; ++p)
        if (value[p] < clip) value[p] = std::isfinite(offset[p]) ? value[p] - offset[p] : NAN;
    }
  });
}

/// Where the ambient picture is no number, what the lamps give is not known: the shots are none there,
/// either.
void loseWhereAmbientIsLost(CapturePixels& pixels) {
  Image& ambient = *pixels.ambient;
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < ambient.pixelCount(); ++p)
      if (!std::isfinite(ambient.plane(c)[p]))
        for (Image& shot : pixels.shots) shot.plane(c)[p] = NAN;
  makeFinite(ambient);
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
        "has {:.1f} GB. Scale or crop them (--memory of swaplight solve takes larger ones).",
        file.string(), spec.width, spec.height, pictures, gigabytes, machineGigabytes());
}

/// Reads every picture, several at a time: most decoders use one core.
std::vector<CapturePicture> readPictures(const ColorConfig& config, const Capture& capture,
                                         const ResponseCurve* response, const Progress& progress) {
  const std::vector<std::string> paths = PictureList(capture).paths;
  checkAllFit(capture, paths.size());
  std::vector<CapturePicture> pictures(paths.size());
  std::atomic<int> done = 0;
  progress.update(0, "reading pictures");
  parallelEach(static_cast<int>(paths.size()), [&](int i) {
    const auto index = static_cast<size_t>(i);
    pictures[index] = readCapturePicture(config, capture, response, paths[index]);
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
  std::vector<CapturePicture> pictures =
      readPictures(config, capture, response ? &*response : nullptr, progress);
  checkSizes(pictures);
  checkPicturesDiffer(capture, pictures);
  std::for_each(pictures.begin() + static_cast<ptrdiff_t>(capture.shots.size()), pictures.end(),
                checkHasNumbers);
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
  if (pixels.ambient) loseWhereAmbientIsLost(pixels);
  if (capture.frame.scale != 1) scaleDown(pixels, capture.frame.scale);
  keepWindow(pictures, whole, pixels);
  warnOfOverscan(pictures, pixels);
  if (const CapturePicture& first = pictures.front(); !first.inexact.empty())
    pixels.warnings.push_back(
        fmt::format("{}: whole numbers above 16777216 are carried rounded, as float: {}", first.file.string(),
                    fmt::join(first.inexact, ", ")));
  for (CapturePicture& picture : pictures)
    for (std::string& warning : picture.warnings) pixels.warnings.push_back(std::move(warning));
  return pixels;
}

}  // namespace swaplight
