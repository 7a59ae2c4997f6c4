#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "core/image/half.h"
#include "core/image/io/image_io.h"
#include "core/image/rgb_image.h"
#include "render/view_renderer.h"
#include "tests/render/color_ramp.h"
#include "tests/render/gl_test.h"

namespace swaplight {
namespace {

/// The built-in configuration, or the hand-made one: looks, active displays and views, tables, a log curve.
class EveryViewTest : public GlTest, public testing::WithParamInterface<std::string> {
 protected:
  /// The shader of every view against OpenColorIO's processor, pixel by pixel; in 8-bit codes. Both get the
  /// half floats that textures hold.
  void expectEqual(Image image, const std::string& colorSpace, const std::string& what,
                   const std::optional<std::string>& look = {}, const std::optional<ColorGrade>& grade = {}) {
    for (int c = 0; c < 3; ++c)
      std::transform(image.plane(c), image.plane(c) + image.pixelCount(), image.plane(c), roundedToHalf);
    TiledTexture picture = uploaded(image);
    ViewRenderer renderer(m_config, colorSpace);
    ViewTarget target;
    for (const std::string& display : m_config.displays())
      for (const std::string& view : m_config.views(display)) {
        ViewSettings settings;
        settings.display = {display, view, look, grade};
        renderer.draw(picture, wholeOf(image), settings, target);
        const std::vector<uint8_t> codes = target.readback();
        Image exact = image.clone();
        m_config.applyView(exact.span(), colorSpace, settings.display);
        double worst = 0;
        for (size_t p = 0; p < image.pixelCount(); ++p)
          for (int c = 0; c < 3; ++c)
            worst =
                std::max(worst, std::abs(255.0 * exact.plane(c)[p] - codes[4 * p + static_cast<size_t>(c)]));
        EXPECT_LE(worst, 1.5) << what << ": " << displayWords(settings.display);
        fmt::print("  {:24} {:60} {:.2f} codes\n", what, displayWords(settings.display), worst);
      }
  }
  const ColorConfig m_config{GetParam()};
};

TEST_P(EveryViewTest, TheShaderShowsARampAsTheProcessorDoes) {
  expectEqual(colorRamp(400, 300), "lin_rec709", "ramp");
  expectEqual(colorRamp(200, 150), "acescg", "ramp in ACEScg");
}

TEST_P(EveryViewTest, TheShaderShowsARampUnderAnyLookAsTheProcessorDoes) {
  const std::vector<std::string> looks = m_config.looks();
  ASSERT_GE(looks.size(), 2U);
  for (const std::string& look : {std::string(), looks[0], looks[1], "+" + looks[0] + ", -" + looks[1]})
    expectEqual(colorRamp(200, 150), "lin_rec709", "ramp", look);
}

// One renderer draws with both grades: its program is the same.
TEST_P(EveryViewTest, TheShaderShowsARampUnderAGradeAsTheProcessorDoes) {
  ColorGrade warm = withLiftGammaGain({}, {{.03, 0, -.02}, {1.1, 1, .9}, {1.05, 1, .97}});
  warm.saturation = .6;
  const ColorGrade dark{true, {.8, .8, .9}, {-.05, -.04, 0}, {1.2, 1.2, 1.1}, 1.4};
  expectEqual(colorRamp(200, 150), "lin_rec709", "graded ramp", {}, warm);
  expectEqual(colorRamp(200, 150), "acescg", "graded ramp in ACEScg", {}, dark);
}

TEST_P(EveryViewTest, AnotherGradeNeedsNoOtherShader) {
  const Image image = colorRamp(80, 60);
  TiledTexture picture = uploaded(image);
  ViewRenderer renderer(m_config, "lin_rec709");
  ViewTarget target;
  const auto drawn = [&](double gain) {
    ViewSettings settings;
    settings.display = namedDisplay(m_config, {});
    settings.display.grade = withLiftGammaGain({}, {{}, {1, 1, 1}, {gain, gain, gain}});
    renderer.draw(picture, wholeOf(image), settings, target);
    return target.readback();
  };
  const std::vector<uint8_t> plain = drawn(1), bright = drawn(1.1);
  EXPECT_NE(plain, bright);
  EXPECT_EQ(drawn(1.1), bright);
  EXPECT_EQ(drawn(1), plain);
}

TEST_P(EveryViewTest, TheShaderShowsTheSamplesAsTheProcessorDoes) {
  for (const std::string sample : {"two_swapped", "three_point", "film_set"}) {
    const std::filesystem::path file = std::filesystem::path(SWAPLIGHT_SAMPLES) / sample / "shot_01.exr";
    expectEqual(rgbImage(readImage(file).image, file), "lin_rec709", sample);
  }
}

INSTANTIATE_TEST_SUITE_P(Configurations, EveryViewTest,
                         testing::Values("", SWAPLIGHT_TEST_DATA "/color/config.ocio"),
                         [](const auto& test) { return test.param.empty() ? "BuiltIn" : "HandMade"; });

}  // namespace
}  // namespace swaplight
