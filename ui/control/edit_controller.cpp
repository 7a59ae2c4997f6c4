#include "ui/control/edit_controller.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "core/base/error.h"
#include "core/edit/mask/surface_color.h"
#include "core/edit/placing/placed_change.h"
#include "core/normals/placed_lights.h"
#include "core/shadow/detect/detect_shadows.h"
#include "ui/jobs/take_or_report.h"

namespace swaplight {
namespace {

constexpr std::chrono::milliseconds kBudget{8};        // a frame, for what is not seen
constexpr std::chrono::milliseconds kSeenBudget{160};  // and for what is: the rest follows in the next ones
constexpr int kTilesAtOnce = 4;
constexpr size_t kDrawnKept = 3;

/// Shapes that take long to draw.
bool isSlow(const MaskShape& shape) {
  return std::holds_alternative<SimilarShape>(shape.shape) || std::holds_alternative<KeyShape>(shape.shape) ||
         std::holds_alternative<SelectionShape>(shape.shape);
}

}  // namespace

void EditController::beginFrame() {
  const OpenSet* set = m_parts.session.set();
  if (!set) {
    m_set.reset();
    return;
  }
  if (m_set != set->original) {
    m_set = set->original;
    m_room = {};
    m_found = std::make_shared<FoundShadows>();
    m_surfaces = std::make_shared<FoundSurfaces>();
    m_making.cancel();
    m_finding.cancel();
    m_surfacing.cancel();
    m_files.forget();
    m_filesStale = false;
    m_drawingStale = true;
    m_drawn.clear();
    m_followed = false;
    m_complaint.clear();
    m_refused.clear();
    m_foundFor = {};
    m_surfacesBy = m_surfacingBy = {};
    m_needsShadows = m_stopped = false;
  }
  takeJobs();
}

void EditController::show(const PixelRect& visible) {
  if (!m_set) return;
  follow();
  seekShadows();
  seekSurfaces();
  if (m_room.edited) update(visible);
}

void EditController::takeJobs() {
  m_files.update(m_parts.messages);
  takeOrReport(m_making, m_parts.messages, "edits", [this](Room room) {
    if (&room.edited->original() == m_set.get()) adopt(std::move(room));
  });
  takeDrawn();
  const Taken search = takeOrReport(m_finding, m_parts.messages, "finding shadows", [this](FoundOf found) {
    if (found.set != m_set) return;
    m_found->replace(std::move(found.found));
    m_foundFor = std::move(found.options);
    m_followed = false;
    m_drawingStale = true;
    m_drawn.clear();
  });
  if (search == Taken::Failed) m_stopped = true;  // or it would fail again in every frame
  const Taken surfaces = takeOrReport(m_surfacing, m_parts.messages, "finding how surfaces are turned",
                                      [this](SurfacesOf found) {
                                        if (found.set != m_set) return;
                                        m_surfaces->replace(std::move(found.found));
                                        m_surfacesBy = std::move(found.by);
                                        if (m_room.edited) m_room.edited->surfacesChanged();
                                        m_followed = false;
                                      });
  if (surfaces == Taken::Stopped) m_surfacingBy = {};  // those places may be asked for again
}

void EditController::takeDrawn() {
  try {
    auto raster = m_drawing.take();
    if (!raster || m_drawingStale) return;
    if (m_room.edited) m_room.edited->context().keep(m_drawingShape, *raster);
    keepDrawn(std::move(*raster));
  } catch (const Stopped&) {
    failDrawn();
  } catch (const InputError&) {
    failDrawn();  // who asks for it is told why
  } catch (const std::exception& error) {
    failDrawn();  // or it would be begun again in every frame
    m_parts.messages.error(error.what());
  }
}

void EditController::failDrawn() {
  if (!m_drawingStale) keepDrawn(nullptr);
}

void EditController::keepDrawn(std::shared_ptr<const MaskRaster> raster) {
  m_drawn.push_back({m_drawingShape, std::move(raster)});
}

void EditController::dropDrawn(const EditStack& stack) {
  const auto isWanted = [&](const Drawn& drawn) {
    return std::any_of(stack.edits.begin(), stack.edits.end(), [&](const auto& edit) {
      return std::any_of(edit->mask.begin(), edit->mask.end(),
                         [&](const MaskShape& shape) { return shape.shape == drawn.shape.shape; });
    });
  };
  for (auto drawn = m_drawn.begin(); m_drawn.size() > kDrawnKept && drawn != m_drawn.end();)
    drawn = isWanted(*drawn) ? std::next(drawn) : m_drawn.erase(drawn);
}

bool EditController::isDrawn(const MaskShape& shape) {
  if (!isSlow(shape) || m_room.edited->context().known(shape)) return true;
  const auto failed = [&](const Drawn& drawn) { return !drawn.raster && drawn.shape.shape == shape.shape; };
  if (std::any_of(m_drawn.begin(), m_drawn.end(), failed)) return true;
  if (m_drawing.running()) return false;
  m_drawingShape = shape;
  m_drawingStale = false;
  m_drawing.start(
      [set = m_set, found = m_found->all(), shape](const Progress&) {
        MaskContext context(*set, [&found](const std::string& light) { return shadowsOf(*found, light); });
        return context.raster(shape);
      },
      m_wake);
  return false;
}

void EditController::follow() {
  const EditStack& wanted = m_parts.editor.document().edits;
  if (m_followed && wanted == m_wanted) return;
  if (!m_room.edited && !(wanted.edits.empty() && wanted.newLights.empty())) return prepare();
  if (m_room.edited) {
    const EditStack stack = usable(wanted);
    dropDrawn(stack);
    if (!isReady(stack)) return;  // the picture follows when it is
    setStack(stack);
    m_files.release();
    m_filesStale = false;
  }
  m_wanted = wanted;
  m_followed = true;
}

bool EditController::isReady(const EditStack& stack) {
  for (const auto& edit : stack.edits)
    for (const MaskShape& shape : edit->mask)
      if (!isDrawn(shape)) return false;
  try {
    const EditedLights lights = editedLights(*m_set, stack);
    for (const auto& edit : stack.edits)
      if (const auto request = betaRequest(*edit, lights))
        if (!m_files.isRead(*request, m_room.edited->files())) return false;
  } catch (const InputError&) {  // setStack says so
  }
  return true;
}

void EditController::readFilesAgain() {
  if (!m_room.edited) return;
  m_room.edited->files().forget();
  m_filesStale = true;
  m_followed = false;
}

void EditController::prepare() {
  if (m_room.edited || m_making.running() || !m_parts.session.set()) return;
  m_making.start([set = m_set, found = m_found,
                  surfaces = m_surfaces](const Progress&) { return makeRoom(set, found, surfaces); },
                 m_wake);
}

EditController::Room EditController::makeRoom(std::shared_ptr<const SolvedSet> set,
                                              std::shared_ptr<FoundShadows> found,
                                              std::shared_ptr<FoundSurfaces> surfaces) {
  Room room;
  room.edited = std::make_shared<EditedSet>(
      std::move(set),
      [found = std::move(found)](const std::string& light) { return shadowsOf(*found->all(), light); },
      [surfaces = std::move(surfaces)] { return surfaces->last(); });
  room.edited->update();
  room.live =
      std::make_shared<LiveSet>(std::shared_ptr<const SolvedSet>(room.edited, &room.edited->result()));
  return room;
}

void EditController::adopt(Room room) {
  m_room = std::move(room);
  m_followed = false;
  m_parts.session.showEdited(m_room.live);
  m_parts.subjects.editsChanged();
  ++m_revision;
}

EditStack EditController::usable(const EditStack& wanted) {
  EditStack stack = fitEdits(wanted, m_set->width(), m_set->height());
  stack.shadowThresholds = m_foundFor.thresholds;
  stack.shadowMarks = m_foundFor.marks;
  stack.lampPlaces = m_surfacesBy.places;
  for (auto& edit : stack.edits)  // an edit that is another object is prepared anew
    if (m_filesStale && std::holds_alternative<BetaMapOperation>(edit->operation))
      edit = std::make_shared<const Edit>(*edit);
  const auto needs = [](const auto& edit) { return usesShadows(*edit); };
  if (std::any_of(stack.edits.begin(), stack.edits.end(), needs)) m_needsShadows = true;
  if (!m_found->all()->empty()) {
    std::erase_if(stack.edits, [&](const auto& edit) { return usesSurfaces(*edit) && !isPlaced(*edit); });
    return stack;
  }
  const size_t all = stack.edits.size();
  stack.edits.erase(std::remove_if(stack.edits.begin(), stack.edits.end(), needs), stack.edits.end());
  if (stack.edits.size() < all) m_stopped = false;  // they are needed now
  return stack;
}

void EditController::setStack(const EditStack& stack) {
  if (m_room.edited->stack().newLights == stack.newLights) return applyStack(stack);
  m_parts.subjects.editsChanged();
  {
    LiveSet::Writing writing = m_room.live->write();
    applyStack(stack);
    writing.lightsChanged();
  }
  m_parts.session.lightsChanged();
  ++m_revision;
}

void EditController::applyStack(const EditStack& stack) {
  try {
    m_room.edited->setStack(stack);
    m_complaint.clear();
    return;
  } catch (const InputError& error) {
    if (m_complaint != error.what()) m_parts.messages.error(error.what());
    m_complaint = error.what();
  }
  // All but those that cannot be applied: the same as last time, if that is so. What is put together anew
  // prepares every edit again.
  EditStack good = stack;
  const auto isRefused = [&](const auto& edit) {
    return std::find(m_refused.begin(), m_refused.end(), edit) != m_refused.end();
  };
  std::erase_if(good.edits, isRefused);
  if (good.edits.size() < stack.edits.size() && tryStack(good)) return;
  m_refused.clear();
  good.edits.clear();
  for (const auto& edit : stack.edits) {
    good.edits.push_back(edit);
    if (tryStack(good)) continue;
    good.edits.pop_back();
    m_refused.push_back(edit);
  }
  // Lights that cannot be added: without them there is nothing to edit.
  if (!tryStack(good)) m_room.edited->setStack({});
}

bool EditController::tryStack(const EditStack& stack) {
  try {
    m_room.edited->setStack(stack);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

void EditController::update(const PixelRect& visible) {
  EditedSet& edited = *m_room.edited;
  if (!edited.staleTile()) return;
  // Scopes may be counting: they need a moment. Those who need longer give way.
  std::optional<LiveSet::Writing> writing = m_room.live->tryWrite();
  if (!writing) {
    m_parts.subjects.editsChanged();
    m_wake();
    return;
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto spent = [&] { return std::chrono::steady_clock::now() - begin; };
  const LightIndices lights = edited.staleLights();
  std::vector<PixelRect> changed;
  const auto compute = [&](const PixelRect& area) {
    const std::vector<PixelRect> more = edited.update(area);
    changed.insert(changed.end(), more.begin(), more.end());
  };
  // Where not all of what is seen can be done in time, the next frame goes on from there.
  const int width = kTilesAtOnce * kTileSize;
  const int columns = (m_set->width() + width - 1) / width;
  const int parts = columns * ((m_set->height() + kTileSize - 1) / kTileSize);
  for (int k = 0; k < parts && spent() < kSeenBudget; ++k, m_part = (m_part + 1) % parts)
    compute(
        intersection(visible, {m_part % columns * width, m_part / columns * kTileSize, width, kTileSize}));
  while (spent() < kBudget) {
    const auto rest = edited.staleTile();
    if (!rest) break;
    compute(*rest);
  }
  refresh(*writing, changed, lights);
  if (edited.staleTile()) m_wake();
}

void EditController::refresh(LiveSet::Writing& writing, const std::vector<PixelRect>& changed,
                             const LightIndices& lights) {
  if (changed.empty()) return;
  for (const Pyramid* picture : writing.pixelsChanged(changed, lights))
    for (const PixelRect& rect : changed)
      m_parts.renderer.changed(*picture, {rect.x, rect.y, rect.width, rect.height});
  m_parts.subjects.editsChanged();
  ++m_revision;
}

std::shared_ptr<const LightShadows> EditController::shadows(const std::string& light) {
  m_needsShadows = true;
  const FoundShadows::All found = m_found->all();
  if (found->empty()) seekShadows();
  const auto known = found->find(light);
  return known == found->end() ? nullptr : known->second;
}

std::shared_ptr<const MaskRaster> EditController::raster(const MaskShape& shape) {
  if (!m_room.edited) {
    prepare();
    return nullptr;
  }
  if (m_found->all()->empty() && usesShadows(Mask{shape})) {
    m_needsShadows = true;
    seekShadows();
    return nullptr;
  }
  return isDrawn(shape) ? m_room.edited->context().raster(shape) : nullptr;
}

Rgb EditController::surfaceColor(const Mask& mask) {
  if (!m_room.edited) prepare();
  if (!m_set || !m_room.edited) {
    if (!m_set || !mask.empty()) return Rgb(1);
    MaskContext context(*m_set);
    return swaplight::surfaceColor(*m_set, PreparedMask(mask, context));
  }
  for (const MaskShape& shape : mask)
    if (!isDrawn(shape)) return Rgb(1);
  return swaplight::surfaceColor(m_room.edited->result(), PreparedMask(mask, m_room.edited->context()));
}

bool EditController::shadowsCurrent() const {
  return !m_found->all()->empty() && m_foundFor == shadowOptionsOf(m_parts.editor.document().edits);
}

void EditController::stopFindingShadows() {
  m_finding.cancel();
  m_stopped = true;
}

void EditController::seekShadows() {
  if (!m_needsShadows || m_stopped || shadowsCurrent() || m_parts.editor.inGesture()) return;
  const ShadowOptions options = shadowOptionsOf(m_parts.editor.document().edits);
  if (m_finding.running()) {
    if (m_findingFor != options) m_finding.cancel();
    return;
  }
  m_findingFor = options;
  m_finding.start(
      [set = m_set, options](const Progress& progress) {
        FoundOf all{set, options, {}};
        std::vector<LightShadows> shadows = detectShadows(*set, options, progress);
        for (size_t i = 0; i < shadows.size(); ++i)
          all.found[set->capture.lights[i].name] =
              std::make_shared<const LightShadows>(std::move(shadows[i]));
        return all;
      },
      m_wake);
}

std::optional<std::string> EditController::whyNotPlaced(const Edit& edit) const {
  std::vector<std::string> lights = edit.lights;
  if (lights.empty())
    for (const Light& light : m_set->capture.lights) lights.push_back(light.name);
  const LampPlaces& told = m_parts.editor.document().edits.lampPlaces;
  for (const std::string& light : lights)
    if (auto problem = swaplight::whyNotPlaced(light, told, m_set->capture)) return problem;
  const FoundSurfaces::Surfaces found = m_surfaces->last();
  return found && m_surfacesBy.places == told ? swaplight::whyNotPlaced(*found) : std::nullopt;
}

bool EditController::isPlaced(const Edit& edit) const {
  const FoundSurfaces::Surfaces found = m_surfaces->last();
  if (!found || swaplight::whyNotPlaced(*found) || whyNotPlaced(edit)) return false;
  // Until they are found by what is told now, those that were found before have to do.
  return std::none_of(edit.lights.begin(), edit.lights.end(), [&](const std::string& light) {
    return swaplight::whyNotPlaced(light, m_surfacesBy.places, m_set->capture);
  });
}

bool EditController::isUnlit(const std::string& light) const {
  const EditStack& stack = m_parts.editor.document().edits;
  const auto isAmong = [&](const std::vector<std::string>& lights) {
    return std::find(lights.begin(), lights.end(), light) != lights.end();
  };
  const auto gives = [&](const auto& edit) {
    return edit->on && (edit->lights.empty() || isAmong(edit->lights)) &&
           !(usesSurfaces(*edit) && whyNotPlaced(*edit));
  };
  return isAmong(stack.newLights) && std::none_of(stack.edits.begin(), stack.edits.end(), gives);
}

void EditController::seekSurfaces() {
  const EditStack& edits = m_parts.editor.document().edits;
  const auto needs = [](const auto& edit) { return edit->on && usesSurfaces(*edit); };
  if (std::none_of(edits.edits.begin(), edits.edits.end(), needs)) return;
  if (!shadowsCurrent() || m_parts.editor.inGesture()) return;
  const SurfacesFor by{edits.lampPlaces, m_foundFor};
  if (m_surfacing.running()) {
    if (by != m_surfacingBy) m_surfacing.cancel();
    return;
  }
  if (by == m_surfacingBy || swaplight::whyNotPlaced("", by.places, m_set->capture)) return;
  m_surfacingBy = by;
  m_surfacing.start(
      [set = m_set, found = m_found->all(), by](const Progress& progress) {
        const auto shadows = [&](const std::string& light) { return shadowsOf(*found, light); };
        const PlacedLights placed = placedLights(by.places, set->capture, "the lamps' places");
        return SurfacesOf{set, by,
                          std::make_shared<const SetSurfaces>(
                              setSurfaces(*set, surfaceNormals(*set, shadows, placed.lamps, progress)))};
      },
      m_wake);
}

}  // namespace swaplight
