#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/plan/plan_noise.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/solve_options.h"

namespace swaplight {

/// A colour that a light can be given.
struct PlanColor {
  std::string name;
  Rgb color{1, 1, 1};  ///< linear, >= 0
};

/// How colours go from shot to shot.
enum class PlanCoding {
  Rotation,  ///< light i has colour i + k of a ring in shot k: with a whole turn every light carries each
             ///< colour
  Free,      ///< any colour on any light in any shot
};

struct PlanSearchOptions {
  std::vector<std::string> lights;  ///< names, 2 .. kMaxLights
  int shots = 0;                    ///< 1 .. kMaxShots; 0: one a light
  PlanCoding coding = PlanCoding::Rotation;
  bool repeat = false;        ///< a rotation may hold a colour twice
  Model model = Model::Auto;  ///< whose error is minimised: Lambert's, Transport's, or Auto: the mean of both
  SensorNoise noise{.002, 20000};
  float exposureStops = 0;  ///< at 0 a white surface facing a light of colour 1 is at half of full scale
};

/// The best plan that was found.
struct PlanChoice {
  LightingMatrix plan;          ///< exposure included
  std::vector<int> colorIndex;  ///< [shot * lights + light], into the colours at hand
  double cost = 0;              ///< what was minimised: the squared relative error of T at typical pixels
  size_t tried = 0;             ///< plans that were compared
  bool exhaustive = false;      ///< all there are
};

/// The colours and their assignment to lights and shots with the smallest mean predicted variance (matteCost
/// or transportCost over typical pixels). All plans are compared where there are few; else a local search
/// (change or swap one colour) from many starts of a fixed seed: the answer is always the same. More shots
/// than lights: a ring of as many colours as lights and one of as many as shots are both tried. Throws
/// InputError where the plan is impossible: too few colours or shots, lights or shots out of range.
[[nodiscard]] PlanChoice searchPlan(const std::vector<PlanColor>& colors, const PlanSearchOptions& options,
                                    const Progress& progress = {});

/// The plan that gives every light of every shot the named colour. For messages, tests and brute force.
[[nodiscard]] LightingMatrix lightingFromIndices(const std::vector<PlanColor>& colors,
                                                 const std::vector<int>& index,
                                                 const PlanSearchOptions& options);

/// The colours of an RGB panel that are worth trying: each channel at 10, 40 or 100 %, one at least at 100.
[[nodiscard]] std::vector<PlanColor> panelColors();

/// Colours from a text, joined by commas or spaces: linear r/g/b, `panels`, or whatever a light's setting may
/// be
/// (#rrggbb, gel:L106, 3200K, off). Throws InputError that quotes the part that is wrong.
[[nodiscard]] std::vector<PlanColor> planColorsFromText(const std::string& text);
/// Gels from a text: their numbers joined by commas (L106,L124), `all` the coloured ones, or a gel table's
/// file name (see gelsFromCsv). Seen in daylight.
[[nodiscard]] std::vector<PlanColor> planGelsFromText(const std::string& text);

}  // namespace swaplight
