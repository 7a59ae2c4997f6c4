#include "core/report/gallery_pictures.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/shrunk_image.h"
#include "core/relight/relight.h"
#include "core/session/open_source.h"
#include "core/session/version.h"

namespace swaplight {
namespace {

DisplayChoice shownThrough(const ColorConfig& config, const DisplayChoice& choice) {
  DisplayChoice shown = namedDisplay(config, displayWithin(config, choice));
  if (shown.display.find("2100") == std::string::npos) return shown;
  return namedDisplay(config, {"", "", shown.look, shown.grade});
}

/// The whole frame, shrunk in light.
Image lightOf(const ColorConfig& config, const std::shared_ptr<const SolvedSet>& set,
              const Document& document, int width) {
  const bool edited = document.edits != EditStack{};
  const SolvedSet withThem = edited ? withEdits(set, document.edits) : SolvedSet();
  const SolvedSet& lit = edited ? withThem : *set;
  const Rig rig = fitRig(document.rig, lit.capture);
  const Image frame = relight(lit, rigFactors(config, rig, lit.colorSpace()), rig.ambient);
  if (frame.width() <= width) return frame.clone();
  const double part = static_cast<double>(width) / frame.width();
  return shrunkImage(frame, width, std::max(1, static_cast<int>(std::lround(part * frame.height()))));
}

Image codesOf(const ColorConfig& config, Image light, const DisplayChoice& shown, FrameFilter* look) {
  const std::string space = light.spec().colorSpace;
  const auto toDisplay = [&](ImageSpan pixels) { config.applyView(pixels, space, shown); };
  FilteredImage seen{std::move(light), FilterSpace::SceneLinear};
  if (look) seen = look->apply(std::move(seen), toDisplay, 0);
  if (seen.space != FilterSpace::Display) toDisplay(seen.image.span());
  return std::move(seen.image);
}

}  // namespace

std::vector<GalleryPicture> galleryPictures(const ColorConfig& config,
                                            const std::shared_ptr<const SolvedSet>& set,
                                            const Document& document, const GalleryOptions& options,
                                            const Progress& progress) {
  std::vector<GalleryPicture> pictures;
  Document whole = document;  // a session may name some lights only
  whole.rig = fitRig(document.rig, set->capture);
  for (const SavedLook& look : document.looks) {
    progress.update(static_cast<float>(pictures.size()) / static_cast<float>(document.looks.size()),
                    "drawing " + look.name);
    const Document recalledLook = recalled(whole, look);
    try {
      const auto filter = options.cameraLook && !recalledLook.cameraLook.stages.empty()
                              ? options.cameraLook(recalledLook.cameraLook)
                              : nullptr;
      pictures.push_back({look.name, look.note, look.scene.has_value(),
                          codesOf(config, lightOf(config, set, recalledLook, options.width),
                                  shownThrough(config, recalledLook.display), filter.get())});
    } catch (const InputError& error) {
      throw InputError("{}: {}", look.name, error.what());
    }
  }
  return pictures;
}

}  // namespace swaplight
