#include "core/report/gallery_pictures.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/color/srgb.h"
#include "core/image/shrunk_image.h"
#include "core/relight/relative_light.h"
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

/// The whole frame, shrunk in light, and what `look` wants to know of it.
FilteredImage frameOf(const ColorConfig& config, const std::shared_ptr<const SolvedSet>& set,
                      const Document& document, int width, const FrameFilter* look) {
  const bool edited = document.edits != EditStack{};
  const SolvedSet withThem = edited ? withEdits(set, document.edits) : SolvedSet();
  const SolvedSet& lit = edited ? withThem : *set;
  const Rig rig = fitRig(document.rig, lit.capture);
  const std::vector<Rgb> factors = rigFactors(config, rig, lit.colorSpace());
  FilteredImage frame{relight(lit, factors, rig.ambient), FilterSpace::SceneLinear};
  if (look && look->wantsLight()) frame.light = relativeLight(lit, factors, rig.ambient);
  if (frame.image.width() <= width) return frame;
  const double part = static_cast<double>(width) / frame.image.width();
  const int height = std::max(1, static_cast<int>(std::lround(part * frame.image.height())));
  frame.image = shrunkImage(frame.image, width, height);
  return frame;
}

Image codesOf(const ColorConfig& config, FilteredImage seen, const DisplayChoice& shown, FrameFilter* look) {
  const std::string space = seen.image.spec().colorSpace;
  const auto toDisplay = [&](ImageSpan pixels) { config.applyView(pixels, space, shown); };
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
                          codesOf(config, frameOf(config, set, recalledLook, options.width, filter.get()),
                                  shownThrough(config, recalledLook.display), filter.get())});
    } catch (const InputError& error) {
      throw InputError("{}: {}", look.name, error.what());
    }
  }
  return pictures;
}

}  // namespace swaplight
