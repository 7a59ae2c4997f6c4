#include "ui/camera/look_preview.h"

#include <fmt/core.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "core/base/error.h"
#include "core/filter/filter_names.h"
#include "render/filter/filter_engine.h"
#include "render/filter/pipeline_memory.h"
#include "ui/camera/lit_frame.h"

namespace swaplight {
namespace {

constexpr int kTileSide = 1024;  ///< between tiles a picture that nobody waits for any more is given up
constexpr double kMostSeconds = 5;

/// How long a frame of the interface waits for a draft: until it has to be on the screen.
constexpr std::chrono::milliseconds kMostWait{20};

std::vector<std::string> filtersOf(const FilterPipeline& look) {
  std::vector<std::string> filters;
  for (const FilterStage& stage : look.stages)
    if (stage.on) filters.push_back(stage.filter);
  return filters;
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
  std::vector<ResolvedStage> stages;
  std::vector<std::string> leftOut;
  std::shared_ptr<Engine> engine;
  std::shared_ptr<PipelineMemory> memory;
};

LookPreview::LookPreview(std::function<void()> wake)
    : m_wake(std::move(wake)), m_engine(std::make_shared<Engine>()) {}

LookPreview::~LookPreview() = default;

FilterLibrary& LookPreview::library() {
  if (!m_library) m_library.emplace(installedFilters());
  return *m_library;
}

std::optional<LayeredPicture> LookPreview::picture(Side side, const SeenRequest& request,
                                                   SeenOptions options) {
  Place& place = m_places.at(static_cast<size_t>(side));
  if (place.asked != request) place.askedAt = Clock::now();
  place.asked = request;
  place.settled = options.settled;
  advance(place);
  if (!options.settled) waitForDraft(place);
  const std::shared_ptr<const SeenPicture> seen = shown(side, request);
  if (!seen) return std::nullopt;
  if (options.asLarge && seen->scale < 1) enlarge(*place.pictures.at(place.front));
  return LayeredPicture{{{&*seen->pyramid, Rgb(1)}}, seen->colorSpace, seen->scale};
}

/// A draft that is made at once is shown in the frame that asked for it, not in the next one.
void LookPreview::waitForDraft(Place& place) {
  const Clock::time_point end = Clock::now() + kMostWait;
  while (m_draftSize.isQuick() && place.job.running() && place.job.endsWithin(end - Clock::now())) {
    take(place);
    advance(place);
  }
}

std::shared_ptr<const SeenPicture> LookPreview::shown(Side side, const SeenRequest& request) const {
  const Place& place = m_places.at(static_cast<size_t>(side));
  const std::shared_ptr<SeenPicture>& front = place.pictures.at(place.front);
  const ViewPictures& pictures = request.live->pictures();
  const bool fits = front->width == pictures.width() && front->height == pictures.height();
  if (place.shownScale <= 0 || !fits || place.failed == request) return nullptr;
  return front;
}

bool LookPreview::follows(Side side, bool exact) const {
  const Place& place = m_places.at(static_cast<size_t>(side));
  return place.shownScale > 0 && place.shown == place.asked && (!exact || place.shownScale >= 1);
}

void LookPreview::update(Messages& messages) {
  for (Place& place : m_places) {
    take(place);
    if (place.asked.live) advance(place);
  }
  for (const std::string& line : std::exchange(m_toWarn, {})) messages.warn(line);
  for (const std::string& line : std::exchange(m_toReport, {})) messages.error(line);
}

void LookPreview::forget(Place& place) {
  place.job.drop();
  place.asked = place.making = place.shown = place.failed = {};
  place.draft = place.exact = {};
  place.shownScale = 0;
}

void LookPreview::forget() {
  for (Place& place : m_places) forget(place);
}

void LookPreview::releaseOtherSet(Side side, const std::shared_ptr<const LiveSet>& live) {
  Place& place = m_places.at(static_cast<size_t>(side));
  if (place.asked.live && place.asked.live != live) forget(place);
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
      [drawing = drawingOf(place, scale)](const Progress& progress) { return draw(drawing, progress); },
      m_wake);
}

LookPreview::Drawing LookPreview::drawingOf(Place& place, float scale) {
  const SeenRequest& request = place.asked;
  SeenRequest frame = request;
  frame.look = {};
  Kept& kept = scale < 1 ? place.draft : place.exact;
  if (kept.frame != frame || kept.scale != scale)
    kept = {std::move(frame), scale, std::make_shared<PipelineMemory>()};
  Drawing drawing{request, scale, {}, {}, m_engine, kept.memory};
  for (const FilterStage& stage : request.look.stages) {
    if (!stage.on) continue;
    try {
      if (isFilterFile(stage.filter)) library().load(request.look.folder / stage.filter);
      drawing.stages.push_back(resolveStage(library(), stage, request.look.folder, request.look.name));
    } catch (const InputError& error) {
      drawing.leftOut.emplace_back(error.what());
    }
  }
  return drawing;
}

LookPreview::Drawn LookPreview::draw(const Drawing& drawing, const Progress& progress) {
  const Clock::time_point begin = Clock::now();
  const auto secondsSince = [](Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
  };
  const SeenRequest& request = drawing.request;
  FilteredImage frame{litFrame(request, drawing.scale), FilterSpace::SceneLinear};
  if (wantsLight(drawing.stages)) frame.light = relativeLight(request, drawing.scale);
  const std::string space = frame.image.spec().colorSpace;
  Drawn drawn;
  drawn.leftOut = drawing.leftOut;
  PipelineOptions options;
  options.tileSide = kTileSide;
  options.limitsPerTile.mostSeconds = kMostSeconds;
  options.memory = drawing.memory.get();
  options.leftOut = [&](const std::string& line) { drawn.leftOut.push_back(line); };
  options.displayFromScene = [&](ImageSpan image) {
    request.config->applyView(image, space, namedDisplay(*request.config, request.display));
  };
  Progress silent;  // a report would have the window drawn again, which shows none of it
  silent.stop = progress.stop;
  FilterEngine& engine = drawing.engine->get();
  const Clock::time_point filtersBegin = Clock::now();
  FilteredImage seen = engine.apply(std::move(frame), drawing.stages, options, silent);
  drawn.filterSeconds = secondsSince(filtersBegin);
  drawn.image = std::move(seen.image);
  drawn.pyramid.emplace(drawn.image.view());
  drawn.colorSpace = seen.space == FilterSpace::Display ? "" : space;
  drawn.seconds = secondsSince(begin);
  return drawn;
}

void LookPreview::take(Place& place) {
  try {
    if (std::optional<Drawn> drawn = place.job.take()) adopt(place, std::move(*drawn));
  } catch (const Stopped&) {
    return;  // another one is asked for
  } catch (const std::exception& error) {
    place.failed = place.making;
    m_toReport.push_back(std::string("The camera look cannot be shown: ") + error.what());
  }
}

void LookPreview::adopt(Place& place, Drawn drawn) {
  m_draftSize.tell(place.makingScale, drawn.seconds);
  m_words = fmt::format("{} {:.2f} {:.1f} {:.1f}", ++m_count, place.makingScale, 1000 * drawn.filterSeconds,
                        std::chrono::duration<double, std::milli>(Clock::now() - place.makingSince).count());
  m_leftOut = drawn.leftOut;
  for (const std::string& line : drawn.leftOut)
    if (m_said.insert(line).second) m_toWarn.push_back("Left out of the camera look: " + line);
  place.front = 1 - place.front;
  SeenPicture& front = *place.pictures.at(place.front);
  {
    const std::unique_lock lock(front.mutex);
    front.image = std::move(drawn.image);
    front.pyramid = std::move(drawn.pyramid);
    front.colorSpace = drawn.colorSpace;
    front.scale = place.makingScale;
    front.width = place.making.live->pictures().width();
    front.height = place.making.live->pictures().height();
  }
  place.shown = place.making;
  place.shownScale = place.makingScale;
}

float LookPreview::draftScale(const SeenRequest& request) {
  return m_draftSize.scaleFor(filtersOf(request.look));
}

}  // namespace swaplight
