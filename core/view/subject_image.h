#pragma once

#include <array>
#include <string>

#include "core/image/image.h"
#include "core/set/solved_set.h"
#include "core/view/view_subject.h"

namespace swaplight {

/// The picture of a subject that is not a sum of contributions. Beta is one channel, 0..1. Reflectance is
/// what the lights at unit white show of the set together (T = beta x reflectance, shares adding up to 1), in
/// the set's colour space. Highlights and what is left without them are light in it. Residual, sigma and
/// flags are three channels of display codes 0..1, without a colour space: viridis up to the value below; a
/// colour a bit. Throws std::logic_error for the other subjects.
[[nodiscard]] Image subjectImage(const SolvedSet& set, const ViewSubject& subject);

/// Whether only a set that knows its highlights has it.
[[nodiscard]] bool ofHighlights(const ViewSubject& subject);

/// The subject as this set has it: an index that it lacks becomes the last, of highlights that it lacks the
/// lit picture.
[[nodiscard]] ViewSubject subjectWithin(const SolvedSet& set, ViewSubject subject);

inline constexpr float kResidualShown = 4;  ///< the residual that is brightest
inline constexpr float kSigmaShown = 0.2F;  ///< the relative standard error that is brightest

/// A bit of quality.flags with its colour (display codes) and word, for pictures and legends.
struct FlagColor {
  PixelFlag flag;
  Rgb color;
  const char* label;
};
inline const std::array<FlagColor, 5> kFlagColors{{{kClipped, {0.90F, 0.25F, 0.20F}, "clipped"},
                                                   {kTooDark, {0.20F, 0.35F, 0.85F}, "too dark"},
                                                   {kMoved, {0.95F, 0.75F, 0.20F}, "moved"},
                                                   {kNotFinite, {0.85F, 0.30F, 0.85F}, "not finite"},
                                                   {kFilled, {0.25F, 0.75F, 0.40F}, "filled in"}}};

/// The words for the bits that are set, apart by commas; empty for none.
[[nodiscard]] std::string flagWords(int flags);

}  // namespace swaplight
