#include "core/export/frame_file.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/color/color_config.h"
#include "core/color/icc_profile.h"
#include "core/error.h"
#include "core/image/image_format.h"

namespace swaplight {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool hasView(const FrameOptions& options) {
  return !options.display.empty() || !options.view.empty();
}

}  // namespace

bool isSceneLinear(const std::filesystem::path& file) {
  const std::string format = imageFormatForWriting(file);
  return format == "openexr" || format == "hdr";
}

void checkFrame(const std::filesystem::path& file, const FrameOptions& options) {
  static_cast<void>(imageFormatForWriting(file));
  if (options.tone && (options.linear || hasView(options)))
    throw InputError("a tone mapping takes the place of a view: ask for one of them");
  if (options.tone && isSceneLinear(file))
    throw InputError("{}: holds scene-linear light, which is not tone mapped; write PNG, TIFF or JPEG",
                     file.string());
  if (!hasView(options)) return;
  if (options.linear)
    throw InputError("a frame is either linear or seen through a view: ask for one of them");
  const ColorConfig& config = ColorConfig::current();
  const std::string display = options.display.empty() ? config.defaultDisplay() : options.display;
  if (!contains(config.displays(), display))
    throw InputError("there is no display '{}'; {} has {}", display, config.name(),
                     fmt::join(config.displays(), ", "));
  if (!options.view.empty() && !contains(config.views(display), options.view))
    throw InputError("the display {} has no view '{}'; {} has {}", display, options.view, config.name(),
                     fmt::join(config.views(display), ", "));
}

void writeFrame(Image frame, const std::filesystem::path& file, FrameOptions options) {
  checkFrame(file, options);
  const std::string space = frame.spec().colorSpace;
  const ColorConfig& config = ColorConfig::current();
  if (options.tone) {
    config.convert(frame.span(), space, "lin_rec709");
    applyStillTone(frame.span(), *options.tone);
    frame.setColorSpace("lin_rec709");
  }
  if (hasView(options)) {
    const std::string display = options.display.empty() ? config.defaultDisplay() : options.display;
    const std::string view = options.view.empty() ? config.defaultView(display) : options.view;
    config.applyView(frame.span(), space, display, view);
    frame.setColorSpace("data");
    options.write.iccProfile = iccProfileOf(display, view);
  } else if (!options.linear && !isSceneLinear(file)) {
    config.convert(frame.span(), frame.spec().colorSpace, "srgb");
    frame.setColorSpace("srgb");
    options.write.iccProfile = iccProfileOf("sRGB", "");
  }
  writeImage(frame, file, options.write);
}

}  // namespace swaplight
