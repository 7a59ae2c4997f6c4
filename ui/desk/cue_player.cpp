#include "ui/desk/cue_player.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/look/rig_blend.h"
#include "core/look/saved_look.h"

namespace swaplight {
namespace {

/// Where to, and in which time.
struct GoWords {
  std::string where;
  std::optional<float> seconds;
};

float secondsFrom(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  if (text.ends_with('s')) text.pop_back();
  const std::optional<float> seconds = numberFromText(text);
  if (!seconds || *seconds < 0 || *seconds > CuePlayer::kMostSeconds)
    throw InputError("'{}' is no fade time: write seconds from 0 to {:.0f}, as go 3 in 2.5", text,
                     CuePlayer::kMostSeconds);
  return *seconds;
}

GoWords goWords(const std::string& text) {
  const std::string padded = " " + text;
  const size_t in = padded.rfind(" in ");
  if (in == std::string::npos) return {text, std::nullopt};
  return {in == 0 ? "" : text.substr(0, in - 1), secondsFrom(text.substr(in + 3))};
}

/// The place in the gallery; `last` is the look that was gone to before.
size_t placeOf(const std::vector<SavedLook>& looks, const std::string& where, const std::string& last) {
  if (looks.empty()) throw InputError("the gallery is empty: save lightings as looks first (Shift+K)");
  const SavedLook* before = findSavedLook(looks, last);
  const auto now = before ? static_cast<size_t>(before - looks.data()) : looks.size();
  if (where.empty() || where == "next") {
    if (before && now + 1 == looks.size()) throw InputError("{} is the last look of the gallery", last);
    return before ? now + 1 : 0;
  }
  if (where == "back") {
    if (!before || now == 0) throw InputError("there is no look before: go 1 begins");
    return now - 1;
  }
  if (const SavedLook* named = findSavedLook(looks, where)) return static_cast<size_t>(named - looks.data());
  const std::optional<float> number = numberFromText(where);
  if (!number || *number < 1 || *number > static_cast<float>(looks.size()) || *number != std::floor(*number))
    throw InputError("'{}' is no look of the gallery, which has {}: go, go back, go 2 or go with a name",
                     where, looks.size());
  return static_cast<size_t>(*number) - 1;
}

}  // namespace

std::string CuePlayer::go(const LightsContext& studio, const std::string& where) {
  const GoWords words = goWords(where);
  const std::vector<SavedLook>& looks = studio.document().looks;
  const size_t place = placeOf(looks, words.where, m_last);
  studio.editor.commit();  // a fade that is under way ends where it is
  m_seconds = words.seconds.value_or(m_seconds);
  m_last = looks[place].name;
  const Rig& from = studio.document().rig;
  m_fade = Fade{m_last, from, blendRigs(from, looks[place].rig, 1), from, Clock::now(), m_seconds};
  return fmt::format("{} {} in {:g} s", place + 1, m_last, m_seconds);
}

void CuePlayer::show(const LightsContext& studio, float amount) {
  m_fade->shown = blendRigs(m_fade->from, m_fade->to, amount);
  Document next = studio.document();
  next.rig = m_fade->shown;
  studio.editor.preview("Go " + m_fade->name, std::move(next));
}

void CuePlayer::update(const LightsContext& studio) {
  if (!m_fade) return;
  if (studio.document().rig != m_fade->shown) {  // somebody else has changed the lights
    m_fade.reset();
    return;
  }
  const std::chrono::duration<float> elapsed = Clock::now() - m_fade->began;
  const float amount = m_fade->seconds > 0 ? std::min(1.F, elapsed.count() / m_fade->seconds) : 1;
  show(studio, amount);
  if (amount < 1) return;
  studio.editor.commit();
  m_fade.reset();
}

}  // namespace swaplight
