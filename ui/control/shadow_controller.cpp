#include "ui/control/shadow_controller.h"

#include <algorithm>

#include "ui/control/shadow_edit.h"
#include "ui/jobs/take_or_report.h"

namespace swaplight {
namespace {

constexpr size_t kKeptOutlines = 12;  // outlines, of several lights and thresholds

}  // namespace

int ShadowController::light() const {
  return shadowLight(m_parts.lights, *m_parts.session.set());
}

void ShadowController::follow() {
  const std::shared_ptr<const SolvedSet>& set = m_parts.session.set()->original;
  if (m_set == set) return;
  m_set = set;
  m_preview.reset();
  m_previewFailed = false;
  m_drawn.clear();
  m_click.reset();
  m_chosenOf.reset();
  m_seen.clear();
  m_previewing.drop();
  m_drawing.drop();
  m_choosing.drop();
  m_parts.state.chosen.reset();
}

void ShadowController::show() {
  if (!m_parts.session.set()) return;
  follow();
  makePreview();
  drawOutlines();
  resolveClick();
}

void ShadowController::makePreview() {
  const Taken taken = takeOrReport(m_previewing, m_parts.messages, "the shadows",
                                   [this](std::shared_ptr<const ShadowPreview> preview) {
                                     if (!m_preview) m_preview = std::move(preview);
                                   });
  if (taken == Taken::Failed) m_previewFailed = true;
  if (m_preview || m_previewFailed || m_previewing.running()) return;
  m_previewing.start(
      [set = m_set](const Progress& progress) {
        return std::make_shared<const ShadowPreview>(*set, progress);
      },
      m_wake);
}

void ShadowController::drawOutlines() {
  takeOrReport(m_drawing, m_parts.messages, "outlines of shadows", [this](Drawn drawn) {
    m_drawn.push_back(std::move(drawn));
    if (m_drawn.size() > kKeptOutlines) m_drawn.pop_front();
  });
  const int light = this->light();
  if (light < 0) return;
  const std::string& name = nameOf(light);
  const std::shared_ptr<const LightShadows> found = m_parts.edits.shadows(name);
  const bool exact = found && m_parts.edits.shadowsCurrent();
  if (!exact && !m_preview) return;
  const Document& document = m_parts.lights.document();
  Drawn next{
      light, shadowThresholdOf(document, name), shadowMarksOf(document, name), exact ? found : nullptr, {}};
  const auto wanted = [&](const Drawn& drawn) {
    if (drawn.light != light) return false;
    if (exact) return drawn.exact == found;
    return !drawn.exact && drawn.threshold == next.threshold && drawn.marks == next.marks;
  };
  if (const auto known = std::find_if(m_drawn.begin(), m_drawn.end(), wanted); known != m_drawn.end()) {
    m_drawn.splice(m_drawn.end(), m_drawn, known);
    return;
  }
  if (m_drawing.running()) return;
  m_drawing.start(
      [next = std::move(next), preview = m_preview](const Progress&) {
        Drawn done = next;
        done.shown = drawn(next, preview.get());
        return done;
      },
      m_wake);
}

ShadowController::Shown ShadowController::drawn(const Drawn& wanted, const ShadowPreview* preview) {
  if (wanted.exact) {
    const int width = wanted.exact->visibility.width();
    return {shadowOutlines(wanted.exact->labels, width), UntoldPixels(wanted.exact->labels, width, 1)};
  }
  const PreviewedShadows seen =
      preview->shadows(static_cast<size_t>(wanted.light), wanted.threshold, wanted.marks);
  return {seen.outlines(), UntoldPixels(seen.labels, seen.width, seen.scale)};
}

const ShadowController::Shown* ShadowController::shown() const {
  if (!m_parts.session.set()) return nullptr;
  const int light = this->light();
  const auto last = std::find_if(m_drawn.rbegin(), m_drawn.rend(),
                                 [&](const Drawn& drawn) { return drawn.light == light; });
  return last == m_drawn.rend() ? nullptr : &last->shown;
}

void ShadowController::choose(int x, int y) {
  if (!m_parts.session.set()) return;
  follow();
  const int light = this->light();
  if (light < 0) return;
  m_click = Click{nameOf(light), x, y};
  m_parts.edits.findShadowsAgain();
}

void ShadowController::chooseAll() {
  m_click.reset();
  m_parts.state.chosen.reset();
}

void ShadowController::resolveClick() {
  ShadowState& state = m_parts.state;
  takeOrReport(m_choosing, m_parts.messages, "this shadow", [&](Chosen chosen) {
    state.light = chosen.click.light;
    m_chosenOf = chosen.of;
    if (!chosen.shadow)
      m_parts.messages.info("There is no shadow of " + state.light +
                            " here: all of its shadows are selected.");
    state.chosen = std::move(chosen.shadow);
  });
  if (!m_parts.edits.shadowsCurrent()) return;
  // Another threshold makes another shadow around the same place.
  if (state.chosen && !m_click && m_parts.edits.shadows(state.light) != m_chosenOf)
    m_click = Click{state.light, state.chosen->x, state.chosen->y};
  if (!m_click || m_choosing.running()) return;
  const Click click = *std::exchange(m_click, std::nullopt);
  m_choosing.start(
      [click, found = m_parts.edits.shadows(click.light)](const Progress&) {
        return Chosen{click, found, connectedShadowAt(*found, click.x, click.y)};
      },
      m_wake);
}

const Pyramid* ShadowController::visibility(int light) {
  follow();
  if (light >= m_set->lightCount()) return nullptr;
  const auto found = m_parts.edits.shadows(nameOf(light));
  if (!found) return nullptr;
  Seen& seen = m_seen[light];
  if (seen.shadows != found) seen = {found, std::make_unique<Pyramid>(found->visibility.view())};
  return seen.pyramid.get();
}

}  // namespace swaplight
