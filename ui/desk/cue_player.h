#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "core/cue/cue_command.h"
#include "core/cue/stage.h"
#include "ui/control/lights_context.h"

namespace swaplight {

/// Plays the cue list: GO, BACK and follows, each cue faded in as dimmers would do it (core/cue/stage.h).
/// While there are no cues it goes through the gallery in the same way. A fade is one step of the history. A
/// light that somebody touches meanwhile leaves it, and the others finish theirs (from then on in steps of
/// their own); whoever touches edits, groups or all lights that move ends it where it is. Whoever touches
/// anything of it ends the wait for the next cue.
class CuePlayer {
 public:
  /// What follows `go` in a command (core/cue/cue_command.h); looks of the gallery by number or name. Returns
  /// what it does, in words. Throws InputError.
  std::string go(const LightsContext& studio, const std::string& where);
  /// A cue stands already: it has been made of what there is.
  void stand(int number) {
    m_current = number;
    m_loaded.reset();
  }
  /// Makes a cue the next one.
  void load(int number) { m_loaded = number; }
  /// To be called every frame: shows how far the fade is; goes on where a cue follows.
  void update(const LightsContext& studio);

  [[nodiscard]] bool fading() const { return m_fade.has_value(); }
  /// The gesture that is under way is the fade, not the hand of a person.
  [[nodiscard]] bool holdsGesture(const DocumentEditor& editor) const {
    return m_fade && editor.gesture() == m_fade->stepName();
  }
  /// The next cue is going to come by itself.
  [[nodiscard]] bool waiting() const { return m_wait.has_value(); }
  /// How far the fade is, 0..1.
  [[nodiscard]] float amount() const { return m_fade ? m_fade->amount : 0; }
  /// Seconds until the next cue comes by itself.
  [[nodiscard]] float waitSeconds() const;
  /// The number of the cue that stands or comes in; nothing before the first GO.
  [[nodiscard]] std::optional<int> current() const { return m_current; }
  /// The cue that GO goes to; nullptr at the end.
  [[nodiscard]] const Cue* next(const CueList& cues) const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Fade {
    std::string name;
    StageFade stages;
    Stage shown;  ///< what the fade made last
    Clock::time_point began;
    float seconds = 0;
    float amount = 0;
    std::optional<float> followSeconds;
    std::optional<int> before;      ///< the cue that stood
    uint64_t step = 0;              ///< of the history, on which it lies
    std::set<std::string> touched;  ///< lights that somebody has taken out of it
    uint64_t lastStep = 0;          ///< of the history, last time; and whether there was a gesture
    bool gesture = false;
    [[nodiscard]] std::string stepName() const { return "Go " + name; }
  };
  struct Wait {
    Stage stage;  ///< as the cue left it
    Clock::time_point until;
  };
  std::string goToCue(const LightsContext& studio, const GoRequest& request);
  std::string goToLook(const LightsContext& studio, const GoRequest& request);
  void begin(const LightsContext& studio, const std::string& name, const SavedLook& look, float seconds,
             std::optional<float> followSeconds);
  void show(const LightsContext& studio, float amount);
  void updateFade(const LightsContext& studio);
  /// Takes lights out of the fade that somebody has changed. False where that ends it.
  bool leaveTouched(const LightsContext& studio);
  void stop(const LightsContext& studio);
  /// The cue that stands follows undo, redo and new numbers.
  void followHistory(const LightsContext& studio);
  void updateWait(const LightsContext& studio);

  std::optional<Fade> m_fade;
  std::optional<Wait> m_wait;
  std::optional<int> m_current, m_loaded;
  std::map<uint64_t, std::optional<int>> m_stood;  ///< which cue stood at a step of the history, by its id
  uint64_t m_step = 0;
  CueList m_list;         ///< as it was at that step
  uint64_t m_opened = 0;  ///< the document that they are of
  std::string m_lastLook;
  float m_lookSeconds = kUsualFadeSeconds;  ///< looks have no time of their own: the last one that was said
};

}  // namespace swaplight
