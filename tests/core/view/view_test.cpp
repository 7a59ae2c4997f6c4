#include <gtest/gtest.h>

#include <cmath>

#include "core/view/seen_exposure.h"
#include "core/view/window_pixels.h"

namespace swaplight {
namespace {

Image gradient(int width, int height) {
  Image image(ImageSpec::rgb(width, height));
  const ImageSpan pixels = image.span();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      pixels.at(0, x, y) = static_cast<float>(x);
      pixels.at(1, x, y) = static_cast<float>(y);
      pixels.at(2, x, y) = 1;
    }
  return image;
}

Image shown(std::span<const ViewLayer> layers, const ViewWindow& window) {
  Image out(ImageSpec::rgb(window.width, window.height));
  windowLinear(layers, window, out.span());
  return out;
}

TEST(WindowPixels, AtOneToOneAreTheSumOfTheLayersToTheBit) {
  const Image picture = gradient(101, 67);
  const Pyramid pyramid(picture.view());
  const ViewLayer layers[] = {{&pyramid, {1, 2, 0.5F}}, {&pyramid, {0.25F, 0, 1}}};
  const Image out = shown(layers, {13, 7, 1, 40, 30});
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      EXPECT_EQ(out.view().at(0, x, y), 1.25F * static_cast<float>(x + 13));
      EXPECT_EQ(out.view().at(1, x, y), 2.0F * static_cast<float>(y + 7));
      EXPECT_EQ(out.view().at(2, x, y), 1.5F);
    }
}

TEST(WindowPixels, UpToFourTimesIsSmooth) {
  const Image picture = gradient(16, 16);
  const Pyramid pyramid(picture.view());
  const ViewLayer layer{&pyramid};
  for (const double zoom : {1.5, 2.0, 3.0, 4.0}) {
    const Image out = shown({&layer, 1}, {2.5, 1, zoom, 18, 20});
    for (int x = 2; x < 16; ++x)
      EXPECT_NEAR(out.view().at(0, x, 9), 2.5 + (x + 0.5) / zoom - 0.5, 1e-4) << zoom << " " << x;
  }
}

TEST(WindowPixels, BeyondThatShowsSquares) {
  const Image picture = gradient(16, 16);
  const Pyramid pyramid(picture.view());
  const ViewLayer layer{&pyramid};
  const Image out = shown({&layer, 1}, {2.5, 1, 8, 80, 60});
  for (int x = 0; x < 80; ++x)
    EXPECT_EQ(out.view().at(0, x, 5), std::floor(2.5F + (static_cast<float>(x) + 0.5F) / 8));
  for (int y = 0; y < 60; ++y)
    EXPECT_EQ(out.view().at(1, 5, y), std::floor(1 + (static_cast<float>(y) + 0.5F) / 8));
}

TEST(WindowPixels, ShrunkKeepTheirPlace) {
  const Image picture = gradient(1024, 768);
  const Pyramid pyramid(picture.view());
  const ViewLayer layer{&pyramid};
  for (const double zoom : {0.9, 0.71, 0.5, 0.3, 0.11}) {
    const ViewWindow window{100, 50, zoom, 60, 40};
    const Image out = shown({&layer, 1}, window);
    for (int y = 1; y < 39; ++y)
      for (int x = 1; x < 59; ++x) {
        EXPECT_NEAR(out.view().at(0, x, y), window.pictureX(x + 0.5) - 0.5, 1e-2) << zoom;
        EXPECT_NEAR(out.view().at(1, x, y), window.pictureY(y + 0.5) - 0.5, 1e-2) << zoom;
      }
  }
}

TEST(WindowPixels, WithAMemoryShowTheSameWhateverChanges) {
  std::vector<Image> pictures;
  std::vector<Pyramid> pyramids;
  for (int i = 0; i < 5; ++i) {
    Image& image = pictures.emplace_back(gradient(200, 150));
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < image.pixelCount(); ++p)
        image.plane(c)[p] *= 0.1F * static_cast<float>(i + c + 1);
  }
  for (const Image& picture : pictures) pyramids.emplace_back(picture.view());
  std::vector<ViewLayer> layers;
  for (const Pyramid& pyramid : pyramids) layers.push_back({&pyramid, Rgb(1)});
  LayerSum memory;
  const auto check = [&](const ViewWindow& window) {
    const size_t bytes = static_cast<size_t>(window.width) * static_cast<size_t>(window.height) * 4;
    std::vector<uint8_t> with(bytes), without(bytes);
    const RowCodes codes = [](const float* r, const float* g, const float* b, int count, uint8_t* rgba) {
      for (int i = 0; i < count; ++i) {
        rgba[4 * i] = static_cast<uint8_t>(std::min(255.0F, std::round(r[i])));
        rgba[4 * i + 1] = static_cast<uint8_t>(std::min(255.0F, std::round(g[i])));
        rgba[4 * i + 2] = static_cast<uint8_t>(std::min(255.0F, std::round(b[i])));
        rgba[4 * i + 3] = 255;
      }
    };
    windowPixels(layers, window, codes, with.data(), &memory);
    windowPixels(layers, window, codes, without.data());
    for (size_t i = 0; i < bytes; ++i) ASSERT_NEAR(with[i], without[i], 1) << i;  // sums in another order
  };
  const ViewWindow window{0, 0, 1, 200, 150};
  check(window);
  layers[2].factor = {0.5F, 2, 0};
  check(window);
  layers[2].factor = {0, 0, 0};
  check(window);
  layers[4].factor = {0.25F, 0.5F, 1};
  check(window);
  check(window);
  layers[0].factor = layers[1].factor = Rgb(0.3F);
  check(window);
  layers[1].factor = Rgb(0.9F);
  check(window);
  check({20, 10, 0.5, 80, 60});
  layers[1].factor = Rgb(0);
  check({20, 10, 0.5, 80, 60});
  for (ViewLayer& layer : layers) layer.factor = Rgb(0.1F);
  check(window);
  const auto change = [&](size_t i) {
    for (size_t p = 0; p < pictures[i].pixelCount(); ++p) pictures[i].plane(1)[p] += 50;
    pyramids[i].refresh(0, 0, 200, 150);
    memory.pixelsChanged(pyramids[i]);
    check(window);
  };
  for (const size_t i : {3, 3, 0, 3}) change(i);
  layers[1].factor = Rgb(0.9F);
  change(2);
  change(1);
}

TEST(WindowPixels, AGreyLayerCountsForAllChannels) {
  Image grey(ImageSpec{8, 8, {"Y"}, "data"}, 0.5F);
  const Pyramid pyramid(grey.view());
  const ViewLayer layer{&pyramid};
  const Image out = shown({&layer, 1}, {0, 0, 1, 8, 8});
  for (int c = 0; c < 3; ++c) EXPECT_EQ(out.view().at(c, 3, 3), 0.5F);
}

TEST(Pyramid, OddSidesAverageWhatThereIs) {
  Image image(ImageSpec{5, 3, {"Y"}, "data"});
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x) image.span().at(0, x, y) = static_cast<float>(x);
  const Image half = halveImage(image.view());
  EXPECT_EQ(half.width(), 3);
  EXPECT_EQ(half.height(), 2);
  EXPECT_EQ(half.view().at(0, 0, 0), 0.5F);
  EXPECT_EQ(half.view().at(0, 2, 1), 4.0F);
}

TEST(StopsToSee, BringTheBrightestHundredthNearWhite) {
  Image light(ImageSpec::rgb(400, 300));
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 400; ++x) light.span().at(c, x, y) = x < 40 ? .01F : .001F;
  const Pyramid picture(light.view());
  const auto stops = stopsToSee(std::vector<ViewLayer>{{&picture, Rgb(2)}});
  ASSERT_TRUE(stops);
  EXPECT_NEAR(*stops, std::log2(.7 / .02), .02);
  EXPECT_FALSE(stopsToSee(std::vector<ViewLayer>{{&picture, Rgb(0)}}));
  EXPECT_FALSE(stopsToSee({}));
}

}  // namespace
}  // namespace swaplight
