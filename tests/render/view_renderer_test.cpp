#include "render/view_renderer.h"

#include <limits>

#include "core/view/display/display_table.h"
#include "tests/render/color_ramp.h"
#include "tests/render/gl_test.h"

namespace swaplight {
namespace {

class ViewRendererTest : public GlTest {};

int largestDifference(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
  EXPECT_EQ(a.size(), b.size());
  int largest = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// What the processor shows of the same pixels.
std::vector<uint8_t> shownByTable(const DisplayTable& table, const Image& image) {
  std::vector<uint8_t> codes(image.pixelCount() * 4);
  table.apply(image.plane(0), image.plane(1), image.plane(2), static_cast<int>(image.pixelCount()),
              codes.data());
  return codes;
}

TEST_F(ViewRendererTest, TheViewersSettingsActAsOnTheProcessor) {
  const ColorConfig config("");
  const Image image = colorRamp(200, 100);
  TiledTexture picture = uploaded(image);
  ViewRenderer renderer(config, "lin_rec709");
  ViewTarget target;
  std::vector<ViewSettings> cases(6);
  cases[0].exposureStops = 1.3F;
  cases[1].gamma = 1.8F;
  cases[2].channel = ViewChannel::Green;
  cases[3].channel = ViewChannel::Luminance;
  cases[4].exposureStops = -2;
  cases[4].gamma = 0.7F;
  cases[5].channel = ViewChannel::Blue;
  DisplayTable table(config, "lin_rec709", cases[0]);
  for (const ViewSettings& settings : cases) {
    table.change(settings);
    renderer.draw(picture, wholeOf(image), settings, target);
    EXPECT_LE(largestDifference(target.readback(), shownByTable(table, image)), 2)
        << settings.exposureStops << " " << settings.gamma << " " << static_cast<int>(settings.channel);
  }
}

TEST_F(ViewRendererTest, FalseColoursAreThoseOfTheProcessor) {
  const ColorConfig config("");
  const Image image = colorRamp(300, 50);
  TiledTexture picture = uploaded(image);
  ViewRenderer renderer(config, "lin_rec709");
  ViewTarget target;
  ViewSettings settings;
  settings.falseColor = true;
  renderer.draw(picture, wholeOf(image), settings, target);
  const std::vector<uint8_t> codes = target.readback();
  const std::vector<uint8_t> expected = shownByTable(DisplayTable(config, "lin_rec709", settings), image);
  size_t differing = 0;
  for (size_t i = 0; i < codes.size(); ++i) differing += std::abs(codes[i] - expected[i]) > 1 ? 1 : 0;
  EXPECT_LT(static_cast<double>(differing), 0.005 * static_cast<double>(codes.size()));  // the edges of bands
}

TEST_F(ViewRendererTest, BeyondFourTimesPixelsAreSquaresAndOutsideIsTransparent) {
  const ColorConfig config("");
  Image image(ImageSpec::rgb(3, 2), 0);
  image.span().at(0, 1, 0) = 1;
  image.span().at(1, 2, 1) = 1;
  TiledTexture picture = uploaded(image);
  ViewRenderer renderer(config, "");
  ViewTarget target;
  renderer.draw(picture, {-0.5, 0, 8, 32, 16}, {}, target);
  const std::vector<uint8_t> codes = target.readback();
  const auto at = [&](int x, int y, int c) {
    return codes[4 * (32 * static_cast<size_t>(y) + static_cast<size_t>(x)) + static_cast<size_t>(c)];
  };
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      const int px = (x + 4) / 8 - 1, py = y / 8;
      EXPECT_EQ(at(x, y, 3), px >= 0 && px < 3 ? 255 : 0) << x << " " << y;
      EXPECT_EQ(at(x, y, 0), px == 1 && py == 0 ? 255 : 0) << x << " " << y;
      EXPECT_EQ(at(x, y, 1), px == 2 && py == 1 ? 255 : 0) << x << " " << y;
    }
}

TEST_F(ViewRendererTest, AShrunkPictureIsAveraged) {
  const ColorConfig config("");
  Image image(ImageSpec::rgb(64, 64));
  for (int c = 0; c < 3; ++c)
    for (int p = 0; p < 64 * 64; ++p) image.plane(c)[p] = static_cast<float>((p % 64 + p / 64) % 2);
  TiledTexture picture = uploaded(image);
  ViewRenderer renderer(config, "");
  ViewTarget target;
  renderer.draw(picture, {0, 0, 0.5, 32, 32}, {}, target);
  for (const uint8_t code : target.readback())
    EXPECT_TRUE(code == 127 || code == 128 || code == 255) << int{code};
}

TEST_F(ViewRendererTest, TiledEqualsUntiled) {
  const ColorConfig config("");
  const Image image = colorRamp(1024, 600);
  TiledTexture whole = uploaded(image), tiled = uploaded(image, 256);
  EXPECT_GT(tiled.tiles.size(), 4U);
  ViewRenderer renderer(config, "lin_rec709");
  ViewTarget target;
  for (const ViewWindow& window : {ViewWindow{0, 0, 1, 1024, 600}, ViewWindow{230.5, 240, 3, 300, 200},
                                   ViewWindow{0, 0, 0.5, 512, 300}, ViewWindow{10, 20, 0.37, 350, 200}}) {
    renderer.draw(whole, window, {}, target);
    const std::vector<uint8_t> expected = target.readback();
    renderer.draw(tiled, window, {}, target);
    EXPECT_LE(largestDifference(target.readback(), expected), 1) << window.zoom;
  }
}

TEST_F(ViewRendererTest, ZebraStripesWhatIsTooBrightAndTooDark) {
  const ColorConfig config("");
  Image image(ImageSpec::rgb(32, 16), 0.5F);
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 16; ++y) {
      image.span().at(c, 3, y) = 0.99F;
      image.span().at(c, 9, y) = 0.01F;
    }
  TiledTexture picture = uploaded(image);
  ViewRenderer renderer(config, "");
  ViewTarget target;
  ViewSettings settings;
  settings.zebra = {true, 0.05F, 0.95F};
  renderer.draw(picture, wholeOf(image), settings, target);
  const std::vector<uint8_t> codes = target.readback();
  int bright = 0, dark = 0, others = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      const uint8_t* p = &codes[4 * (32 * static_cast<size_t>(y) + static_cast<size_t>(x))];
      const bool striped = p[0] != p[1] || p[1] != p[2];
      (x == 3 ? bright : x == 9 ? dark : others) += striped ? 1 : 0;
    }
  EXPECT_EQ(bright, 8);
  EXPECT_EQ(dark, 8);
  EXPECT_EQ(others, 0);
}

TEST_F(ViewRendererTest, ValuesThatAreNotFiniteAreShownAsOnTheProcessor) {
  const ColorConfig config("");
  Image image(ImageSpec::rgb(4, 1), 0.5F);
  const float infinity = std::numeric_limits<float>::infinity();
  for (int c = 0; c < 3; ++c) {
    image.plane(c)[0] = std::numeric_limits<float>::quiet_NaN();
    image.plane(c)[1] = infinity;
    image.plane(c)[2] = -infinity;
  }
  TiledTexture picture = uploaded(image);
  ViewRenderer renderer(config, "lin_rec709");
  ViewTarget target;
  for (const std::string& display : config.displays())
    for (const std::string& view : config.views(display)) {
      ViewSettings settings;
      settings.display = {display, view};
      renderer.draw(picture, wholeOf(image), settings, target);
      EXPECT_LE(largestDifference(target.readback(),
                                  shownByTable(DisplayTable(config, "lin_rec709", settings), image)),
                3)
          << display << ", " << view;
    }
}

TEST_F(ViewRendererTest, AnUnknownViewIsSaid) {
  const ColorConfig config("");
  TiledTexture picture = uploaded(colorRamp(8, 8));
  ViewRenderer renderer(config, "lin_rec709");
  ViewTarget target;
  ViewSettings settings;
  settings.display.view = "no such view";
  EXPECT_THROW(renderer.draw(picture, {0, 0, 1, 8, 8}, settings, target), InputError);
}

TEST_F(ViewRendererTest, LeavesTheStateOfTheContextAsItWas) {
  const ColorConfig config("");
  TiledTexture picture = uploaded(colorRamp(64, 64));
  ViewRenderer renderer(config, "lin_rec709");
  ViewTarget target;
  const GlStateSnapshot before;
  for (const std::string& view : config.views(config.defaultDisplay())) {
    ViewSettings settings;
    settings.display.view = view;
    renderer.draw(picture, {0, 0, 0.5, 32, 32}, settings, target);
    (void)target.readback();
  }
  EXPECT_EQ(before, GlStateSnapshot());
}

}  // namespace
}  // namespace swaplight
