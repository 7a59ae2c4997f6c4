#include "core/export/frame_file.h"

#include <algorithm>
#include <array>
#include <functional>

#include "core/base/error.h"
#include "core/export/png_cicp.h"
#include "core/file/atomic_file.h"
#include "core/image/io/image_format.h"
#include "core/image/io/image_write_progress.h"
#include "core/image/layer_parts.h"
#include "core/ocio/icc_profile.h"
#include "core/ocio/luminance.h"

namespace swaplight {
namespace {

/// An EXR that is to be half float by default becomes float where light is brighter than half can hold, or
/// the frame so dark that half's steps show.
void keepInHalf(const Image& frame, const std::filesystem::path& file, WriteOptions& write) {
  if (!write.pixelType.empty() || imageFormatForWriting(file) != "openexr") return;
  const std::array<const Image*, 1> all{&frame};
  if (!fitsHalf(frame) || isDarkerThan(kDarkestInHalf, all)) write.pixelType = "float";
}

/// An EXR's colour is multiplied by its alpha; other formats hold it as it is.
void multiplyAlphaIn(Image& frame, const std::filesystem::path& file) {
  const int alpha = frame.channelIndex("A");
  if (alpha < 0 || imageFormatForWriting(file) != "openexr") return;
  for (int c = 0; c < 3; ++c)
    std::transform(frame.plane(c), frame.plane(c) + frame.pixelCount(), frame.plane(alpha), frame.plane(c),
                   std::multiplies<>());
}

}  // namespace

bool isSceneLinear(const std::filesystem::path& file) {
  const std::string format = imageFormatForWriting(file);
  return format == "openexr" || format == "hdr";
}

void checkSheetFile(const std::filesystem::path& file) {
  if (isSceneLinear(file))
    throw InputError("{}: a contact sheet is for the eye: give .png, .jpg or .tif", file.string());
}

void checkFrame(const ColorConfig& config, const std::filesystem::path& file, const FrameOptions& options) {
  const std::string format = imageFormatForWriting(file);
  if (!options.write.compression.empty()) {
    if (format != "openexr")
      throw InputError("{}: a compression is chosen of EXR: leave it out, or write .exr", file.string());
    checkExrCompression(options.write.compression, file.string());
  }
  if (options.tone && (options.linear || !options.display.empty()))
    throw InputError("a tone mapping takes the place of a view: ask for one of them");
  if (!options.colorSpace.empty()) config.checkLinear(options.colorSpace);
  if (format == "hdr" && !options.colorSpace.empty() && config.knownName(options.colorSpace) != "lin_rec709")
    throw InputError("{}: Radiance HDR holds lin_rec709, as it cannot say other primaries: write .exr",
                     file.string());
  if (!options.colorSpace.empty() && (options.tone || !options.display.empty()))
    throw InputError("a colour space is for scene-linear light, a view gives its own: ask for one of them");
  if (options.tone && isSceneLinear(file))
    throw InputError("{}: holds scene-linear light, which is not tone mapped; write PNG, TIFF or JPEG",
                     file.string());
  if (options.display.empty()) return;
  if (options.linear)
    throw InputError("a frame is either linear or seen through a view: ask for one of them");
  if (options.display.view.empty() && options.display.display.empty() && isSceneLinear(file))
    throw InputError("{}: holds scene-linear light, which no look is for; name a view too", file.string());
  config.checkView(options.display);
}

std::string frameContents(const ColorConfig& config, const std::filesystem::path& file,
                          const FrameOptions& options) {
  const bool light = options.display.empty() && !options.tone && (options.linear || isSceneLinear(file));
  if (light) return "scene-linear light";
  if (options.display.empty()) return "seen through sRGB";
  return "seen through " + displayWords(namedDisplay(config, options.display));
}

void writeCodes(Image codes, const std::filesystem::path& file, const DisplayChoice& display,
                WriteOptions write, const Progress& progress) {
  codes.setColorSpace(display.empty() ? "srgb" : "data");
  write.iccProfile = display.empty() ? iccProfileOf("sRGB", "") : iccProfileOf(display.display, display.view);
  multiplyAlphaIn(codes, file);
  const std::optional<CodePoints> codePoints = codePointsOf(display.display);
  if (!codePoints || imageFormatForWriting(file) != "png") {
    writeImage(codes, file, write, progress);
    return;
  }
  constexpr size_t kLargestPng = size_t{4} << 30;
  const AtomicFile plain(file);  // gives a name beside it
  writeImage(codes, plain.temporary(), write, progress);
  writeFile(file, withCicp(readFile(plain.temporary(), kLargestPng), *codePoints, file.string()));
}

void writeFrame(const ColorConfig& config, Image frame, const std::filesystem::path& file,
                FrameOptions options, const Progress& progress) {
  checkFrame(config, file, options);
  const std::string space = frame.spec().colorSpace;
  if (options.tone) {
    config.convert(frame.span(), space, "lin_rec709");
    applyStillTone(frame.span(), *options.tone);
    frame.setColorSpace("lin_rec709");
  }
  if (!options.display.empty()) {
    const DisplayChoice choice = namedDisplay(config, options.display);
    config.applyView(frame.span(), space, choice);
    writeCodes(std::move(frame), file, choice, options.write, progress);
    return;
  }
  if (!options.linear && !isSceneLinear(file)) {
    config.convert(frame.span(), frame.spec().colorSpace, "srgb");
    writeCodes(std::move(frame), file, {}, options.write, progress);
    return;
  }
  const std::string to = imageFormatForWriting(file) == "hdr" ? "lin_rec709" : options.colorSpace;
  if (!to.empty()) {
    config.convert(frame.span(), space, to);
    frame.setColorSpace(to);
    options.write.chromaticities = chromaticitiesIn(config, to);
  }
  multiplyAlphaIn(frame, file);
  keepInHalf(frame, file, options.write);
  writeImage(frame, file, options.write, progress);
}

}  // namespace swaplight
