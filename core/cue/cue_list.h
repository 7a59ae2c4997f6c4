#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/look/saved_look.h"

namespace swaplight {

inline constexpr float kUsualFadeSeconds = 3;
inline constexpr float kMostCueSeconds = 3600;
inline constexpr int kMostCueNumber = 999900;  ///< in hundredths

/// A step of a show, as at a lighting desk: which look or version comes, and how.
struct Cue {
  int number = 100;  ///< in hundredths: 250 is cue 2.5; 1 .. kMostCueNumber, one of its kind in a list
  std::string look;  ///< name of one of the gallery
  float fadeSeconds = kUsualFadeSeconds;    ///< until it stands, 0 .. kMostCueSeconds
  std::optional<float> followSeconds = {};  ///< the next cue goes by itself, so long after this one stands
  bool operator==(const Cue&) const = default;
};

/// In the order of their numbers.
using CueList = std::vector<Cue>;

[[nodiscard]] const Cue* findCue(const CueList& cues, int number);
/// The cue behind and before a number, which need not be there; without a number the first one, and none.
[[nodiscard]] const Cue* cueAfter(const CueList& cues, std::optional<int> number);
[[nodiscard]] const Cue* cueBefore(const CueList& cues, std::optional<int> number);
/// The first whole number behind the last cue.
[[nodiscard]] int freeCueNumber(const CueList& cues);

/// With one more, or another in the place of the one that has its number.
[[nodiscard]] CueList withCue(CueList cues, Cue cue);
[[nodiscard]] CueList withoutCue(CueList cues, int number);
/// After a look of the gallery has another name, or is no more.
[[nodiscard]] CueList withLookRenamed(CueList cues, const std::string& name, const std::string& next);
[[nodiscard]] CueList withoutLook(CueList cues, const std::string& name);

/// The look of a cue. Throws InputError where the gallery has none of this name.
[[nodiscard]] const SavedLook& lookOf(const Cue& cue, const std::vector<SavedLook>& looks);

/// "2", "2.5".
[[nodiscard]] std::string cueNumberText(int number);
/// Nothing for what is no number of a cue.
[[nodiscard]] std::optional<int> cueNumberFromText(const std::string& text);
/// "1, 2, 3"; "none".
[[nodiscard]] std::string cueNumbersText(const CueList& cues);

/// [{"id": 2.5, "look": "Night", "fade": 3, "follow": 1} ...]: numbers, seconds.
[[nodiscard]] Json jsonFromCues(const CueList& cues);
/// `where` begins the messages. Throws InputError.
[[nodiscard]] CueList cuesFromJson(const Json& json, const std::string& where);

}  // namespace swaplight
