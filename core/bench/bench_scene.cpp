#include "core/bench/bench_scene.h"

#include <cmath>
#include <limits>
#include <random>

#include "core/base/json.h"
#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr Rgb kColors[] = {{.9F, .2F, .15F}, {.15F, .8F, .25F}, {.2F, .25F, .9F}, {.85F, .75F, .1F},
                           {.1F, .75F, .8F}, {.75F, .15F, .8F}, {.95F, .5F, .3F}, {.4F, .9F, .6F},
                           {.3F, .2F, .6F},  {.9F, .3F, .6F},   {.2F, .6F, .1F},  {.6F, .6F, .9F},
                           {.1F, .3F, .5F},  {.8F, .4F, .1F},   {.5F, .1F, .3F},  {.7F, .9F, .8F}};

/// A row's own generator: the same picture whatever the number of threads.
std::minstd_rand rowRandom(unsigned seed, int y) {
  std::seed_seq sequence{seed, unsigned(y)};
  return std::minstd_rand(sequence);
}

}  // namespace

CapturePixels photograph(const Capture& capture, const std::vector<Image>& truth, unsigned seed) {
  CapturePixels pixels;
  const int width = truth.front().width();
  const int height = truth.front().height();
  for (size_t k = 0; k < capture.shots.size(); ++k) {
    const Shot& shot = capture.shots[k];
    Image image(ImageSpec::rgb(width, height));
    const float exposure = std::exp2(shot.exposureStops);
    parallelRows(height, 16, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        auto random = rowRandom(seed + unsigned(k) * 7919U, y);
        std::normal_distribution<float> gauss;
        for (int c = 0; c < 3; ++c)
          for (int x = 0; x < width; ++x) {
            const size_t p = size_t(y) * size_t(width) + size_t(x);
            float value = 0;
            for (size_t i = 0; i < truth.size(); ++i)
              value += exposure * (*shot.lightColors[i])[c] * truth[i].plane(c)[p];
            if (capture.noise)
              value += gauss(random) * std::sqrt(std::max(value, 0.0F) / float(capture.noise->fullWell) +
                                                 float(capture.noise->read * capture.noise->read));
            image.plane(c)[p] = value;
          }
      }
    });
    pixels.shots.push_back(std::move(image));
    pixels.clipLevel.push_back(std::numeric_limits<float>::infinity());
    pixels.quantum.push_back(0);
  }
  return pixels;
}

Capture makeBenchCapture(int lights, const std::vector<Rgb>& colors) {
  Capture capture;
  capture.name = "bench";
  capture.noise = SensorNoise{.002, 20000};
  for (int i = 0; i < lights; ++i) {
    capture.lights.push_back({"light" + std::to_string(i + 1), Role::Other, Json::object()});
    Shot shot;
    shot.lightColors.reserve(size_t(lights));
    for (int j = 0; j < lights; ++j) {
      const int color = (i + j) % lights;
      shot.lightColors.emplace_back(colors.empty() ? kColors[color] : colors[size_t(color)]);
    }
    capture.shots.push_back(std::move(shot));
  }
  return capture;
}

std::vector<Image> randomTruth(int width, int height, int lights, float highlights) {
  std::vector<Image> truth;
  truth.reserve(size_t(lights));
  for (int i = 0; i < lights; ++i) truth.emplace_back(ImageSpec::rgb(width, height));
  parallelRows(height, 16, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      auto random = rowRandom(1, y);
      std::uniform_real_distribution<float> unit(0, 1);
      for (int x = 0; x < width; ++x) {
        const size_t p = size_t(y) * size_t(width) + size_t(x);
        const float albedo[3] = {.05F + .85F * unit(random), .05F + .85F * unit(random),
                                 .05F + .85F * unit(random)};
        for (Image& t : truth) {
          const float shading = .5F * unit(random);
          const float white = unit(random) < highlights ? -.2F * std::log(1 - .999F * unit(random)) : 0;
          for (int c = 0; c < 3; ++c) t.plane(c)[p] = shading * albedo[c] + white;
        }
      }
    }
  });
  return truth;
}

BenchScene makeBenchScene(int width, int height, int lights, float highlights) {
  BenchScene scene{makeBenchCapture(lights), {}};
  scene.pixels = photograph(scene.capture, randomTruth(width, height, lights, highlights), 7);
  return scene;
}

BenchScene makeLitScene(int width, int height, int lights) {
  constexpr float kLeast = 0.02F;
  std::vector<Image> truth = randomTruth(width, height, lights, 0);
  for (Image& t : truth)
    for (int c = 0; c < 3; ++c) {
      float* plane = t.plane(c);
      for (size_t p = 0; p < t.pixelCount(); ++p) plane[p] += kLeast;
    }
  Capture quiet = makeBenchCapture(lights);
  quiet.noise.reset();
  return {makeBenchCapture(lights), photograph(quiet, truth, 7)};
}

}  // namespace swaplight
