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
  const auto fits = [&](const auto& one) {
    return one.width() == set.width() && one.height() == set.height();
  };
  // One of the set's size is cropped and scaled already, as a relit frame is.
  const bool framed = !photograph.frame.isWhole();
  if (const ImageSpec spec = framed ? readImageSpec(file) : ImageSpec{};
      spec.width == set.width() && spec.height == set.height())
    photograph.frame = {};
  CapturePixels pixels = loadCapturePixels(config, photograph, progress);
  if (!fits(pixels))
    throw InputError(
        "{}: is {} x {} pixels, the set is {} x {}{}. Take a photograph from the same camera, at the set's "
        "size.",
        file.string(), pixels.width(), pixels.height(), set.width(), set.height(),
        framed ? ", cropped or scaled from its photographs" : "");
  Image& image = pixels.shots.front();
  if (image.spec().colorSpace != set.colorSpace()) {
    config.convert(image.span(), image.spec().colorSpace, set.colorSpace());
    image.setColorSpace(set.colorSpace());
  }
  return pixels;
}

}  // namespace swaplight
