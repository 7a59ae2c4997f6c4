// The shaders' arithmetic, compiled as C++ through GLM, against the frame it stands for.
#include <gtest/gtest.h>

#include <glm/glm.hpp>

#include "tests/render/gl_test.h"

namespace swaplight {
namespace shader {

using namespace glm;  // NOLINT(google-build-using-namespace): GLSL's own names
#include "shaders/relight_math.glsl"

}  // namespace shader

namespace {

TEST(RelightMath, SumsToTheRelitFrame) {
  const SolvedSet set = randomSet(37, 11, 4);
  const std::vector<Rgb> factors = variedFactors(4);
  const Image frame = plainRelight(set, factors);
  for (size_t p = 0; p < frame.pixelCount(); ++p) {
    glm::vec3 sum(0);
    for (size_t i = 0; i < 4; ++i) {
      const Image& t = set.contributions[i];
      sum += shader::litBy({t.plane(0)[p], t.plane(1)[p], t.plane(2)[p]}, factors[i]);
    }
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(sum[c], frame.plane(c)[p], 1e-6) << p;
  }
}

}  // namespace
}  // namespace swaplight
