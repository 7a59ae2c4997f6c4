#include "core/cue/cue_timeline.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/cue/cue_span.h"
#include "core/relight/rig_edit.h"
#include "core/relight/setting.h"

namespace swaplight {
namespace {

/// A light's settings, frame after frame, as the fewest keys that say the same: of frames that are alike the
/// first and the last.
std::vector<RigAnimation::Key> keysOf(const std::vector<std::string>& settings, int firstFrame) {
  std::vector<RigAnimation::Key> keys;
  for (size_t i = 0; i < settings.size(); ++i) {
    const bool likeBefore = i > 0 && settings[i] == settings[i - 1];
    const bool likeAfter = i + 1 == settings.size() || settings[i] == settings[i + 1];
    if (!likeBefore || !likeAfter) keys.push_back({firstFrame + static_cast<int>(i), settings[i]});
  }
  return keys;
}

void checkTiming(const CueTiming& timing) {
  constexpr double kMostRate = 1000;
  if (!(timing.framesPerSecond >= 1 && timing.framesPerSecond <= kMostRate))
    throw InputError("{} frames a second: expected 1 to {:.0f}", timing.framesPerSecond, kMostRate);
  if (!(timing.holdSeconds >= 0 && timing.holdSeconds <= kMostCueSeconds))
    throw InputError("a hold of {} s: expected 0 to {:.0f}", timing.holdSeconds, kMostCueSeconds);
}

}  // namespace

CueTimeline::CueTimeline(const CueList& cues, const std::vector<SavedLook>& looks, const Stage& now,
                         const CueTiming& timing) {
  checkTiming(timing);
  if (cues.empty()) throw InputError("the cue list is empty: make cues in the studio first (panel Cues)");
  const auto frame = [&](double seconds) {
    const double frames = std::round(seconds * timing.framesPerSecond);
    if (frames > kMostCueFrames)
      throw InputError("the cue list is longer than {} frames: shorten its times", kMostCueFrames);
    return timing.firstFrame + static_cast<int>(frames);
  };
  const std::vector<CueSpan> spans = cueSpans(cues, timing.holdSeconds);
  Stage stage = now;
  for (size_t i = 0; i < cues.size(); ++i) {
    const Stage next = stageOf(lookOf(cues[i], looks), stage);
    Place place{cues[i], frame(spans[i].begins), frame(spans[i].stands), 0};
    if (!m_places.empty()) {
      place.begins = m_places.back().ends;
      place.stands = std::max(place.stands, place.begins + 1);
    }
    place.ends = std::max(frame(spans[i].ends), place.stands);
    m_fades.emplace_back(m_places.empty() ? next : stage, next);
    m_places.push_back(place);
    stage = next;
  }
}

size_t CueTimeline::placeAt(int frame) const {
  const auto found =
      std::find_if(m_places.begin(), m_places.end(), [&](const Place& place) { return frame <= place.ends; });
  return static_cast<size_t>(std::min(found, m_places.end() - 1) - m_places.begin());
}

Stage CueTimeline::at(int frame) const {
  const size_t index = placeAt(frame);
  const Place& place = m_places[index];
  if (frame >= place.stands || place.stands == place.begins) return m_fades[index].to();
  return m_fades[index].at(static_cast<float>(frame - place.begins) /
                           static_cast<float>(place.stands - place.begins));
}

bool CueTimeline::stands(const EditStack& edits) const {
  return std::any_of(m_fades.begin(), m_fades.end(),
                     [&](const StageFade& fade) { return fade.to().edits == edits; });
}

bool CueTimeline::editsChange() const {
  return std::any_of(m_fades.begin(), m_fades.end(),
                     [&](const StageFade& fade) { return !(fade.to().edits == m_fades.front().to().edits); });
}

Rig CueTimeline::keyedRig() const {
  Rig keyed;
  for (const StageFade& fade : m_fades)
    for (const LightSetting& light : fade.to().rig.lights)
      if (std::none_of(keyed.lights.begin(), keyed.lights.end(),
                       [&](const LightSetting& known) { return known.light == light.light; }))
        keyed.lights.push_back(light);
  return unitWhiteRig(withoutGroups(std::move(keyed)));
}

RigAnimation CueTimeline::animation() const {
  const Rig keyed = keyedRig();
  std::map<std::string, std::vector<std::string>> settings;
  for (int frame = firstFrame(); frame <= lastFrame(); ++frame) {
    const Rig rig = withoutGroups(at(frame).rig);
    for (const LightSetting& light : keyed.lights) {
      const auto now = std::find_if(rig.lights.begin(), rig.lights.end(),
                                    [&](const LightSetting& other) { return other.light == light.light; });
      settings[light.light].push_back(now == rig.lights.end() ? "off" : settingText(*now));
    }
    settings[kAmbientName].push_back(fmt::format("x{}", rig.ambient));
  }
  RigAnimation animation;
  for (const auto& [name, all] : settings) animation.lights[name] = keysOf(all, firstFrame());
  return animation;
}

}  // namespace swaplight
