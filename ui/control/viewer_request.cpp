#include "ui/control/viewer_request.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/relight/rig.h"
#include "core/view/subject_image.h"
#include "ui/camera/seen_frame.h"

namespace swaplight {
namespace {

std::optional<SeenRequest> requestOf(const ViewerContext& studio, const Rig& rig) {
  return seenRequest(studio.colors.config(), studio.set()->live, studio.edits.revision(), studio.document(),
                     studio.viewer, rig);
}

/// The lit picture under the camera look; nothing where there is none, or none yet.
std::optional<LayeredPicture> seenPicture(const ViewerContext& studio, LookPreview::Side side,
                                          const Rig& rig) {
  const auto request = requestOf(studio, rig);
  if (!request) {
    studio.seen.releaseOtherSet(side, studio.set()->live);
    return std::nullopt;
  }
  return studio.seen.picture(side, *request,
                             {.settled = !studio.editor.inGesture(),
                              .asLarge = studio.view.compare.mode == CompareState::Mode::Difference});
}

/// The light on the set without its texture: one light's at unit white, or all under the rig.
std::optional<LayeredPicture> illuminationOf(const ViewerContext& studio, const ViewSubject& subject,
                                             const Rig& rig) {
  const OpenSet& set = *studio.set();
  const std::vector<const Pyramid*>& found = studio.subjects.illumination(set, !studio.editor.inGesture());
  const std::string& colorSpace = set.solved().colorSpace();
  LayeredPicture picture{{}, colorSpace};
  if (subject.kind == ViewSubject::Kind::Illumination) {
    if (static_cast<size_t>(subject.index) < found.size())
      picture.layers.push_back({found[static_cast<size_t>(subject.index)], Rgb(1)});
  } else {
    const std::vector<Rgb> factors = rigFactors(*studio.colors.config(), rig, colorSpace);
    for (size_t i = 0; i < std::min(found.size(), factors.size()); ++i)
      picture.layers.push_back({found[i], factors[i]});
  }
  return picture.layers.empty() ? std::nullopt : std::optional(picture);
}

/// Display codes that a map is made of are shown as they are; pictures go through the view.
std::optional<LayeredPicture> sidePicture(const ViewerContext& studio, LookPreview::Side side,
                                          ViewSubject subject, const Rig& rig) {
  const OpenSet& set = *studio.set();
  subject = subjectWithin(set.solved(), subject);
  if (subject.kind == ViewSubject::Kind::Relit)
    if (std::optional<LayeredPicture> seen = seenPicture(studio, side, rig)) return seen;
  const std::string& colorSpace = set.solved().colorSpace();
  if (subject.kind == ViewSubject::Kind::Relit || subject.kind == ViewSubject::Kind::Contribution)
    return LayeredPicture{
        set.pictures().layers(subject, rigFactors(*studio.colors.config(), rig, colorSpace), rig.ambient),
        colorSpace};
  if (subject.kind == ViewSubject::Kind::Visibility) {
    const Pyramid* visibility = studio.shadows.visibility(subject.index);
    return visibility ? std::optional(LayeredPicture{{{visibility, Rgb(1)}}, ""}) : std::nullopt;
  }
  if (subject.kind == ViewSubject::Kind::Illumination || subject.kind == ViewSubject::Kind::Lighting)
    return illuminationOf(studio, subject, rig);
  const SubjectPictures::Shown* shown = studio.subjects.picture(studio.colors.config(), set, subject);
  if (!shown) return std::nullopt;
  return LayeredPicture{{{shown->pyramid.get(), Rgb(1)}}, shown->image.spec().colorSpace};
}

std::string lightTitle(const ViewerContext& studio, int index) {
  const std::vector<LightSetting>& lights = studio.document().rig.lights;
  return index >= 0 && static_cast<size_t>(index) < lights.size() ? lights[static_cast<size_t>(index)].title()
                                                                  : "";
}

}  // namespace

ViewerPictures viewerPictures(const ViewerContext& studio) {
  const CompareState& compare = studio.view.compare;
  ViewerPictures pictures;
  pictures.a = sidePicture(studio, LookPreview::Side::A, studio.view.subject, studio.document().rig);
  if (!compare.isOn()) {
    studio.seen.releaseOtherSet(LookPreview::Side::B, studio.set()->live);
    return pictures;
  }
  const Rig other = compare.rig ? fitRig(*compare.rig, studio.set()->solved().capture)
                                : defaultRig(studio.set()->solved().capture);
  pictures.b = sidePicture(studio, LookPreview::Side::B, compare.subject, other);
  return pictures;
}

std::shared_ptr<const SeenPicture> seenNow(const ViewerContext& studio) {
  if (!studio.set() || studio.view.subject.kind != ViewSubject::Kind::Relit) return nullptr;
  const auto request = requestOf(studio, studio.document().rig);
  return request ? studio.seen.shown(LookPreview::Side::A, *request) : nullptr;
}

Comparison wipeIn(const CompareState& state, int pictureWidth, int pictureHeight) {
  return {Comparison::Mode::Wipe, state.x * pictureWidth, state.y * pictureHeight, state.angleDegrees};
}

PixelRect visiblePart(const ViewWindow& window) {
  if (window.zoom <= 0) return {};
  const auto low = [](double at) { return static_cast<int>(std::floor(at)) - 2; };
  const int left = low(window.left), top = low(window.top);
  return {left, top, static_cast<int>(std::ceil(window.width / window.zoom)) + 5,
          static_cast<int>(std::ceil(window.height / window.zoom)) + 5};
}

ViewSettings viewerSettings(const ViewerContext& studio) {
  ViewSettings settings = studio.view.settings;
  settings.display = displayWithin(*studio.colors.config(), studio.document().display);
  if (studio.viewer.plain) settings.display.grade.reset();
  return settings;
}

std::string subjectWords(const ViewerContext& studio, const ViewSubject& told) {
  const ViewSubject subject = studio.set() ? subjectWithin(studio.set()->solved(), told) : told;
  switch (subject.kind) {
    case ViewSubject::Kind::Relit:
      return "Relit";
    case ViewSubject::Kind::Contribution:
      return "Light: " + lightTitle(studio, subject.index);
    case ViewSubject::Kind::Beta:
      return "Beta of " + lightTitle(studio, subject.index);
    case ViewSubject::Kind::Visibility:
      return "Visibility of " + lightTitle(studio, subject.index);
    case ViewSubject::Kind::Illumination:
      return "Illumination by " + lightTitle(studio, subject.index);
    case ViewSubject::Kind::Lighting:
      return "Illumination by all lights";
    case ViewSubject::Kind::Highlight:
      return "Highlights of " + lightTitle(studio, subject.index);
    case ViewSubject::Kind::Diffuse:
      return lightTitle(studio, subject.index) + " without highlights";
    case ViewSubject::Kind::Reflectance:
      return "Reflectance";
    case ViewSubject::Kind::Residual:
      return "Residual";
    case ViewSubject::Kind::Sigma:
      return "Standard error (\u03c3)";
    case ViewSubject::Kind::Flags:
      return "Flags";
    case ViewSubject::Kind::Photograph:
      return fmt::format("Photograph {}", subject.index + 1);
  }
  return {};
}

std::string sideBWords(const ViewerContext& studio) {
  const CompareState& compare = studio.view.compare;
  if (compare.subject.kind != ViewSubject::Kind::Relit) return subjectWords(studio, compare.subject);
  if (!compare.rig) return "Unit white";
  for (const SavedLook& look : studio.document().looks)
    if (look.rig == compare.rig) return look.name;
  return "Stored lighting";
}

}  // namespace swaplight
