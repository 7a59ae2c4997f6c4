#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"

namespace swaplight {

/// What may be the reason why photographs do not fit the matte model under the colours as told.
enum class Cause {
  Colors,   ///< the lights' colours are not those told
  Ambient,  ///< light that no lamp gives: ambient light, a raised black level
  Tone,     ///< the files are coded by another tone curve than the one that was taken off
  Moved,    ///< the camera moved: shifted, turned or zoomed between the shots
  Field,    ///< lamps whose colour is not the same over the picture
};

/// How well one cause explains the misfit.
struct CauseEvidence {
  Cause cause = Cause::Colors;
  double explained = 0;  ///< part of the misfit's variance that it takes away, 0..1
  double gain = 0;       ///< of log likelihood, a pixel, in parts of the picture that were not fitted to
  double certainty = 0;  ///< of the gain, in its standard errors over the parts of the picture
  double behind = 0;     ///< standard errors by which the best cause is better; 0 for that one
  /// Colors and Field: relative error (RMS). Ambient: over the lamps' light. Tone: the exponent that was put
  /// on the light, less 1. Moved: pixels; where much of the picture is edges it is up to twice as many.
  double size = 0;
};

/// From what size on a cause would not go unsaid in photographs like these (CauseEvidence::size, of Tone its
/// magnitude); nothing: the largest that is tried may.
struct CauseSight {
  Cause cause = Cause::Colors;
  std::optional<double> from;
};

/// All causes, held against each other.
struct MisfitCauses {
  std::vector<CauseEvidence> all;  ///< the best first; empty: not looked for, or nothing to see them by
  /// Those that may be it, first that which there is evidence for, which need not explain most. None: no
  /// misfit that matters. More than one: it cannot be told which.
  std::vector<Cause> likely;
  /// Something is wrong all over the picture, and none of them is surely it.
  bool unnamed = false;
  /// What would not go unsaid. Empty: not looked for, as where something is said.
  std::vector<CauseSight> sight;

  /// The one cause there is evidence for.
  [[nodiscard]] bool is(Cause cause) const { return likely.size() == 1 && likely.front() == cause; }
};

/// A report's "misfit_causes".
[[nodiscard]] Json jsonFromMisfitCauses(const MisfitCauses& causes);
/// What is missing or unknown, as a cause that a newer version tells of, is left out.
[[nodiscard]] MisfitCauses misfitCausesFromJson(const Json& json);

/// "colors", "ambient", "tone", "moved", "field".
[[nodiscard]] const char* causeName(Cause cause);
/// What was done about causes already, and did not end them.
struct TriedRemedies {
  bool aligned = false;
  bool toneTaken = false;
};
/// For a person: what the photographs look like, and what to do about it. Empty where
/// nothing is wrong.
[[nodiscard]] std::string wordsFor(const MisfitCauses& causes, const TriedRemedies& tried = {});

/// For a person: what may be wrong all the same. Empty where that was not looked for.
[[nodiscard]] std::string unseenWords(const MisfitCauses& causes);

}  // namespace swaplight
