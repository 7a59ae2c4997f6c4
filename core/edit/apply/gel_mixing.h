#pragma once

#include <optional>

#include "core/color/rgb.h"
#include "core/edit/apply/highlight_row.h"
#include "core/edit/operations/unknown_gel_operation.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// What a set's two lights are if the gel that changed places with a known one, k, had the colour m' instead
/// of m. Both photographs, k A + m B and m A + k B, stay as they are in every channel:
///   A' + B' = (k + m) / (k + m') (A + B),   A' - B' = (k - m) / (k - m') (A - B)
/// (docs/theory.md, Unknown colours; where the lamps differ, of A times the root of their ratio).
struct GelMixing {
  int lights[2] = {0, 1};
  float factor[3][2][2] = {};  ///< [channel][of A' or B'][times A, times B]
  Rgb color{1};                ///< m'
};

/// Throws InputError where the set has no such gel.
[[nodiscard]] GelMixing gelMixing(const SolvedSet& set, const UnknownGelOperation& operation);

/// The operation at which the set is as it was solved; nothing where it has no such gel.
[[nodiscard]] std::optional<UnknownGelOperation> solvedGel(const SolvedSet& set);

/// Rows of both lights, R G B apart, and of the set at unit white, which follows their sum. mask: 0..1.
struct GelRows {
  HighlightRow light[2][3];
  float* white[3];
  float* inverseGrey;  ///< 1 / (r + g + b) of `white`
};
void changeGelRow(const GelMixing& mixing, const float* mask, int count, const GelRows& rows);

}  // namespace swaplight
