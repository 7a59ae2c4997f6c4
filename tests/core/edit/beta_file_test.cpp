#include "core/edit/stack/beta_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/apply/edited_set.h"
#include "core/edit/stack/beta_files.h"
#include "core/image/io/image_io.h"
#include "tests/support/small_set.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

Image mapOf(const std::filesystem::path& file, const std::string& channel, const std::string& light,
            int width, int height) {
  return std::move(readBetaMaps(file, channel, {light}, width, height).maps.front());
}

TEST(BetaFile, ExrKeepsEveryLightToTheBit) {
  const test::TemporaryFolder folder;
  const SolvedSet set = test::smallSet(3, 40, 30);
  const auto files = writeBetaMaps(set, folder / "beta.exr");
  ASSERT_EQ(files.size(), 1u);
  for (int i = 0; i < 3; ++i) {
    const std::string light = set.capture.lights[static_cast<size_t>(i)].name;
    const Image beta = mapOf(files[0], "", light, 40, 30);
    EXPECT_TRUE(std::equal(beta.plane(0), beta.plane(0) + beta.pixelCount(), set.beta.plane(i)));
    EXPECT_TRUE(std::equal(beta.plane(0), beta.plane(0) + beta.pixelCount(),
                           mapOf(files[0], "beta." + light, "other", 40, 30).plane(0)));
  }
}

TEST(BetaFile, PngHasAFileALightAndSixteenBits) {
  const test::TemporaryFolder folder;
  const SolvedSet set = test::smallSet(2, 40, 30);
  const auto files = writeBetaMaps(set, folder / "beta.png");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[1].filename(), "beta.light2.png");
  const Image beta = mapOf(files[1], "", "light2", 40, 30);
  for (size_t p = 0; p < beta.pixelCount(); ++p) ASSERT_NEAR(beta.plane(0)[p], set.beta.plane(1)[p], 1e-5);
}

TEST(BetaFile, ItsFilesAreKnownBeforeTheyAreWritten) {
  const test::TemporaryFolder folder;
  const SolvedSet set = test::smallSet(2, 4, 3);
  const std::vector<std::string> lights = {"light1", "light2"};
  for (const char* name : {"beta.exr", "beta.png", "beta.v2.PNG"})
    EXPECT_EQ(betaMapFiles(folder / name, lights), writeBetaMaps(set, folder / name)) << name;
  EXPECT_TRUE(betaMapFiles("beta.png", {}).empty()) << "the name itself is not written";
}

TEST(BetaFile, ChecksSizeChannelAndRange) {
  const test::TemporaryFolder folder;
  Image map(ImageSpec{4, 4, {"Y"}, "data"}, .5f);
  const auto read = [&](int width, const std::string& channel) {
    writeImage(map, folder / "map.exr");
    return test::inputError([&] { (void)mapOf(folder / "map.exr", channel, "key", width, 4); });
  };
  EXPECT_THAT(read(5, ""), testing::AllOf(HasSubstr("4 x 4"), HasSubstr("5 x 4")));
  EXPECT_THAT(read(4, "beta.fill"), testing::AllOf(HasSubstr("beta.fill"), HasSubstr("Y")));
  Image others(ImageSpec{4, 4, {"beta.fill", "beta.back"}, "data"}, .5F);
  writeImage(others, folder / "others.exr");
  EXPECT_THAT(test::inputError([&] { (void)mapOf(folder / "others.exr", "", "key", 4, 4); }),
              HasSubstr("beta.key"));
  map.plane(0)[6] = 1.5f;
  EXPECT_THAT(read(4, ""), testing::AllOf(HasSubstr("2, 1"), HasSubstr("1.5")));
  map.plane(0)[6] = NAN;
  EXPECT_THAT(read(4, ""), HasSubstr("2, 1"));
}

TEST(BetaFile, ProportionsThatDoNotAddUpAreSaidWithThePixel) {
  const test::TemporaryFolder folder;
  const auto file = folder / "beta.exr";
  SolvedSet set = test::smallSet(3, 40, 30);
  const std::vector<std::string> names = {"light1", "light2", "light3"};
  const auto read = [&](size_t lights) {
    writeBetaMaps(set, file);
    return readBetaMaps(file, "", {names.begin(), names.begin() + static_cast<ptrdiff_t>(lights)}, 40, 30);
  };
  EXPECT_NO_THROW(checkProportions(read(3), true, file));  // as it was written, black pixels too
  EXPECT_NO_THROW(checkProportions(read(2), false, file));
  const size_t pixel = 5 * 40 + 7;
  for (int i = 0; i < 3; ++i) set.beta.plane(i)[pixel] = i == 0 ? .9F : .4F;
  EXPECT_THAT(test::inputError([&] { checkProportions(read(3), true, file); }),
              testing::AllOf(HasSubstr("beta.exr"), HasSubstr("pixel 7, 5"), HasSubstr("1.700"),
                             HasSubstr("expected 1.")));
  EXPECT_THAT(test::inputError([&] { checkProportions(read(2), false, file); }),
              HasSubstr("expected 1 at most"));
  for (int i = 0; i < 3; ++i) set.beta.plane(i)[pixel] = .2F;
  EXPECT_THAT(test::inputError([&] { checkProportions(read(3), true, file); }), HasSubstr("0.600"));
  EXPECT_NO_THROW(checkProportions(read(2), false, file)) << "others have the rest";
  EXPECT_NO_THROW(checkProportions(read(1), false, file));
}

TEST(BetaFile, AnEditOfAllLightsThatShareRefusesSumsButOneThatAddsTakesThem) {
  const test::TemporaryFolder folder;
  SolvedSet set = test::smallSet(2, 40, 30);
  set.beta.plane(0)[3] = set.beta.plane(1)[3] = 1;
  writeBetaMaps(set, folder / "beta.exr");
  updateBeta(set);
  Edit edit;
  edit.operation = BetaMapOperation{(folder / "beta.exr").string(), ""};
  EditStack stack;
  stack.append(edit);
  EXPECT_THAT(test::inputError([&] { (void)applyEdits(set, stack); }), HasSubstr("pixel 3, 0"));
  edit.energy = EnergyMode::Add;
  stack.replace(0, edit);
  const SolvedSet added = applyEdits(set, stack);
  const auto grey = [](const Image& light) {
    return light.plane(0)[3] + light.plane(1)[3] + light.plane(2)[3];
  };
  const float white = grey(set.contributions[0]) + grey(set.contributions[1]);
  for (const Image& light : added.contributions) EXPECT_NEAR(grey(light), white, 1e-5F * white);
}

TEST(BetaFile, AFileIsReadOnceAndAgainWhenAsked) {
  const test::TemporaryFolder folder;
  const auto file = folder / "map.exr";
  const auto write = [&](float value) { writeImage(Image(ImageSpec{4, 4, {"Y"}, "data"}, value), file); };
  write(.25F);
  const BetaRequest request{{file.string(), ""}, {"key"}, 4, 4};
  BetaFiles files;
  EXPECT_FALSE(files.known(request));
  const auto maps = files.maps(request);
  write(.5F);
  EXPECT_EQ(files.maps(request), maps);
  files.forget();
  EXPECT_FALSE(files.known(request));
  EXPECT_FLOAT_EQ(files.maps(request)->maps.front().plane(0)[0], .5F);
  files.keep(request, nullptr, "map.exr: is no map");
  EXPECT_TRUE(files.known(request));
  EXPECT_EQ(test::inputError([&] { (void)files.maps(request); }), "map.exr: is no map");
}

TEST(BetaFile, AnEditWhoseFileHasChangedIsComputedAgain) {
  const test::TemporaryFolder folder;
  const auto set = std::make_shared<const SolvedSet>(test::smallSet(2, 40, 30));
  const auto file = folder / "map.exr";
  const auto write = [&](float value) { writeImage(Image(ImageSpec{40, 30, {"Y"}, "data"}, value), file); };
  Edit edit;
  edit.lights = {"light1"};
  edit.operation = BetaMapOperation{file.string(), ""};
  EditedSet edited(set);
  const auto shown = [&] {
    EditStack stack;
    stack.append(edit);  // another object each time
    edited.setStack(stack);
    edited.update();
    const std::vector<Image>& lights = edited.result().contributions;
    const auto grey = [](const Image& light) {
      return light.plane(0)[3] + light.plane(1)[3] + light.plane(2)[3];
    };
    return grey(lights[0]) / (grey(lights[0]) + grey(lights[1]));
  };
  write(.25F);
  EXPECT_NEAR(shown(), .25F, 1e-4F);
  write(.75F);
  EXPECT_NEAR(shown(), .25F, 1e-4F) << "what is known is not read again";
  edited.files().forget();
  EXPECT_NEAR(shown(), .75F, 1e-4F);
}

}  // namespace
}  // namespace swaplight
