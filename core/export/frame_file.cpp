#include "core/export/frame_file.h"

#include "core/base/error.h"
#include "core/export/png_cicp.h"
#include "core/file/atomic_file.h"
#include "core/image/half.h"
#include "core/image/io/image_format.h"
#include "core/image/io/image_write_progress.h"
#include "core/ocio/icc_profile.h"

namespace swaplight {
namespace {

/// An EXR that is to be half float by default becomes float where light is brighter than half can hold.
void keepInHalf(const Image& frame, const std::filesystem::path& file, WriteOptions& write) {
  if (!write.pixelType.empty() || imageFormatForWriting(file) != "openexr") return;
  for (int c = 0; c < frame.channelCount(); ++c)
    if (!fitsHalf(frame.plane(c), frame.pixelCount())) write.pixelType = "float";
}

}  // namespace

bool isSceneLinear(const std::filesystem::path& file) {
  const std::string format = imageFormatForWriting(file);
  return format == "openexr" || format == "hdr";
}

void checkFrame(const ColorConfig& config, const std::filesystem::path& file, const FrameOptions& options) {
  static_cast<void>(imageFormatForWriting(file));
  if (options.tone && (options.linear || !options.display.empty()))
    throw InputError("a tone mapping takes the place of a view: ask for one of them");
  if (!options.colorSpace.empty()) config.checkColorSpace(options.colorSpace);
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

void writeFrame(const ColorConfig& config, Image frame, const std::filesystem::path& file,
                FrameOptions options, const Progress& progress) {
  checkFrame(config, file, options);
  const std::string space = frame.spec().colorSpace;
  std::optional<CodePoints> codePoints;
  if (options.tone) {
    config.convert(frame.span(), space, "lin_rec709");
    applyStillTone(frame.span(), *options.tone);
    frame.setColorSpace("lin_rec709");
  }
  const bool seen = !options.display.empty() || (!options.linear && !isSceneLinear(file));
  if (!seen && !options.colorSpace.empty()) {
    config.convert(frame.span(), space, options.colorSpace);
    frame.setColorSpace(options.colorSpace);
  }
  if (!seen) keepInHalf(frame, file, options.write);
  if (!options.display.empty()) {
    const DisplayChoice choice = namedDisplay(config, options.display);
    config.applyView(frame.span(), space, choice);
    frame.setColorSpace("data");
    options.write.iccProfile = iccProfileOf(choice.display, choice.view);
    codePoints = codePointsOf(choice.display);
  } else if (!options.linear && !isSceneLinear(file)) {
    config.convert(frame.span(), frame.spec().colorSpace, "srgb");
    frame.setColorSpace("srgb");
    options.write.iccProfile = iccProfileOf("sRGB", "");
  }
  if (codePoints && imageFormatForWriting(file) == "png") {
    AtomicFile whole(file);
    writeImage(frame, whole.temporary(), options.write, progress);
    addCicp(whole.temporary(), *codePoints);
    whole.commit();
    return;
  }
  writeImage(frame, file, options.write, progress);
}

}  // namespace swaplight
