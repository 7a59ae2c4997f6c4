#include "core/chart/chart_patches.h"

#include <glm/mat3x3.hpp>

namespace swaplight {
namespace {

struct Patch {
  const char* name;
  double L, a, b;
};

constexpr std::array<Patch, kChartPatches> kPatches{{
    {"dark skin", 37.986, 13.555, 14.059},     {"light skin", 65.711, 18.130, 17.810},
    {"blue sky", 49.927, -4.880, -21.925},     {"foliage", 43.139, -13.095, 21.905},
    {"blue flower", 55.112, 8.844, -25.399},   {"bluish green", 70.719, -33.397, -0.199},
    {"orange", 62.661, 36.067, 57.096},        {"purplish blue", 40.020, 10.410, -45.964},
    {"moderate red", 51.124, 48.239, 16.248},  {"purple", 30.325, 22.976, -21.587},
    {"yellow green", 72.532, -23.709, 57.255}, {"orange yellow", 71.941, 19.363, 67.857},
    {"blue", 28.778, 14.179, -50.297},         {"green", 55.261, -38.342, 31.370},
    {"red", 42.101, 53.378, 28.190},           {"yellow", 81.733, 4.039, 79.819},
    {"magenta", 51.935, 49.986, -14.574},      {"cyan", 51.038, -28.631, -28.638},
    {"white", 96.539, -0.425, 1.186},          {"neutral 8", 81.257, -0.638, -0.335},
    {"neutral 6.5", 66.766, -0.734, -0.504},   {"neutral 5", 50.867, -0.153, -0.270},
    {"neutral 3.5", 35.656, -0.421, -1.231},   {"black", 20.461, -0.079, -0.973},
}};

/// CIE 15: the inverse of the lightness function.
double unlit(double f) {
  constexpr double kKnee = 6.0 / 29;
  return f > kKnee ? f * f * f : 3 * kKnee * kKnee * (f - 4.0 / 29);
}

Rgb reflectanceOf(const Patch& patch) {
  const double fy = (patch.L + 16) / 116;
  // D50 of ASTM E308.
  const glm::dvec3 d50(.96422 * unlit(fy + patch.a / 500), unlit(fy), .82521 * unlit(fy - patch.b / 200));
  // Bradford, D50 to D65, and XYZ to Rec.709 (IEC 61966-2-1); matrices of a line a column.
  static const glm::dmat3 kAdapted(.9555766, -.0282895, .0122982,    //
                                   -.0230393, 1.0099416, -.0204830,  //
                                   .0631636, .0210077, 1.3299098);
  static const glm::dmat3 kRec709(3.2404542, -.9692660, .0556434,    //
                                  -1.5371385, 1.8760108, -.2040259,  //
                                  -.4985314, .0415560, 1.0572252);
  return Rgb(kRec709 * (kAdapted * d50));
}

}  // namespace

const char* chartPatchName(size_t patch) {
  return kPatches.at(patch).name;
}

const std::array<Rgb, kChartPatches>& chartReflectances() {
  static const std::array<Rgb, kChartPatches> kReflectances = [] {
    std::array<Rgb, kChartPatches> all{};
    for (size_t p = 0; p < kChartPatches; ++p) all[p] = reflectanceOf(kPatches[p]);
    return all;
  }();
  return kReflectances;
}

ChartPlace chartPatchPlace(size_t patch) {
  const auto column = double(patch % kChartColumns), row = double(patch / kChartColumns);
  return {(.5 + column * (1 + kChartGap)) / kChartWidth, (.5 + row * (1 + kChartGap)) / kChartHeight};
}

}  // namespace swaplight
