#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "core/base/error.h"
#include "core/image/image.h"
#include "core/set/solved_set.h"
#include "render/gl/egl_context.h"
#include "render/gl/gl_handle.h"
#include "render/gl/gl_info.h"

namespace swaplight {

/// Runs each test in an OpenGL context without a window, or skips it and says why there is none. Checks that
/// a test leaves no OpenGL object behind.
class GlTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      m_context = std::make_unique<EglContext>();
    } catch (const ResourceError& error) {
      GTEST_SKIP() << "SKIPPED, NOTHING DRAWN: " << error.what();
    }
    m_liveBefore = liveGlObjects();
    m_errorsBefore = glDebugErrorCount();
  }
  void TearDown() override {
    if (!m_context) return;
    EXPECT_EQ(liveGlObjects(), m_liveBefore);
    EXPECT_EQ(glDebugErrorCount(), m_errorsBefore);
    m_context.reset();
  }

 private:
  std::unique_ptr<EglContext> m_context;
  int m_liveBefore = 0;
  int m_errorsBefore = 0;
};

/// A picture of random values 0..highest, with structure from pixel to pixel.
inline Image randomImage(int width, int height, float highest, unsigned seed) {
  Image image(ImageSpec::rgb(width, height));
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0, highest);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p) image.plane(c)[p] = value(random);
  return image;
}

/// A set of `lights` random contributions whose all-white picture lies in 0..1, with or without ambient.
inline SolvedSet randomSet(int width, int height, int lights, bool ambient = false) {
  SolvedSet set;
  const float highest = 1.0F / static_cast<float>(lights + (ambient ? 1 : 0));
  for (int i = 0; i < lights; ++i) {
    set.capture.lights.push_back({"light" + std::to_string(i)});
    set.contributions.push_back(randomImage(width, height, highest, static_cast<unsigned>(i + 1)));
  }
  if (ambient) set.ambient = randomImage(width, height, highest, 1000);
  updateBeta(set);
  return set;
}

/// The sum that a relit frame is, written down plainly.
inline Image plainRelight(const SolvedSet& set, const std::vector<Rgb>& factors, float ambientFactor = 1) {
  Image frame(ImageSpec::rgb(set.width(), set.height()), 0);
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < frame.pixelCount(); ++p) {
      double sum = set.ambient ? static_cast<double>(ambientFactor) * set.ambient->plane(c)[p] : 0;
      for (size_t i = 0; i < factors.size(); ++i)
        sum += static_cast<double>(factors[i][c]) * set.contributions[i].plane(c)[p];
      frame.plane(c)[p] = static_cast<float>(sum);
    }
  return frame;
}

/// What drawing may change for others in the same context.
struct GlStateSnapshot {
  std::vector<int> values;
  GlStateSnapshot();
  bool operator==(const GlStateSnapshot&) const = default;
};

/// The pixels of an 8-bit texture, row 0 first.
[[nodiscard]] std::vector<uint8_t> texturePixels(unsigned texture, int width, int height);

/// Colours for `lights` lights that bring a random set's picture to 0..2.
inline std::vector<Rgb> variedFactors(int lights) {
  std::vector<Rgb> factors;
  for (int i = 0; i < lights; ++i) {
    const auto t = static_cast<float>(i);
    factors.emplace_back(0.4F + 0.8F * (i % 3), 2.0F - 0.07F * t, 0.1F + 0.1F * t);
  }
  return factors;
}

}  // namespace swaplight
