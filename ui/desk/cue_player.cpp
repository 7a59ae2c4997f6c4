#include "ui/desk/cue_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/look/look_place.h"
#include "core/session/version.h"

namespace swaplight {
namespace {

/// The place in the gallery; `last` is the look that was gone to before.
size_t lookPlace(const std::vector<SavedLook>& looks, const GoRequest& request, const std::string& last) {
  if (looks.empty())
    throw InputError("there are no cues, and the gallery is empty: record makes a cue of what is there");
  const SavedLook* before = findSavedLook(looks, last);
  const auto now = before ? static_cast<size_t>(before - looks.data()) : looks.size();
  if (request.where == GoRequest::Where::Next) {
    if (before && now + 1 == looks.size()) throw InputError("{} is the last look of the gallery", last);
    return before ? now + 1 : 0;
  }
  if (request.where == GoRequest::Where::Back) {
    if (!before || now == 0) throw InputError("there is no look before: go 1 begins");
    return now - 1;
  }
  const std::optional<size_t> place = placeOfLook(looks, request.name);
  if (!place)
    throw InputError("'{}' is no look of the gallery, which has {}: go, go back, go 2 or go with a name",
                     request.name, looks.size());
  return *place;
}

/// The number of a cue that has another one now; its own where it is gone.
int renumbered(int number, const CueList& before, const CueList& now) {
  const Cue* old = findCue(before, number);
  for (const Cue& cue : now) {
    if (!old || findCue(before, cue.number)) continue;
    Cue same = cue;
    same.number = number;
    if (same == *old) return cue.number;
  }
  return number;
}

}  // namespace

std::string CuePlayer::go(const LightsContext& studio, const std::string& where) {
  const GoRequest request = goRequestFromText(where);
  return studio.document().cues.empty() ? goToLook(studio, request) : goToCue(studio, request);
}

std::string CuePlayer::goToCue(const LightsContext& studio, const GoRequest& request) {
  const Cue cue = cueOfRequest(studio.document().cues, request, m_current, m_loaded);
  const float seconds = request.seconds.value_or(cue.fadeSeconds);
  const std::string name = fmt::format("cue {} {}", cueNumberText(cue.number), cue.look);
  // Who goes back wants to stay there: nothing follows.
  const bool back = request.where == GoRequest::Where::Back;
  begin(studio, name, lookOf(cue, studio.document().looks), seconds, back ? std::nullopt : cue.followSeconds);
  m_current = cue.number;
  m_loaded.reset();
  return fmt::format("{} in {:g} s", name, seconds);
}

std::string CuePlayer::goToLook(const LightsContext& studio, const GoRequest& request) {
  const std::vector<SavedLook>& looks = studio.document().looks;
  const size_t place = lookPlace(looks, request, m_lastLook);
  m_lookSeconds = request.seconds.value_or(m_lookSeconds);
  m_lastLook = looks[place].name;
  const SavedLook look = looks[place];
  begin(studio, look.name, look, m_lookSeconds, std::nullopt);
  return fmt::format("{} {} in {:g} s", place + 1, m_lastLook, m_lookSeconds);
}

void CuePlayer::begin(const LightsContext& studio, const std::string& name, const SavedLook& look,
                      float seconds, std::optional<float> followSeconds) {
  studio.editor.commit();  // a fade that is under way ends where it is
  m_wait.reset();
  const Stage from = stageOfDocument(studio.document());
  const uint64_t step = studio.editor.history().stepId();
  m_stood[step] = m_current;
  m_fade = Fade{.name = name,
                .stages = StageFade(from, stageOf(look, from)),
                .shown = from,
                .began = Clock::now(),
                .seconds = seconds,
                .followSeconds = followSeconds,
                .before = m_current,
                .step = step,
                .touched = {},
                .lastStep = step};
}

const Cue* CuePlayer::next(const CueList& cues) const {
  const Cue* loaded = m_loaded ? findCue(cues, *m_loaded) : nullptr;
  return loaded ? loaded : cueAfter(cues, m_current);
}

float CuePlayer::waitSeconds() const {
  if (!m_wait) return 0;
  return std::max(0.F, std::chrono::duration<float>(m_wait->until - Clock::now()).count());
}

void CuePlayer::show(const LightsContext& studio, float amount) {
  m_fade->amount = amount;
  m_fade->shown = m_fade->stages.at(amount);
  m_fade->shown.rig = withLightsAsIn(studio.document().rig, m_fade->touched, std::move(m_fade->shown.rig));
  // While a hand moves something the fade goes on within its step.
  const bool hand = studio.editor.inGesture() && !holdsGesture(studio.editor);
  studio.editor.preview(hand ? studio.editor.gesture() : m_fade->stepName(),
                        withStage(studio.document(), m_fade->shown));
  m_fade->lastStep = studio.editor.history().stepId();
  m_fade->gesture = studio.editor.inGesture();
}

void CuePlayer::update(const LightsContext& studio) {
  if (std::exchange(m_opened, studio.session.opened()) != studio.session.opened()) {
    m_fade.reset();
    m_wait.reset();
    m_current.reset();
    m_loaded.reset();
    m_lastLook.clear();
    m_stood.clear();
    m_step = studio.editor.history().stepId();
    m_list = studio.document().cues;
  }
  if (m_fade) updateFade(studio);
  if (m_wait) updateWait(studio);
  // A gesture is no step of the history yet: what stands on its ground is known.
  if (!m_fade && !studio.editor.inGesture()) followHistory(studio);
}

void CuePlayer::followHistory(const LightsContext& studio) {
  const uint64_t step = studio.editor.history().stepId();
  const CueList& cues = studio.document().cues;
  if (step != m_step) {
    if (const auto stood = m_stood.find(step); stood != m_stood.end()) {
      m_current = stood->second;
      m_loaded.reset();
    } else if (m_current && !findCue(cues, *m_current)) {
      m_current = renumbered(*m_current, m_list, cues);
    }
  }
  m_step = step;
  m_stood[step] = m_current;
  m_list = cues;
}

bool CuePlayer::leaveTouched(const LightsContext& studio) {
  const DocumentEditor& editor = studio.editor;
  const uint64_t step = editor.history().stepId();  // the later the larger
  const bool undone =
      step < m_fade->lastStep || (step == m_fade->lastStep && m_fade->gesture && !editor.inGesture());
  const Stage now = stageOfDocument(studio.document());
  const auto changed =
      now.edits == m_fade->shown.edits ? changedLights(m_fade->shown.rig, now.rig) : std::nullopt;
  if (changed) m_fade->touched.insert(changed->begin(), changed->end());
  if (!undone && changed && m_fade->stages.movesBeside(m_fade->touched)) return true;
  stop(studio);
  return false;
}

/// What came in does not stand. An undo that takes the whole fade back says so by itself.
void CuePlayer::stop(const LightsContext& studio) {
  if (studio.editor.inGesture() || studio.editor.history().stepId() != m_fade->step)
    studio.messages.info(
        fmt::format("{} stopped at {:.0f} %.", withCapital(m_fade->name), 100 * m_fade->amount));
  m_current = m_fade->before;
  m_fade.reset();
}

void CuePlayer::updateFade(const LightsContext& studio) {
  if (stageOfDocument(studio.document()) != m_fade->shown && !leaveTouched(studio)) return;
  m_stood.try_emplace(studio.editor.history().stepId(), m_fade->before);
  const std::chrono::duration<float> elapsed = Clock::now() - m_fade->began;
  const float amount = m_fade->seconds > 0 ? std::min(1.F, elapsed.count() / m_fade->seconds) : 1;
  show(studio, amount);
  if (amount < 1) return;
  if (holdsGesture(studio.editor)) studio.editor.commit();
  if (m_fade->followSeconds && next(studio.document().cues)) {
    const auto wait = std::chrono::duration<float>(*m_fade->followSeconds);
    m_wait = Wait{m_fade->shown, Clock::now() + std::chrono::duration_cast<Clock::duration>(wait)};
  }
  m_fade.reset();
}

void CuePlayer::updateWait(const LightsContext& studio) {
  if (stageOfDocument(studio.document()) != m_wait->stage) {
    m_wait.reset();
    studio.messages.info("The lights were changed: the next cue does not follow by itself.");
    return;
  }
  if (Clock::now() < m_wait->until) return;
  m_wait.reset();
  try {
    go(studio, "next");
  } catch (const InputError& error) {  // its look has been removed meanwhile
    studio.messages.warn(error.what());
  }
}

}  // namespace swaplight
