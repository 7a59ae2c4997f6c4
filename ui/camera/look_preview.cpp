#include "ui/camera/look_preview.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/base/error.h"
#include "core/view/window_pixels.h"
#include "render/filter/filter_engine.h"
#include "ui/camera/lit_frame.h"

namespace swaplight {
namespace {

constexpr double kDraftSeconds = 0.02;  ///< for filters, of the 33 ms in which a picture follows the hand
/// Not halves and quarters, which the viewer's interpolation shows as squares.
constexpr std::array<float, 3> kDraftScales = {1, 0.51F, 0.26F};
constexpr float kFirstDraft = 0.26F;
constexpr int kTileSide = 1024;  ///< between tiles a picture that nobody waits for any more is given up
constexpr double kMostSeconds = 5;

/// A picture of another size, interpolated.
Image resized(const Image& image, int width, int height) {
  const Pyramid pyramid(image.view());
  const std::array<ViewLayer, 1> layers{ViewLayer{&pyramid, Rgb(1)}};
  // The window lies inside the picture.
  const double zoom =
      std::max(static_cast<double>(width) / image.width(), static_cast<double>(height) / image.height());
  Image out(ImageSpec::rgb(width, height));
  out.setColorSpace(image.spec().colorSpace);
  windowLinear(layers, {0, 0, zoom, width, height}, out.span());
  return out;
}

}  // namespace

/// Made in a thread, by the first picture, and shared by all of them.
struct LookPreview::Engine {
  std::mutex mutex;
  std::unique_ptr<FilterEngine> engine;

  FilterEngine& get() {
    const std::lock_guard lock(mutex);
    if (!engine) engine = std::make_unique<FilterEngine>();
    return *engine;
  }
};

/// A picture to be drawn, by values of its own.
struct LookPreview::Drawing {
  SeenRequest request;
  float scale = 1;
  int width = 0, height = 0;  ///< of the frame
  std::vector<ResolvedStage> stages;
  std::vector<std::string> leftOut;
  std::shared_ptr<Engine> engine;
};

LookPreview::LookPreview(ViewportRenderer& renderer, std::function<void()> wake)
    : m_renderer(renderer), m_wake(std::move(wake)), m_engine(std::make_shared<Engine>()) {}

LookPreview::~LookPreview() = default;

FilterLibrary& LookPreview::library() {
  if (!m_library) m_library.emplace(installedFilters());
  return *m_library;
}

std::optional<LayeredPicture> LookPreview::picture(Side side, const SeenRequest& request, bool settled) {
  Place& place = m_places.at(static_cast<size_t>(side));
  if (place.asked != request) place.askedAt = Clock::now();
  place.asked = request;
  place.settled = settled;
  advance(place);
  const std::shared_ptr<const SeenPicture> seen = shown(side, request);
  if (!seen) return std::nullopt;
  return LayeredPicture{{{&*seen->pyramid, Rgb(1)}}, seen->colorSpace};
}

std::shared_ptr<const SeenPicture> LookPreview::shown(Side side, const SeenRequest& request) const {
  const Place& place = m_places.at(static_cast<size_t>(side));
  const std::shared_ptr<SeenPicture>& front = place.pictures.at(place.front);
  const ViewPictures& pictures = request.live->pictures();
  const bool fits = front->image.width() == pictures.width() && front->image.height() == pictures.height();
  if (place.shownScale <= 0 || !fits || place.failed == request) return nullptr;
  return front;
}

bool LookPreview::follows(Side side, bool exact) const {
  const Place& place = m_places.at(static_cast<size_t>(side));
  return place.shownScale > 0 && place.shown == place.asked && (!exact || place.shownScale >= 1);
}

void LookPreview::update(Messages& messages) {
  for (Place& place : m_places) {
    take(place, messages);
    if (place.asked.live) advance(place);
  }
}

void LookPreview::forget() {
  for (Place& place : m_places) {
    place.job.cancel();
    place.asked = place.shown = place.failed = {};
    place.shownScale = 0;
  }
}

bool LookPreview::busy() const {
  return std::any_of(m_places.begin(), m_places.end(),
                     [](const Place& place) { return place.job.running(); });
}

void LookPreview::advance(Place& place) {
  if (place.asked == place.failed) return;
  if (place.job.running()) {
    if (place.makingScale >= 1 && place.making != place.asked) place.job.cancel();
    return;
  }
  if (place.shownScale <= 0 || place.shown != place.asked)
    start(place, place.settled && place.shownScale <= 0 ? 1 : draftScale(place.asked));
  else if (place.shownScale < 1 && place.settled)
    start(place, 1);
}

void LookPreview::start(Place& place, float scale) {
  place.making = place.asked;
  place.makingScale = scale;
  place.makingSince = place.askedAt;
  place.job.start(
      [drawing = drawingOf(place.asked, scale)](const Progress& progress) { return draw(drawing, progress); },
      m_wake);
}

LookPreview::Drawing LookPreview::drawingOf(const SeenRequest& request, float scale) {
  const ViewPictures& pictures = request.live->pictures();
  Drawing drawing{request, scale, pictures.width(), pictures.height(), {}, {}, m_engine};
  for (const FilterStage& stage : request.look.stages) {
    if (!stage.on) continue;
    try {
      if (stage.filter.ends_with(".fs")) library().load(request.look.folder / stage.filter);
      drawing.stages.push_back(resolveStage(library(), stage, request.look.folder, request.look.name));
    } catch (const InputError& error) {
      drawing.leftOut.emplace_back(error.what());
    }
  }
  return drawing;
}

LookPreview::Drawn LookPreview::draw(const Drawing& drawing, const Progress& progress) {
  const SeenRequest& request = drawing.request;
  Image light = litFrame(request, drawing.scale);
  const std::string space = light.spec().colorSpace;
  Drawn drawn;
  drawn.leftOut = drawing.leftOut;
  PipelineOptions options;
  options.tileSide = kTileSide;
  options.limitsPerTile.mostSeconds = kMostSeconds;
  options.leftOut = [&](const std::string& line) { drawn.leftOut.push_back(line); };
  options.displayFromScene = [&](ImageSpan image) {
    request.config->applyView(image, space, namedDisplay(*request.config, request.display));
  };
  FilterEngine& engine = drawing.engine->get();
  const Clock::time_point begin = Clock::now();
  FilteredImage seen =
      engine.apply({std::move(light), FilterSpace::SceneLinear}, drawing.stages, options, progress);
  drawn.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  drawn.image =
      drawing.scale < 1 ? resized(seen.image, drawing.width, drawing.height) : std::move(seen.image);
  drawn.pyramid.emplace(drawn.image.view());
  drawn.colorSpace = seen.space == FilterSpace::Display ? "" : space;
  return drawn;
}

void LookPreview::take(Place& place, Messages& messages) {
  try {
    if (std::optional<Drawn> drawn = place.job.take()) adopt(place, std::move(*drawn), messages);
  } catch (const Stopped&) {
    return;  // another one is asked for
  } catch (const std::exception& error) {
    place.failed = place.making;
    messages.error(std::string("The camera look cannot be shown: ") + error.what());
  }
}

void LookPreview::adopt(Place& place, Drawn drawn, Messages& messages) {
  const double pixels = static_cast<double>(drawn.image.pixelCount()) * place.makingScale * place.makingScale;
  m_secondsPerPixel = drawn.seconds / std::max(pixels, 1.0);
  m_words = fmt::format("{} {:.2f} {:.1f} {:.1f}", ++m_count, place.makingScale, 1000 * drawn.seconds,
                        std::chrono::duration<double, std::milli>(Clock::now() - place.makingSince).count());
  m_leftOut = drawn.leftOut;
  for (const std::string& line : drawn.leftOut)
    if (m_said.insert(line).second) messages.warn("Left out of the camera look: " + line);
  place.front = 1 - place.front;
  SeenPicture& front = *place.pictures.at(place.front);
  {
    const std::unique_lock lock(front.mutex);
    front.image = std::move(drawn.image);
    front.pyramid = std::move(drawn.pyramid);
    front.colorSpace = drawn.colorSpace;
  }
  m_renderer.changed(*front.pyramid, {0, 0, front.image.width(), front.image.height()});
  place.shown = place.making;
  place.shownScale = place.makingScale;
}

float LookPreview::draftScale(const SeenRequest& request) const {
  if (m_secondsPerPixel <= 0) return kFirstDraft;
  const ViewPictures& pictures = request.live->pictures();
  const double seconds = m_secondsPerPixel * pictures.width() * pictures.height();
  for (const float scale : kDraftScales)
    if (seconds * scale * scale <= kDraftSeconds) return scale;
  return kDraftScales.back();
}

}  // namespace swaplight
