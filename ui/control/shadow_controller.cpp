#include "ui/control/shadow_controller.h"

#include <algorithm>

#include "ui/control/light_edit.h"
#include "ui/control/shadow_edit.h"
#include "ui/control/studio_context.h"

namespace swaplight {
namespace {

constexpr size_t kKept = 12;  // outlines, of several lights and thresholds

/// What a job has made; what went wrong becomes a message.
template <typename Result>
std::optional<Result> taken(StudioContext& studio, Job<Result>& job) {
  try {
    return job.take();
  } catch (const Stopped&) {
  } catch (const std::exception& error) {
    studio.messages.error(error.what());
  }
  return std::nullopt;
}

}  // namespace

void ShadowController::follow(StudioContext& studio) {
  const std::shared_ptr<const SolvedSet>& set = studio.set()->original;
  if (m_set == set) return;
  m_set = set;
  m_preview.reset();
  m_previewFailed = false;
  m_drawn.clear();
  m_click.reset();
  m_chosenOf.reset();
  m_seen.clear();
  m_previewing.cancel();
  studio.editing.shadow.chosen.reset();
}

void ShadowController::show(StudioContext& studio) {
  if (!studio.set()) return;
  follow(studio);
  makePreview(studio);
  drawOutlines(studio);
  resolveClick(studio);
}

void ShadowController::makePreview(StudioContext& studio) {
  const bool going = m_previewing.running();
  if (auto preview = taken(studio, m_previewing); preview && !m_preview) m_preview = std::move(*preview);
  if (m_preview || m_previewFailed) return;
  if (going && !m_previewing.running() && !m_previewing.cancelling()) {
    m_previewFailed = true;
    return;
  }
  if (m_previewing.running()) return;
  m_previewing.start(
      [set = m_set](const Progress& progress) {
        return std::make_shared<const ShadowPreview>(*set, progress);
      },
      m_wake);
}

void ShadowController::drawOutlines(StudioContext& studio) {
  if (auto drawn = taken(studio, m_drawing)) {
    m_drawn.push_back(std::move(*drawn));
    if (m_drawn.size() > kKept) m_drawn.pop_front();
  }
  const int light = shadowLight(studio);
  if (light < 0) return;
  const std::string& name = m_set->capture.lights[static_cast<size_t>(light)].name;
  const std::shared_ptr<const LightShadows> found = studio.edits.shadows(studio, name);
  const bool exact = found && studio.edits.shadowsCurrent(studio);
  if (!exact && !m_preview) return;
  const std::optional<float> threshold = shadowThresholdOf(studio.document(), name);
  const auto wanted = [&](const Drawn& drawn) {
    return drawn.light == light &&
           (exact ? drawn.exact == found : !drawn.exact && drawn.threshold == threshold);
  };
  if (const auto known = std::find_if(m_drawn.begin(), m_drawn.end(), wanted); known != m_drawn.end()) {
    m_drawn.splice(m_drawn.end(), m_drawn, known);
    return;
  }
  if (m_drawing.running()) return;
  Drawn next{light, threshold, exact ? found : nullptr, {}};
  m_drawing.start(
      [next = std::move(next), preview = m_preview](const Progress&) {
        Drawn drawn = next;
        drawn.outlines = drawn.exact
                             ? shadowOutlines(drawn.exact->labels, drawn.exact->visibility.width())
                             : preview->shadows(static_cast<size_t>(drawn.light), drawn.threshold).outlines();
        return drawn;
      },
      m_wake);
}

const ShadowOutlines* ShadowController::outlines(const StudioContext& studio) const {
  const int light = shadowLight(studio);
  const auto last = std::find_if(m_drawn.rbegin(), m_drawn.rend(),
                                 [&](const Drawn& drawn) { return drawn.light == light; });
  return last == m_drawn.rend() ? nullptr : &last->outlines;
}

void ShadowController::choose(StudioContext& studio, int x, int y) {
  const int light = shadowLight(studio);
  if (light < 0) return;
  m_click = Click{m_set->capture.lights[static_cast<size_t>(light)].name, x, y};
  studio.edits.findShadowsAgain();
}

void ShadowController::chooseAll(StudioContext& studio) {
  m_click.reset();
  studio.editing.shadow.chosen.reset();
}

void ShadowController::resolveClick(StudioContext& studio) {
  ShadowState& state = studio.editing.shadow;
  if (auto chosen = taken(studio, m_choosing)) {
    state.light = chosen->click.light;
    m_chosenOf = chosen->of;
    if (!chosen->shadow)
      studio.messages.info("There is no shadow of " + state.light + " here: all of them are chosen.");
    state.chosen = std::move(chosen->shadow);
  }
  if (!studio.edits.shadowsCurrent(studio)) return;
  // Another threshold makes another shadow around the same place.
  if (state.chosen && !m_click && studio.edits.shadows(studio, state.light) != m_chosenOf)
    m_click = Click{state.light, state.chosen->x, state.chosen->y};
  if (!m_click || m_choosing.running()) return;
  const Click click = *std::exchange(m_click, std::nullopt);
  m_choosing.start(
      [click, found = studio.edits.shadows(studio, click.light)](const Progress&) {
        return Chosen{click, found, connectedShadowAt(*found, click.x, click.y)};
      },
      m_wake);
}

const Pyramid* ShadowController::visibility(StudioContext& studio, int light) {
  follow(studio);
  if (light >= m_set->lightCount()) return nullptr;
  const auto found = studio.edits.shadows(studio, m_set->capture.lights[static_cast<size_t>(light)].name);
  if (!found) return nullptr;
  Seen& seen = m_seen[light];
  if (seen.shadows != found) {
    seen = {found, std::make_unique<Pyramid>(found->visibility.view())};
    studio.pictures.forget();
  }
  return seen.pyramid.get();
}

}  // namespace swaplight
