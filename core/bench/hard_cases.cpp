#include "core/bench/hard_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/base/quantile.h"
#include "core/bench/bench_picture.h"
#include "core/bench/bench_scene.h"
#include "core/bench/bench_truth.h"
#include "core/color/srgb.h"
#include "core/solve/model/lighting_matrix.h"

namespace swaplight {
namespace {

constexpr float kAmbientLevel = .06F;
constexpr size_t kBrokenEvery = 331;  // pixels

/// What a case is about; the rest is usual.
struct Recipe {
  const char* name;
  const char* group;
  bool matte = false;
  bool mixed = false;
  BenchPicture picture{};
  std::vector<Rgb> colors{};  ///< handed on by one light a shot; none: the usual
  SensorNoise noise{.002, 20000};
  bool noiseTold = true;
  bool random = false;  ///< every pixel a surface of its own
  int bits = 0;         ///< of integers in the files; 0: floating point
  bool encoded = false;
  float clipped = 0;     ///< fraction of pixels with a value beyond full scale
  float colorError = 0;  ///< of the colours that the solver is told, relative
  bool ambient = false;
  bool ambientPicture = false;
  bool ambientSolved = false;  ///< in one shot more, the lights dimmed
  float shift = 0;             ///< pixels that the camera has moved before the second shot
  bool align = false;
  bool moved = false;   ///< an object has, before the second shot
  bool broken = false;  ///< some values are not finite, or negative
  float gain = 1;
};

std::vector<Rgb> apart(float distance) {
  const Rgb half = .5F * distance * Rgb(1, -1, 1);
  return {Rgb(.5F, .5F, .4F) + half, Rgb(.5F, .5F, .4F) - half};
}

std::vector<Rgb> paperGels(std::initializer_list<int> which) {
  constexpr std::array<std::array<int, 3>, 4> kCodes{
      {{218, 131, 102}, {42, 165, 95}, {255, 203, 0}, {0, 38, 96}}};
  std::vector<Rgb> colors;
  for (int w : which)
    colors.push_back(
        linearFromSrgb(Rgb(kCodes[size_t(w)][0], kCodes[size_t(w)][1], kCodes[size_t(w)][2]) / 255.0F));
  return colors;
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all{
      {.name = "usual", .group = "matte", .matte = true},
      {.name = "colours .3 apart", .group = "colours", .matte = true, .colors = apart(.3F)},
      {.name = "colours .1 apart", .group = "colours", .matte = true, .colors = apart(.1F)},
      {.name = "colours .03 apart", .group = "colours", .matte = true, .colors = apart(.03F)},
      {.name = "colours .01 apart", .group = "colours", .matte = true, .colors = apart(.01F)},
      {.name = "one channel equal",
       .group = "colours",
       .matte = true,
       .colors = {{.9F, .5F, .1F}, {.1F, .5F, .9F}}},
      {.name = "one channel zero in both",
       .group = "colours",
       .matte = true,
       .colors = {{.9F, .2F, 0}, {.15F, .8F, 0}}},
      {.name = "two of the paper's gels", .group = "colours", .matte = true, .colors = paperGels({1, 3})},
      {.name = "four lights, the paper's gels",
       .group = "lights",
       .matte = true,
       .picture = {.lights = 4},
       .colors = paperGels({0, 1, 2, 3})},
      {.name = "four lights, red green blue white",
       .group = "lights",
       .matte = true,
       .picture = {.lights = 4},
       .colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}},
      {.name = "eight lights", .group = "lights", .matte = true, .picture = {.lights = 8}},
      {.name = "8-bit sRGB", .group = "files", .matte = true, .bits = 8, .encoded = true},
      {.name = "10-bit linear", .group = "files", .matte = true, .bits = 10},
      {.name = "12-bit linear", .group = "files", .matte = true, .bits = 12},
      {.name = "full well 1000", .group = "noise", .matte = true, .noise = {.002, 1000}},
      {.name = "full well 5000", .group = "noise", .matte = true, .noise = {.002, 5000}},
      {.name = "full well 20000", .group = "noise", .matte = true, .noise = {.002, 20000}},
      {.name = "noise not told", .group = "noise", .noiseTold = false},
      {.name = "clipped 1 %", .group = "noise", .matte = true, .clipped = .01F},
      {.name = "clipped 10 %", .group = "noise", .matte = true, .clipped = .1F},
      {.name = "gloss .1", .group = "gloss", .mixed = true, .picture = {.gloss = .1F}},
      {.name = "gloss .3", .group = "gloss", .mixed = true, .picture = {.gloss = .3F}},
      {.name = "gloss 1", .group = "gloss", .mixed = true, .picture = {.gloss = 1}},
      {.name = "gloss 2", .group = "gloss", .mixed = true, .picture = {.gloss = 2}},
      {.name = "gloss 4", .group = "gloss", .mixed = true, .picture = {.gloss = 4}},
      {.name = "bounced light", .group = "gloss", .picture = {.bounced = true}},
      {.name = "colours wrong by 2 %", .group = "wrong", .colorError = .02F},
      {.name = "colours wrong by 5 %", .group = "wrong", .colorError = .05F},
      {.name = "random pixels, colours wrong by 2 %", .group = "wrong", .random = true, .colorError = .02F},
      {.name = "the same, the noise not told either",
       .group = "wrong",
       .noiseTold = false,
       .random = true,
       .colorError = .02F},
      {.name = "random pixels of four lights, colours wrong by 2 %",
       .group = "wrong",
       .picture = {.lights = 4},
       .random = true,
       .colorError = .02F},
      {.name = "ambient light, not modelled", .group = "wrong", .ambient = true},
      {.name = "ambient light, its picture given",
       .group = "wrong",
       .matte = true,
       .ambient = true,
       .ambientPicture = true},
      {.name = "ambient light, solved from a third shot",
       .group = "wrong",
       .ambient = true,
       .ambientSolved = true},
      {.name = "camera moved .5 pixels", .group = "moved", .shift = .5F},
      {.name = "camera moved .5 pixels, aligned", .group = "moved", .shift = .5F, .align = true},
      {.name = "camera moved 2 pixels", .group = "moved", .shift = 2},
      {.name = "camera moved 2 pixels, aligned", .group = "moved", .shift = 2, .align = true},
      {.name = "an object moved", .group = "moved", .moved = true},
      {.name = "NaN, infinite, negative pixels", .group = "broken", .broken = true},
      {.name = "radiance 10000", .group = "broken", .matte = true, .gain = 1e4F},
  };
  return all;
}

/// What no light shows is not asked for.
void darkenUnseenChannels(const LightingMatrix& lighting, std::vector<Image>& truth) {
  for (int c = 0; c < 3; ++c)
    if (std::all_of(lighting.colors.begin(), lighting.colors.end(),
                    [c](const Rgb& color) { return color[c] == 0; }))
      for (Image& t : truth) std::fill_n(t.plane(c), t.pixelCount(), 0.0F);
}

/// The value that this fraction of the pixels have in some channel of some shot.
float brightValue(const Capture& capture, const std::vector<Image>& truth, float fraction) {
  Capture still = capture;
  still.noise.reset();
  const CapturePixels exact = photograph(still, truth, 0);
  std::vector<float> brightest(truth.front().pixelCount(), 0.0F);
  for (const Image& shot : exact.shots)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < brightest.size(); ++p) brightest[p] = std::max(brightest[p], shot.plane(c)[p]);
  return std::max(quantile(std::span(brightest), 1 - double(fraction)), 1e-6F);
}

void multiply(std::vector<Image>& images, float gain) {
  for (Image& image : images)
    for (int c = 0; c < image.channelCount(); ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p) image.plane(c)[p] *= gain;
}

Capture captureOf(const Recipe& recipe) {
  Capture capture = makeBenchCapture(recipe.picture.lights, recipe.colors);
  capture.name = recipe.name;
  capture.noise = recipe.noise;
  return capture;
}

/// Errs in every colour of every shot.
void mistake(Capture& capture, float error, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> gauss;
  for (Shot& shot : capture.shots)
    for (auto& color : shot.lightColors)
      for (int c = 0; c < 3; ++c) (*color)[c] *= std::max(1 + error * gauss(random), 0.0F);
}

void clip(CapturePixels& pixels) {
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < pixels.shots[k].pixelCount(); ++p)
        pixels.shots[k].plane(c)[p] = std::min(pixels.shots[k].plane(c)[p], 1.0F);
    pixels.clipLevel[k] = 1;
  }
}

/// As a file of integers holds the shots; see CapturePixels.
void quantise(CapturePixels& pixels, int bits, bool encoded) {
  const float largest = float((1 << bits) - 1);
  const auto decoded = [&](float code) { return encoded ? linearFromSrgb(code / largest) : code / largest; };
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < pixels.shots[k].pixelCount(); ++p) {
        float& y = pixels.shots[k].plane(c)[p];
        const float x = std::clamp(y, 0.0F, 1.0F);
        y = decoded(std::round(largest * (encoded ? srgbFromLinear(x) : x)));
      }
    pixels.quantum[k] = 1 - decoded(largest - 1);
    pixels.clipLevel[k] = 1 - pixels.quantum[k] / 4;
  }
  if (encoded) pixels.rounding = roundingErrors([](float code) { return linearFromSrgb(code); }, 1 / largest);
}

void damage(CapturePixels& pixels) {
  constexpr std::array<float, 4> kBroken{NAN, INFINITY, -INFINITY, -1};
  size_t n = 0;
  for (size_t p = 0; p < pixels.shots.front().pixelCount(); p += kBrokenEvery, ++n)
    pixels.shots[n % pixels.shots.size()].plane(int(n / 2 % 3))[p] = kBroken[n % kBroken.size()];
  // One pixel that no shot knows.
  for (Image& shot : pixels.shots) shot.plane(1)[pixels.shots.front().pixelCount() / 2] = NAN;
}

HardCase caseOf(Recipe recipe, unsigned seed, int width) {
  recipe.picture.width = width;
  recipe.picture.height = width * 2 / 3;
  HardCase made;
  made.name = recipe.name;
  made.group = recipe.group;
  made.matte = recipe.matte;
  made.mixed = recipe.mixed;
  made.capture = captureOf(recipe);
  if (recipe.align) made.options.align = Remedy::On;
  made.options.solveAmbient = recipe.ambientSolved;
  if (recipe.ambientSolved) {
    made.capture.shots.push_back(made.capture.shots.front());
    for (auto& color : made.capture.shots.back().lightColors) *color *= .2F;
  }
  made.truth = recipe.random
                   ? randomTruth(recipe.picture.width, recipe.picture.height, recipe.picture.lights, 0)
                   : renderBenchPicture(recipe.picture);
  darkenUnseenChannels(lightingFromCapture(made.capture), made.truth);
  const float gain = recipe.clipped > 0 ? 1 / brightValue(made.capture, made.truth, recipe.clipped)
                                        : recipe.gain * .9F / brightValue(made.capture, made.truth, .005F);
  multiply(made.truth, gain);

  Capture lit = made.capture;
  if (recipe.colorError > 0) mistake(made.capture, recipe.colorError, seed + 1000);
  std::vector<Image> photographed;
  for (const Image& t : made.truth) photographed.push_back(t.clone());
  if (recipe.ambient) {
    // One more light, white in every shot.
    photographed.push_back(renderBenchAmbient(recipe.picture, kAmbientLevel));
    for (Shot& shot : lit.shots) shot.lightColors.emplace_back(Rgb(1));
  }
  made.pixels = photograph(lit, photographed, seed);
  if (recipe.ambientPicture) {
    Capture dark = lit;
    dark.shots.resize(1);
    for (auto& color : dark.shots.front().lightColors) color = Rgb(0);
    dark.shots.front().lightColors.back() = Rgb(1);
    made.pixels.ambient = std::move(photograph(dark, photographed, seed + 77).shots.front());
  }
  if (recipe.shift > 0 || recipe.moved) {
    BenchPicture later = recipe.picture;
    later.shiftX = .8F * recipe.shift;
    later.shiftY = .6F * recipe.shift;
    later.moved = recipe.moved;
    std::vector<Image> truth = renderBenchPicture(later);
    multiply(truth, gain);
    made.pixels.shots[1] = std::move(photograph(lit, truth, seed).shots[1]);
  }
  if (recipe.clipped > 0) clip(made.pixels);
  if (recipe.bits > 0) quantise(made.pixels, recipe.bits, recipe.encoded);
  if (recipe.broken) damage(made.pixels);
  made.noise = noiseModel(recipe.noise, made.pixels, 0);
  if (!recipe.noiseTold) made.capture.noise.reset();
  return made;
}

}  // namespace

std::vector<std::string> hardCaseNames() {
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes()) names.emplace_back(recipe.name);
  return names;
}

HardCase makeHardCase(int index, unsigned seed, int width) {
  return caseOf(recipes()[size_t(index)], seed, width);
}

HardCase makeStillLife(int lights, float gloss, unsigned seed, int width) {
  return caseOf({.name = "still life",
                 .group = "still life",
                 .matte = gloss == 0,
                 .mixed = gloss > 0,
                 .picture = {.lights = lights, .gloss = gloss}},
                seed, width);
}

HardCase hardCaseOfCapture(Capture capture, unsigned seed) {
  if (!capture.noise) capture.noise = SensorNoise{.002, 20000};
  HardCase made;
  made.name = capture.name;
  made.group = "sample";
  made.truth = std::move(benchTruth(capture).contributions);
  made.pixels = photograph(capture, made.truth, seed);
  made.noise = noiseModel(*capture.noise, made.pixels, 0);
  made.capture = std::move(capture);
  return made;
}

}  // namespace swaplight
