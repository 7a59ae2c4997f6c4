#include "render/viewport_renderer.h"

#include <cmath>

#include "render/cpu_viewport_renderer.h"
#include "render/gpu_viewport_renderer.h"
#include "tests/render/gl_test.h"

namespace swaplight {
namespace {

/// A smooth picture, so that both engines' ways of shrinking agree.
Image smoothPicture(int width, int height, float phase) {
  Image image(ImageSpec::rgb(width, height));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        image.span().at(c, x, y) = 0.3F + 0.25F * std::sin(0.03F * static_cast<float>(x) + phase) *
                                              std::cos(0.02F * static_cast<float>(y * (c + 1)) - phase);
  return image;
}

std::vector<uint8_t> pixelsOf(unsigned texture, const ViewWindow& window) {
  return texturePixels(texture, window.width, window.height);
}

class ViewportRendererTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    for (int i = 0; i < 3; ++i) m_images.push_back(smoothPicture(640, 400, static_cast<float>(i)));
    m_pyramids.reserve(m_images.size());
    for (const Image& image : m_images) m_pyramids.emplace_back(image.view());
  }

  [[nodiscard]] ViewportRequest request(const ViewWindow& window) const {
    ViewportRequest request;
    request.a = {{{&m_pyramids[0], {0.5F, 0.4F, 0.3F}}, {&m_pyramids[1], {0.2F, 0.3F, 0.6F}}}, "lin_rec709"};
    request.b = {{{&m_pyramids[2], Rgb(0.7F)}, {&m_pyramids[1], {0.1F, 0.1F, 0.1F}}}, "lin_rec709"};
    request.window = window;
    return request;
  }

  /// Both engines' pictures of a request, which must agree to three codes but for a share of the values.
  void expectBothAgree(const ViewportRequest& request, const std::string& what, double share = 0.002) {
    CpuViewportRenderer processor(m_config);
    GpuViewportRenderer graphics(m_config);
    const std::vector<uint8_t> a = pixelsOf(processor.texture(request, 0), request.window);
    const std::vector<uint8_t> b = pixelsOf(graphics.texture(request, 0), request.window);
    size_t off = 0;
    for (size_t i = 0; i < a.size(); ++i) off += std::abs(a[i] - b[i]) > 3 ? 1 : 0;
    EXPECT_LE(static_cast<double>(off), share * static_cast<double>(a.size())) << what;
  }

  std::shared_ptr<const ColorConfig> m_config = std::make_shared<const ColorConfig>("");
  std::vector<Image> m_images;
  std::vector<Pyramid> m_pyramids;
};

const ViewWindow kWhole{0, 0, 1, 640, 400};

TEST_F(ViewportRendererTest, BothEnginesShowTheSameAtEveryZoom) {
  for (const ViewWindow& window :
       {kWhole, ViewWindow{0, 0, 0.5, 320, 200}, ViewWindow{13.5, 7, 0.8, 300, 200},
        ViewWindow{100, 60, 0.3, 120, 80}, ViewWindow{40.25, 30, 2, 320, 200},
        ViewWindow{40.25, 30, 2.7, 320, 200}, ViewWindow{40, 30, 7.3, 320, 200}})
    expectBothAgree(request(window), "zoom " + std::to_string(window.zoom));
}

TEST_F(ViewportRendererTest, BothEnginesInterpolateBetweenTheSamePixels) {
  const Image coarse = randomImage(80, 60, 1, 5);
  const Pyramid pyramid(coarse.view());
  for (const ViewWindow& window : {ViewWindow{3, 2, 0.8, 40, 30}, ViewWindow{0, 0, 0.5, 40, 30},
                                   ViewWindow{3.25, 2.5, 2.45, 100, 80}, ViewWindow{3.25, 2.5, 3, 100, 80}}) {
    ViewportRequest noisy = request(window);
    noisy.a = {{{&pyramid, Rgb(1)}}, ""};
    expectBothAgree(noisy, "zoom " + std::to_string(window.zoom));
  }
}

TEST_F(ViewportRendererTest, BothEnginesCompareAlike) {
  for (const double angle : {0.0, 30.0, 90.0, 135.0, 180.0, 270.0}) {
    ViewportRequest wipe = request({20, 10, 0.9, 400, 300});
    wipe.comparison = {Comparison::Mode::Wipe, 200, 150, angle};
    expectBothAgree(wipe, "wipe at " + std::to_string(angle));
  }
  ViewportRequest difference = request(kWhole);
  difference.comparison.mode = Comparison::Mode::Difference;
  difference.settings.exposureStops = 2;
  expectBothAgree(difference, "difference");
}

TEST_F(ViewportRendererTest, BothEnginesDrawZebraAndFalseColourAlike) {
  ViewportRequest zebra = request(kWhole);
  zebra.settings.zebra = {true, 0.4F, 0.6F};
  expectBothAgree(zebra, "zebra", 0.01);  // a code more or less decides at the edge of the stripes
  ViewportRequest falseColor = request(kWhole);
  falseColor.settings.falseColor = true;
  expectBothAgree(falseColor, "false colour");
}

TEST_F(ViewportRendererTest, AWipeShowsAAndBOnTheirSides) {
  CpuViewportRenderer screen(m_config);
  ViewportRequest wipe = request(kWhole);
  const std::vector<uint8_t> a = pixelsOf(screen.texture(wipe, 0), kWhole);
  std::swap(wipe.a, wipe.b);
  const std::vector<uint8_t> b = pixelsOf(screen.texture(wipe, 0), kWhole);
  std::swap(wipe.a, wipe.b);
  wipe.comparison = {Comparison::Mode::Wipe, 200, 150, 0};
  const std::vector<uint8_t> both = pixelsOf(screen.texture(wipe, 0), kWhole);
  for (size_t i = 0; i < both.size(); ++i) ASSERT_NEAR(both[i], i / 4 % 640 < 200 ? a[i] : b[i], 1) << i;
}

TEST_F(ViewportRendererTest, APictureAgainstItselfDiffersByNothing) {
  ViewportRequest same = request(kWhole);
  same.b = same.a;
  same.comparison.mode = Comparison::Mode::Difference;
  for (const Engine engine : {Engine::Processor, Engine::Graphics}) {
    const auto screen = makeViewportRenderer(engine, m_config);
    const std::vector<uint8_t> pixels = pixelsOf(screen->texture(same), kWhole);
    for (size_t i = 0; i < pixels.size(); ++i) ASSERT_EQ(pixels[i], i % 4 == 3 ? 255 : 0);
  }
}

TEST_F(ViewportRendererTest, ADraftStandsForThePictureAtEveryZoom) {
  const Image draftImage = halveImage(halveImage(m_images[0].view()).view());
  const Pyramid draftPyramid(draftImage.view());
  for (const Engine engine : {Engine::Processor, Engine::Graphics}) {
    const auto screen = makeViewportRenderer(engine, m_config);
    for (const ViewWindow& window :
         {kWhole, ViewWindow{0, 0, 0.7, 448, 280}, ViewWindow{41.5, 33, 0.9, 300, 200},
          ViewWindow{100.25, 80, 9, 320, 200}}) {
      ViewportRequest exact = request(window);
      exact.a = {{{&m_pyramids[0], Rgb(1)}}, "lin_rec709"};
      ViewportRequest draft = exact;
      draft.a = {{{&draftPyramid, Rgb(1)}}, "lin_rec709", 0.25};
      const std::vector<uint8_t> wanted = pixelsOf(screen->texture(exact), window);
      const std::vector<uint8_t> seen = pixelsOf(screen->texture(draft), window);
      // Not at the picture's edge, where a draft's pixels end earlier.
      const auto edge = [](double at, int side) { return at < 8 || at > side - 8; };
      int worst = 0;
      for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x)
          for (int c = 0; c < 3 && !edge(window.pictureX(x), 640) && !edge(window.pictureY(y), 400); ++c) {
            const size_t i =
                4 * (static_cast<size_t>(y) * static_cast<size_t>(window.width) + static_cast<size_t>(x)) +
                static_cast<size_t>(c);
            worst = std::max(worst, std::abs(seen[i] - wanted[i]));
          }
      EXPECT_LE(worst, 3) << screen->words() << ", zoom " << window.zoom;
    }
  }
}

TEST_F(ViewportRendererTest, APictureMayChangeItsSize) {
  for (const Engine engine : {Engine::Processor, Engine::Graphics}) {
    const auto screen = makeViewportRenderer(engine, m_config);
    const Image small = smoothPicture(160, 100, 2);
    std::optional<Pyramid> pyramid(m_images[0].view());
    ViewportRequest wanted = request(kWhole);
    wanted.a = {{{&*pyramid, Rgb(1)}}, "lin_rec709"};
    (void)screen->texture(wanted);
    pyramid.emplace(small.view());
    wanted.a = {{{&*pyramid, Rgb(1)}}, "lin_rec709", 0.25};
    const std::vector<uint8_t> seen = pixelsOf(screen->texture(wanted), kWhole);
    const auto fresh = makeViewportRenderer(engine, m_config);
    EXPECT_EQ(seen, pixelsOf(fresh->texture(wanted), kWhole));
  }
}

TEST_F(ViewportRendererTest, APictureThatLiesWhereAnotherLayIsSeenAndTakesItsMemory) {
  for (const Engine engine : {Engine::Processor, Engine::Graphics}) {
    const auto screen = makeViewportRenderer(engine, m_config);
    std::optional<Pyramid> pyramid(m_images[0].view());
    ViewportRequest wanted = request(kWhole);
    const auto layers = [&] {
      return std::vector<ViewLayer>{{&*pyramid, Rgb(1)}, {&m_pyramids[2], Rgb(0.2F)}};
    };
    wanted.a = {layers(), "lin_rec709"};
    (void)screen->texture(wanted);
    const int objects = liveGlObjects();
    pyramid.emplace(m_images[1].view());
    wanted.a = {layers(), "lin_rec709"};
    const std::vector<uint8_t> seen = pixelsOf(screen->texture(wanted), kWhole);
    EXPECT_EQ(liveGlObjects(), objects);
    const auto fresh = makeViewportRenderer(engine, m_config);
    EXPECT_EQ(seen, pixelsOf(fresh->texture(wanted), kWhole));
  }
}

/// As the lights do that stay when another one comes or goes.
TEST_F(ViewportRendererTest, APictureMayBeMovedAndThenChange) {
  for (const Engine engine : {Engine::Processor, Engine::Graphics}) {
    const auto screen = makeViewportRenderer(engine, m_config);
    Image image = smoothPicture(640, 400, 1);
    auto old = std::make_unique<Pyramid>(image.view());
    ViewportRequest wanted = request({0, 0, 0.5, 320, 200});
    wanted.a = {{{&*old, Rgb(1)}}, ""};
    (void)screen->texture(wanted);
    Pyramid moved = std::move(*old);
    old.reset();
    for (int y = 101; y < 140; ++y) std::fill_n(image.span().row(0, y) + 201, 60, 1.0F);
    moved.refresh(201, 101, 60, 39);
    screen->changed(moved, {201, 101, 60, 39});
    wanted.a = {{{&moved, Rgb(1)}}, ""};
    const std::vector<uint8_t> seen = pixelsOf(screen->texture(wanted), wanted.window);
    const auto fresh = makeViewportRenderer(engine, m_config);
    EXPECT_EQ(seen, pixelsOf(fresh->texture(wanted), wanted.window));
  }
}

TEST_F(ViewportRendererTest, ChangedPixelsAreSeenAfterTheyWereAnnounced) {
  for (const Engine engine : {Engine::Processor, Engine::Graphics}) {
    const auto screen = makeViewportRenderer(engine, m_config);
    ViewportRequest half = request({0, 0, 0.5, 320, 200});
    half.a = {{{&m_pyramids[0], Rgb(1)}}, ""};
    (void)screen->texture(half);
    for (int c = 0; c < 3; ++c)
      for (int y = 101; y < 140; ++y) std::fill_n(m_images[0].span().row(c, y) + 201, 60, 1.0F);
    m_pyramids[0].refresh(201, 101, 60, 39);
    screen->changed(m_pyramids[0], {201, 101, 60, 39});
    const std::vector<uint8_t> pixels = pixelsOf(screen->texture(half), half.window);
    EXPECT_EQ(pixels[4 * (60 * 320 + 115)], 255);
    EXPECT_LT(pixels[4 * (60 * 320 + 90)], 200);
    for (int c = 0; c < 3; ++c)
      for (int y = 101; y < 140; ++y) std::fill_n(m_images[0].span().row(c, y) + 201, 60, 0.2F);
    m_pyramids[0].refresh(201, 101, 60, 39);
  }
}

TEST_F(ViewportRendererTest, APartThatChangedIsDrawnAsItIsWithAllTheRest) {
  for (const ViewWindow& window :
       {kWhole, ViewWindow{0, 0, 0.37, 236, 148}, ViewWindow{13.5, 7, 0.8, 300, 200},
        ViewWindow{150.25, 80, 2.7, 320, 200}, ViewWindow{190, 90, 5, 320, 200}})
    for (const auto mode : {Comparison::Mode::Off, Comparison::Mode::Wipe, Comparison::Mode::Difference}) {
      ViewportRequest wanted = request(window);
      wanted.comparison = {mode, 220, 110, 30};
      CpuViewportRenderer screen(m_config);
      (void)screen.texture(wanted, 0);
      for (int c = 0; c < 3; ++c)
        for (int y = 101; y < 140; ++y)
          for (int x = 201; x < 261; ++x) m_images[0].span().at(c, x, y) *= 1.2F;
      m_pyramids[0].refresh(201, 101, 60, 39);
      screen.changed(m_pyramids[0], {201, 101, 60, 39});
      const std::vector<uint8_t> part = pixelsOf(screen.texture(wanted, 0), window);
      CpuViewportRenderer other(m_config);
      const std::vector<uint8_t> whole = pixelsOf(other.texture(wanted, 0), window);
      int worst = 0;
      for (size_t i = 0; i < part.size(); ++i) worst = std::max(worst, std::abs(part[i] - whole[i]));
      EXPECT_LE(worst, 1) << "zoom " << window.zoom << ", comparison " << static_cast<int>(mode);
    }
}

TEST_F(ViewportRendererTest, TheProcessorIsChosenOnASoftwareRasteriser) {
  const auto screen = makeViewportRenderer(Engine::Auto, m_config);
  EXPECT_EQ(screen->words().starts_with("processor"), glInfo().software);
  EXPECT_TRUE(makeViewportRenderer(Engine::Graphics, m_config)->words().starts_with("graphics card: "));
}

TEST(Comparison, AWipesLineStaysAtItsPointOfThePicture) {
  const Comparison wipe{Comparison::Mode::Wipe, 50, 20, 0};
  EXPECT_EQ(columnsOfB(sideOfB(wipe, {0, 0, 1, 100, 40}), 5, 100), (std::pair{50, 100}));
  EXPECT_EQ(columnsOfB(sideOfB(wipe, {40, 0, 2, 100, 40}), 5, 100), (std::pair{20, 100}));
  const Comparison turned{Comparison::Mode::Wipe, 50, 20, 180};
  EXPECT_EQ(columnsOfB(sideOfB(turned, {0, 0, 1, 100, 40}), 5, 100), (std::pair{0, 50}));
  const Comparison level{Comparison::Mode::Wipe, 50, 20, 90};
  EXPECT_EQ(columnsOfB(sideOfB(level, {0, 0, 1, 100, 40}), 19, 100), (std::pair{0, 0}));
  EXPECT_EQ(columnsOfB(sideOfB(level, {0, 0, 1, 100, 40}), 20, 100), (std::pair{0, 100}));
}

}  // namespace
}  // namespace swaplight
