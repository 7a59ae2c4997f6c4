#include "core/balance/photograph.h"

#include "core/base/error.h"
#include "core/capture/response_curve.h"
#include "core/color/chromaticities.h"
#include "core/image/io/image_io.h"

namespace swaplight {

std::string colorSpaceOfPhotograph(const ColorConfig& config, const Capture& capture,
                                   const std::filesystem::path& file) {
  if (std::string ruled = config.colorSpaceOfFile(file); !ruled.empty()) return ruled;
  ImageFileInfo info;
  const ImageSpec spec = readImageSpec(file, &info);
  const bool coded = !info.isFloat && info.format != "raw";
  if (coded && isResponseFile(capture.colorSpace)) return (capture.folder / capture.colorSpace).string();
  if (coded && !chromaticitiesOf(capture.colorSpace)) return capture.colorSpace;
  return spec.colorSpace;
}

CapturePixels loadPhotograph(const ColorConfig& config, const std::filesystem::path& file,
                             const std::string& colorSpace, const Progress& progress) {
  Capture photograph;
  photograph.file = file;
  photograph.colorSpace = colorSpace.empty() ? colorSpaceOfPhotograph(config, photograph, file) : colorSpace;
  photograph.shots.emplace_back().image = std::filesystem::absolute(file).string();
  return loadCapturePixels(config, photograph, progress);
}

CapturePixels loadPhotographOf(const ColorConfig& config, const SolvedSet& set,
                               const std::filesystem::path& file, const std::string& colorSpace,
                               const Progress& progress) {
  Capture photograph;
  photograph.file = file;
  photograph.colorSpace = colorSpace.empty() ? colorSpaceOfPhotograph(config, set.capture, file) : colorSpace;
  photograph.frame = set.capture.frame;
  photograph.noise = set.capture.noise;
  photograph.shots.emplace_back().image = std::filesystem::absolute(file).string();
  const bool framed = !photograph.frame.isWhole();
  const ImageSpec own = framed ? readImageSpec(file) : ImageSpec{};
  // One of the set's size is cropped and scaled already, as a relit frame is.
  if (own.width == set.width() && own.height == set.height()) photograph.frame = {};
  CapturePixels pixels = loadCapturePixels(config, photograph, progress);
  if (pixels.width() != set.width() || pixels.height() != set.height())
    throw InputError(
        "{}: is {} x {} pixels, the set is {} x {}{}. Take a photograph from the same camera, at the set's "
        "size.",
        file.string(), framed ? own.width : pixels.width(), framed ? own.height : pixels.height(),
        set.width(), set.height(), framed ? ", cropped or scaled from its photographs" : "");
  Image& image = pixels.shots.front();
  if (image.spec().colorSpace != set.colorSpace()) {
    config.convert(image.span(), image.spec().colorSpace, set.colorSpace());
    image.setColorSpace(set.colorSpace());
  }
  return pixels;
}

}  // namespace swaplight
