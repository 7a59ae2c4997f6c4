#include "core/ocio/icc_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>

namespace swaplight {
namespace {

using Curve = std::unique_ptr<cmsToneCurve, void (*)(cmsToneCurve*)>;
using Profile = std::unique_ptr<void, int (*)(void*)>;

constexpr cmsCIExyY kD65 = {0.3127, 0.3290, 1};
constexpr cmsCIExyYTRIPLE kRec709 = {{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
constexpr cmsCIExyYTRIPLE kP3 = {{0.680, 0.320, 1}, {0.265, 0.690, 1}, {0.150, 0.060, 1}};

bool has(const std::string& text, const char* word) {
  return text.find(word) != std::string::npos;
}

Curve srgbCurve() {
  const std::array<double, 5> parameters = {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
  return {cmsBuildParametricToneCurve(nullptr, 4, parameters.data()), cmsFreeToneCurve};
}

Curve gammaCurve(double gamma) {
  return {cmsBuildGamma(nullptr, gamma), cmsFreeToneCurve};
}

void describe(cmsHPROFILE profile, const char* name) {
  const std::unique_ptr<cmsMLU, void (*)(cmsMLU*)> words(cmsMLUalloc(nullptr, 1), cmsMLUfree);
  cmsMLUsetASCII(words.get(), "en", "US", name);
  cmsWriteTag(profile, cmsSigProfileDescriptionTag, words.get());
}

std::vector<unsigned char> profileBytes(const cmsCIExyYTRIPLE& primaries, const Curve& curve,
                                        const char* name) {
  const std::array<cmsToneCurve*, 3> curves = {curve.get(), curve.get(), curve.get()};
  const Profile profile(cmsCreateRGBProfile(&kD65, &primaries, curves.data()), cmsCloseProfile);
  if (!profile) return {};
  describe(profile.get(), name);
  cmsUInt32Number size = 0;
  if (cmsSaveProfileToMem(profile.get(), nullptr, &size) == 0) return {};
  std::vector<unsigned char> bytes(size);
  if (cmsSaveProfileToMem(profile.get(), bytes.data(), &size) == 0) return {};
  // The time of its making (ICC.1, 7.2.8) would make each file another one: a fixed day stands for it.
  constexpr std::array<unsigned char, 12> kDay = {0x07, 0xEA, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0};
  std::copy(kDay.begin(), kDay.end(), bytes.begin() + 24);
  return bytes;
}

}  // namespace

std::vector<unsigned char> iccProfileOf(const std::string& display, const std::string& view) {
  if (has(view, "Raw") || (has(view, "Log") && !has(view, "Logarithmic"))) return {};
  if (has(display, "PQ") || has(display, "HLG") || has(display, "2100")) return {};
  if (has(display, "sRGB")) return profileBytes(kRec709, srgbCurve(), "sRGB");
  if (has(display, "P3")) return profileBytes(kP3, gammaCurve(2.6), "P3-D65, gamma 2.6");
  if (has(display, "709") || has(display, "1886"))
    return profileBytes(kRec709, gammaCurve(2.4), "Rec.709, gamma 2.4");
  return {};
}

}  // namespace swaplight
