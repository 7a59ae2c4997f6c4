#include "ui/control/edit_controller.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include "core/base/error.h"
#include "core/shadow/detect/detect_shadows.h"
#include "ui/control/studio_context.h"

namespace swaplight {
namespace {

constexpr std::chrono::milliseconds kBudget{8};        // a frame, for what is not seen
constexpr std::chrono::milliseconds kSeenBudget{160};  // and for what is: the rest follows in the next ones
constexpr int kTilesAtOnce = 4;
constexpr size_t kDrawnKept = 3;

std::shared_ptr<const LightShadows> shadowsOf(
    const std::map<std::string, std::shared_ptr<const LightShadows>>& found, const std::string& light) {
  const auto known = found.find(light);
  if (known == found.end()) throw InputError("\"{}\" is no light of the set: it has no shadows.", light);
  return known->second;
}

/// Shapes that take long to draw.
bool isSlow(const MaskShape& shape) {
  return std::holds_alternative<SimilarShape>(shape.shape) ||
         std::holds_alternative<SelectionShape>(shape.shape);
}

}  // namespace

void EditController::beginFrame(StudioContext& studio) {
  const OpenSet* set = studio.set();
  if (!set) {
    m_set.reset();
    return;
  }
  if (m_set != set->original) {
    m_set = set->original;
    m_room = {};
    m_found = std::make_shared<Found>();
    m_making.cancel();
    m_finding.cancel();
    m_files.forget();
    m_filesStale = false;
    m_drawingStale = true;
    m_drawn.clear();
    m_followed = false;
    m_complaint.clear();
    m_foundFor.clear();
    m_needsShadows = m_stopped = false;
  }
  takeJobs(studio);
}

void EditController::show(StudioContext& studio, const PixelRect& visible) {
  if (!m_set) return;
  follow(studio);
  seekShadows(studio);
  if (m_room.edited) update(studio, visible);
}

void EditController::takeJobs(StudioContext& studio) {
  m_files.update(studio.messages);
  try {
    if (auto room = m_making.take())
      if (&room->edited->original() == m_set.get()) adopt(studio, std::move(*room));
  } catch (const Stopped&) {
  } catch (const std::exception& error) {
    studio.messages.error(error.what());
  }
  try {
    takeDrawn();
  } catch (const Stopped&) {
  } catch (const std::exception& error) {
    studio.messages.error(error.what());
  }
  try {
    auto found = m_finding.take();
    if (found && found->set == m_set) {
      *m_found = std::move(found->found);
      m_foundFor = std::move(found->thresholds);
      m_followed = false;
      m_drawingStale = true;
      m_drawn.clear();
    }
  } catch (const Stopped&) {
  } catch (const std::exception& error) {
    studio.messages.error(error.what());
  }
}

void EditController::takeDrawn() {
  if (!m_drawing.running()) return;
  const auto keep = [this](std::shared_ptr<const MaskRaster> raster) {
    m_drawn.push_back({m_drawingShape, std::move(raster)});
    if (m_drawn.size() > kDrawnKept) m_drawn.pop_front();
  };
  try {
    auto raster = m_drawing.take();
    if (!raster || m_drawingStale) return;
    if (m_room.edited) m_room.edited->ground().keep(m_drawingShape, *raster);
    keep(std::move(*raster));
  } catch (const InputError&) {
    keep(nullptr);  // who asks for it is told why
  } catch (...) {
    keep(nullptr);  // or it would be begun again in every frame
    throw;
  }
}

bool EditController::isDrawn(const MaskShape& shape) {
  if (!isSlow(shape) || m_room.edited->ground().known(shape)) return true;
  const auto failed = [&](const Drawn& drawn) { return !drawn.raster && drawn.shape.shape == shape.shape; };
  if (std::any_of(m_drawn.begin(), m_drawn.end(), failed)) return true;
  if (m_drawing.running()) return false;
  m_drawingShape = shape;
  m_drawingStale = false;
  m_drawing.start(
      [set = m_set, found = *m_found, shape](const Progress&) {
        MaskGround ground(*set, [&found](const std::string& light) { return shadowsOf(found, light); });
        return ground.raster(shape);
      },
      m_wake);
  return false;
}

void EditController::follow(StudioContext& studio) {
  const EditStack& wanted = studio.document().edits;
  if (m_followed && wanted == m_wanted) return;
  if (!m_room.edited && !(wanted.edits.empty() && wanted.newLights.empty())) return prepare(studio);
  if (m_room.edited) {
    const EditStack stack = usable(wanted);
    if (!isReady(stack)) return;  // the picture follows when it is
    setStack(studio, stack);
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

void EditController::prepare(StudioContext& studio) {
  if (m_room.edited || m_making.running() || !studio.set()) return;
  m_making.start([set = m_set, found = m_found](const Progress&) { return makeRoom(set, found); }, m_wake);
}

EditController::Room EditController::makeRoom(std::shared_ptr<const SolvedSet> set,
                                              std::shared_ptr<Found> found) {
  Room room;
  room.edited = std::make_shared<EditedSet>(
      std::move(set),
      [found = std::move(found)](const std::string& light) { return shadowsOf(*found, light); });
  room.edited->update();
  const std::shared_ptr<const SolvedSet> result(room.edited, &room.edited->result());
  room.pictures = std::make_shared<ViewPictures>(result);
  return room;
}

void EditController::adopt(StudioContext& studio, Room room) {
  m_room = std::move(room);
  m_followed = false;
  studio.session.showEdited({m_room.edited, &m_room.edited->result()}, m_room.pictures);
  studio.subjects.editsChanged();
  studio.pictures.forget();
  ++m_revision;
}

EditStack EditController::usable(const EditStack& wanted) {
  EditStack stack = fitEdits(wanted, m_set->width(), m_set->height());
  stack.shadowThresholds = m_foundFor;
  for (auto& edit : stack.edits)  // an edit that is another object is prepared anew
    if (m_filesStale && std::holds_alternative<PictureOperation>(edit->operation))
      edit = std::make_shared<const Edit>(*edit);
  const auto needs = [](const auto& edit) { return usesShadows(*edit); };
  if (std::any_of(stack.edits.begin(), stack.edits.end(), needs)) m_needsShadows = true;
  if (!m_found->empty()) return stack;
  const size_t all = stack.edits.size();
  stack.edits.erase(std::remove_if(stack.edits.begin(), stack.edits.end(), needs), stack.edits.end());
  if (stack.edits.size() < all) m_stopped = false;  // they are needed now
  return stack;
}

void EditController::setStack(StudioContext& studio, const EditStack& stack) {
  if (m_room.edited->stack().newLights == stack.newLights) return applyStack(studio, stack);
  {
    const std::unique_lock lock(m_room.pictures->pixels());
    applyStack(studio, stack);
    m_room.pictures->lightsChanged();
  }
  studio.session.lightsChanged();
  studio.subjects.editsChanged();
  studio.pictures.forget();
  ++m_revision;
}

void EditController::applyStack(StudioContext& studio, const EditStack& stack) {
  try {
    m_room.edited->setStack(stack);
    m_complaint.clear();
    return;
  } catch (const InputError& error) {
    if (m_complaint != error.what()) studio.messages.error(error.what());
    m_complaint = error.what();
  }
  // All but those that cannot be applied.
  EditStack good = stack;
  good.edits.clear();
  for (const auto& edit : stack.edits) {
    good.edits.push_back(edit);
    try {
      m_room.edited->setStack(good);
    } catch (const InputError&) {
      good.edits.pop_back();
    }
  }
  m_room.edited->setStack(good);
}

void EditController::update(StudioContext& studio, const PixelRect& visible) {
  EditedSet& edited = *m_room.edited;
  if (!edited.staleTile()) return;
  // Scopes may be counting: they need a moment.
  const std::unique_lock lock(m_room.pictures->pixels(), std::try_to_lock);
  if (!lock) {
    m_wake();
    return;
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto spent = [&] { return std::chrono::steady_clock::now() - begin; };
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
  refresh(studio, changed);
  if (edited.staleTile()) m_wake();
}

void EditController::refresh(StudioContext& studio, const std::vector<PixelRect>& changed) {
  if (changed.empty()) return;
  m_room.pictures->refresh(changed);
  for (const Pyramid& picture : m_room.pictures->contributions())
    for (const PixelRect& rect : changed)
      studio.pictures.changed(picture, {rect.x, rect.y, rect.width, rect.height});
  if (studio.subjects.editsChanged()) studio.pictures.forget();
  ++m_revision;
}

std::shared_ptr<const LightShadows> EditController::shadows(StudioContext& studio, const std::string& light) {
  m_needsShadows = true;
  if (m_found->empty()) seekShadows(studio);
  const auto known = m_found->find(light);
  return known == m_found->end() ? nullptr : known->second;
}

std::shared_ptr<const MaskRaster> EditController::raster(StudioContext& studio, const MaskShape& shape) {
  if (!m_room.edited) {
    prepare(studio);
    return nullptr;
  }
  if (m_found->empty() && usesShadows(Mask{shape})) {
    m_needsShadows = true;
    seekShadows(studio);
    return nullptr;
  }
  return isDrawn(shape) ? m_room.edited->ground().raster(shape) : nullptr;
}

bool EditController::shadowsCurrent(const StudioContext& studio) const {
  return !m_found->empty() && m_foundFor == studio.document().edits.shadowThresholds;
}

void EditController::stopFindingShadows() {
  m_finding.cancel();
  m_stopped = true;
}

void EditController::seekShadows(StudioContext& studio) {
  if (!m_needsShadows || m_stopped || shadowsCurrent(studio) || studio.editor.inGesture()) return;
  const Thresholds& thresholds = studio.document().edits.shadowThresholds;
  if (m_finding.running()) {
    if (m_findingFor != thresholds) m_finding.cancel();
    return;
  }
  m_findingFor = thresholds;
  m_finding.start(
      [set = m_set, thresholds](const Progress& progress) {
        FoundOf all{set, thresholds, {}};
        ShadowOptions options;
        options.thresholds = thresholds;
        std::vector<LightShadows> shadows = detectShadows(*set, options, progress);
        for (size_t i = 0; i < shadows.size(); ++i)
          all.found[set->capture.lights[i].name] =
              std::make_shared<const LightShadows>(std::move(shadows[i]));
        return all;
      },
      m_wake);
}

}  // namespace swaplight
