#pragma once

#include <string>

#include "core/capture/capture.h"
#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// Light that no one controls, the same in every shot, solved for as one more light of the set that is never
/// changed (but by the exposure). What it is called then: no light of a person's can be.
inline constexpr const char* kAmbientLight = "ambient light";

/// The capture with the ambient light as its last one, white in every shot. Throws InputError where it has an
/// ambient picture already, or not more shots than lights: then nothing tells the ambient light apart.
[[nodiscard]] Capture withAmbientLight(const Capture& capture, const std::string& where);

/// The ambient light's colour, mean 1: on a matte surface the ratio of its contribution to that of the other
/// lights is beta / (1 - beta) times its colour, so that ratios of channels say it; the median over a sample
/// of the set, demultiplexed. White where too little is seen of it. `context`: of withAmbientLight().
[[nodiscard]] Rgb ambientColor(const EstimatorContext& context, const ShotSignal& signal,
                               const AmbientTuning& tuning = {});

/// Gives the last light a colour (in place of white).
void colorAmbient(LightingMatrix& lighting, const Rgb& color);

/// Moves the last light, of this colour, out of a solved set's lights into its ambient picture; proportions
/// are those of the lights that are left. `capture`: the set's, without it.
void takeAmbientOut(const Capture& capture, const Rgb& color, SolvedSet& set);

}  // namespace swaplight
