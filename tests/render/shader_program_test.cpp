#include "render/gl/shader_program.h"

#include <gmock/gmock.h>

#include "render/gl/shader_source.h"
#include "tests/render/gl_test.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

class ShaderProgramTest : public GlTest {};

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST_F(ShaderProgramTest, AnErrorShowsTheNumberedSource) {
  const std::string message =
      messageOf([] { const ShaderProgram program("fullscreen.vert", "view.frag", "this is no GLSL"); });
  EXPECT_THAT(message, HasSubstr("the shader view.frag does not compile"));
  EXPECT_THAT(message, HasSubstr("  1  #version 410 core\n"));
  EXPECT_THAT(message, testing::ContainsRegex("[0-9]+  this is no GLSL\n"));
}

TEST_F(ShaderProgramTest, AnUnknownUniformIsNamedWithTheKnownOnes) {
  const ShaderProgram program("fullscreen.vert", "relight.frag", "const int kPictures = 2;");
  const std::string message = messageOf([&] { program.set({{"brightness", 1.0F}}); });
  EXPECT_THAT(message, HasSubstr("no uniform \"brightness\""));
  EXPECT_THAT(message, HasSubstr("it has factors, pictures"));
}

TEST_F(ShaderProgramTest, AMissingFileIsNamed) {
  EXPECT_THAT(messageOf([] { const ShaderProgram program("fullscreen.vert", "nowhere.frag"); }),
              HasSubstr("nowhere.frag cannot be read"));
}

TEST(ShaderSource, IncludesAreReplacedByTheirFiles) {
  EXPECT_THAT(shaderSource("relight.frag"), HasSubstr("vec3 litBy(vec3 contribution, vec3 factor)"));
  EXPECT_THAT(shaderSource("relight.frag"), testing::Not(HasSubstr("#include")));
}

TEST(GlInfo, KnowsSoftwareRasterisersByName) {
  EXPECT_TRUE(isSoftwareRenderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
  EXPECT_TRUE(isSoftwareRenderer("softpipe"));
  EXPECT_TRUE(isSoftwareRenderer("Google SwiftShader"));
  EXPECT_TRUE(isSoftwareRenderer("SWR (LLVM 11.0, 256 bits)"));
  EXPECT_FALSE(isSoftwareRenderer("Mesa Intel(R) Xe Graphics (TGL GT2)"));
  EXPECT_FALSE(isSoftwareRenderer("NVIDIA H200/PCIe/SSE2"));
  EXPECT_FALSE(isSoftwareRenderer("AMD Radeon RX 6600 (navi23, LLVM 15.0.6, DRM 3.49)"));
}

}  // namespace
}  // namespace swaplight
