#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/cue/cue_list.h"

namespace swaplight {

// What is typed at a desk about cues.
//
//   go, go next         the next cue
//   back, go back       the cue before
//   go 3, go 2.5 in 4   a cue by its number; in 4 s instead of its own time
//
//   cue 3 time 4        it fades in within 4 s
//   cue 3 follow 2      the next cue goes by itself, 2 s after 3 stands; follow off
//   cue 3 look Night    which look or version of the gallery, by number or name; adds the cue where it is new
//   cue 3 number 2.5    moves it
//   cue 3 remove
//   cue 1 thru 3 time 4 several at once; one after the other: cue 3 time 4 follow 2

inline constexpr const char* kCueExamples =
    "cue 3 time 4, cue 3 follow 2, cue 3 look Night, cue 3 number 2.5, cue 3 remove";

/// What `go` says: where to, and in which time where it says so.
struct GoRequest {
  enum class Where { Next, Back, Named };
  Where where = Where::Next;
  std::string name;  ///< Named: a number or a look's name
  std::optional<float> seconds = {};
};
/// `text` is what follows `go`. Throws InputError for a time that is none.
[[nodiscard]] GoRequest goRequestFromText(const std::string& text);

/// The cue that is meant. `current`: the number of the one that stands; `loaded`: of the one that was made
/// the next by hand. Throws InputError where there is none.
[[nodiscard]] const Cue& cueOfRequest(const CueList& cues, const GoRequest& request,
                                      std::optional<int> current, std::optional<int> loaded = {});

/// What a line that follows `cue` makes of a list.
struct CueCommand {
  CueList cues;
  std::string words;  ///< what was done
};
/// Throws InputError: a cue or look that is not there, a word that is none.
[[nodiscard]] CueCommand cueCommand(const CueList& cues, const std::vector<SavedLook>& looks,
                                    std::string_view line);

}  // namespace swaplight
