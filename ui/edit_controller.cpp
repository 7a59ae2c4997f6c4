#include "ui/edit_controller.h"

#include <algorithm>
#include <chrono>
#include <mutex>

#include "core/error.h"
#include "core/shadow/detect_shadows.h"
#include "ui/studio_context.h"

namespace swaplight {
namespace {

constexpr std::chrono::milliseconds kBudget{8};  // a frame, for what is not seen

}  // namespace

void EditController::show(StudioContext& studio, const PixelRect& visible) {
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
    m_followed = false;
    m_complaint.clear();
    m_foundFor.clear();
    m_needsShadows = m_stopped = false;
  }
  takeJobs(studio);
  follow(studio);
  seekShadows(studio);
  if (m_room.edited) update(studio, visible);
}

void EditController::takeJobs(StudioContext& studio) {
  try {
    if (auto room = m_making.take())
      if (&room->edited->original() == m_set.get()) adopt(studio, std::move(*room));
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
    }
  } catch (const Stopped&) {
  } catch (const std::exception& error) {
    studio.messages.error(error.what());
  }
}

void EditController::follow(StudioContext& studio) {
  const EditStack& wanted = studio.document().edits;
  if (m_followed && wanted == m_wanted) return;
  const bool sameLights =
      m_room.edited ? m_room.edited->stack().newLights == wanted.newLights : wanted.newLights.empty();
  if (!m_room.edited && wanted.edits.empty() && wanted.newLights.empty()) {
    m_wanted = wanted;
    m_followed = true;
    return;
  }
  // A rig with other lights than the picture's cannot wait.
  if (!sameLights) {
    m_making.cancel();
    adopt(studio, makeRoom(m_set, m_found, wanted.newLights));
    studio.session.lightsChanged();
  } else if (!m_room.edited) {
    prepare(studio);
    return;
  }
  m_wanted = wanted;
  m_followed = true;
  setStack(studio, usable(wanted));
}

void EditController::prepare(StudioContext& studio) {
  if (m_room.edited || m_making.running() || !studio.set()) return;
  m_making.start([set = m_set, found = m_found](const Progress&) { return makeRoom(set, found, {}); },
                 m_wake);
}

EditController::Room EditController::makeRoom(std::shared_ptr<const SolvedSet> set,
                                              std::shared_ptr<Found> found,
                                              const std::vector<std::string>& newLights) {
  Room room;
  room.edited = std::make_shared<EditedSet>(
      std::move(set),
      [found = std::move(found)](const std::string& light) -> std::shared_ptr<const LightShadows> {
        const auto known = found->find(light);
        if (known == found->end())
          throw InputError("\"{}\" is no light of the set: it has no shadows.", light);
        return known->second;
      });
  EditStack lights;
  lights.newLights = newLights;
  room.edited->setStack(lights);
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
  const auto needs = [](const auto& edit) { return usesShadows(*edit); };
  if (std::any_of(stack.edits.begin(), stack.edits.end(), needs)) m_needsShadows = true;
  if (!m_found->empty()) return stack;
  const size_t all = stack.edits.size();
  stack.edits.erase(std::remove_if(stack.edits.begin(), stack.edits.end(), needs), stack.edits.end());
  if (stack.edits.size() < all) m_stopped = false;  // they are needed now
  return stack;
}

void EditController::setStack(StudioContext& studio, const EditStack& stack) {
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
  std::vector<PixelRect> changed = edited.update(visible);
  while (std::chrono::steady_clock::now() - begin < kBudget) {
    const auto rest = edited.staleTile();
    if (!rest) break;
    const std::vector<PixelRect> more = edited.update(*rest);
    changed.insert(changed.end(), more.begin(), more.end());
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
  return m_room.edited->ground().raster(shape);
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
