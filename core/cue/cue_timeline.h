#pragma once

#include <vector>

#include "core/cue/cue_list.h"
#include "core/cue/stage.h"
#include "core/relight/rig_animation.h"

namespace swaplight {

inline constexpr int kMostCueFrames = 100000;

/// How a cue list becomes frames.
struct CueTiming {
  double framesPerSecond = 24;  ///< 1 .. 1000
  double holdSeconds = 1;  ///< a cue without follow stands so long: nobody presses GO. 0 .. kMostCueSeconds
  int firstFrame = 1;
  bool operator==(const CueTiming&) const = default;
};

/// A cue list played from its beginning: the first cue stands at the first frame (its own fade has nothing to
/// come from), stands for its follow time, or the hold; then the next one fades in within its time, and so
/// on; the last one stands for the hold. Times are added up before they are rounded to frames, so that
/// nothing drifts; a fade of no time is a cut from one frame to the next.
class CueTimeline {
 public:
  /// `now`: what stands before, for looks that do not say all. Throws InputError: an empty list, a cue
  /// without a look, more than kMostCueFrames frames.
  CueTimeline(const CueList& cues, const std::vector<SavedLook>& looks, const Stage& now,
              const CueTiming& timing);

  struct Place {
    Cue cue;
    int begins = 0;  ///< the last frame before its fade
    int stands = 0;  ///< the first one that shows it whole
    int ends = 0;    ///< the last one: where the next fade begins
  };
  [[nodiscard]] const std::vector<Place>& places() const { return m_places; }
  [[nodiscard]] int firstFrame() const { return m_places.front().stands; }
  [[nodiscard]] int lastFrame() const { return m_places.back().ends; }

  /// Before the first frame and behind the last one it stands.
  [[nodiscard]] Stage at(int frame) const;
  /// Whether a cue that stands has these edits: no fade on its way.
  [[nodiscard]] bool stands(const EditStack& edits) const;
  /// Whether edits differ between cues.
  [[nodiscard]] bool editsChange() const;

  /// The same as keys of lights, of which `relight --key` makes the same frames: every frame of a fade is a
  /// key, since a fade is even in light and keys are even in stops. They say all of a light: they are over
  /// lights at unit white (keyedRig). Levels of ambient light stand under "ambient".
  [[nodiscard]] RigAnimation animation() const;
  /// Every light of the show at unit white.
  [[nodiscard]] Rig keyedRig() const;

 private:
  [[nodiscard]] size_t placeAt(int frame) const;

  std::vector<Place> m_places;
  std::vector<StageFade> m_fades;  ///< to the cue of this place
};

}  // namespace swaplight
