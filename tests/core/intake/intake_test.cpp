#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/flat_fields.h"
#include "core/capture/left_out.h"
#include "core/image/io/image_io.h"
#include "core/intake/capture_draft.h"
#include "core/intake/photograph_choice.h"
#include "core/intake/replaced_colors.h"
#include "core/intake/rotation_guess.h"
#include "core/solve/solve.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/synthetic_capture.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::TemporaryFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

void writePicture(const std::filesystem::path& file, const std::map<std::string, std::string>& text = {},
                  int width = 8) {
  WriteOptions options;
  options.text = text;
  writeImage(Image(ImageSpec::rgb(width, 6), 0.5F), file, options);
}

std::vector<std::string> filesOf(const ShotFolder& folder) {
  std::vector<std::string> files;
  files.reserve(folder.shots.size());
  for (const FoundShot& shot : folder.shots) files.push_back(shot.file);
  return files;
}

TEST(ShotFolder, NumbersInNamesCountAsNumbers) {
  const TemporaryFolder folder;
  for (const char* name : {"shot_10.exr", "shot_9.exr", "shot_1.exr", "shot_010b.exr"})
    writePicture(folder.path() / name);
  const ShotFolder found = scanShotFolder(test::builtinColors(), folder.path());
  EXPECT_THAT(filesOf(found), ElementsAre("shot_1.exr", "shot_9.exr", "shot_10.exr", "shot_010b.exr"));
  EXPECT_FALSE(found.timed);
}

TEST(ShotFolder, TheTimeOfTheirTakingGoesBeforeNames) {
  const TemporaryFolder folder;
  writePicture(folder.path() / "a.exr", {{"DateTime", "2026:11:21 10:00:30"}});
  writePicture(folder.path() / "b.exr", {{"DateTime", "2026:11:21 10:00:10"}});
  const ShotFolder found = scanShotFolder(test::builtinColors(), folder.path());
  EXPECT_TRUE(found.timed);
  EXPECT_THAT(filesOf(found), ElementsAre("b.exr", "a.exr"));
}

TEST(ShotFolder, AmbientDarkAndWhatIsNoPictureAreNoShots) {
  const TemporaryFolder folder;
  for (const char* name : {"one.exr", "two.exr", "Ambient.exr", "dark_1.exr"})
    writePicture(folder.path() / name);
  std::ofstream(folder.path() / "notes.txt") << "lunch";
  std::ofstream(folder.path() / "clip.mov") << "film";
  const ShotFolder found = scanShotFolder(test::builtinColors(), folder.path());
  EXPECT_THAT(filesOf(found), ElementsAre("one.exr", "two.exr"));
  EXPECT_EQ(found.ambient, "Ambient.exr");
  EXPECT_EQ(found.dark, "dark_1.exr");
  EXPECT_THAT(found.notes, ElementsAre(HasSubstr("clip.mov is left out")));
}

TEST(ShotFolder, APictureOfAnotherSizeIsLeftOutAndNamed) {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "b.exr"}) writePicture(folder.path() / name);
  writePicture(folder.path() / "phone.exr", {}, 12);
  const ShotFolder found = scanShotFolder(test::builtinColors(), folder.path());
  EXPECT_THAT(filesOf(found), ElementsAre("a.exr", "b.exr"));
  EXPECT_THAT(found.notes,
              ElementsAre("phone.exr is left out: it is 12 x 6 pixels, the other photographs are 8 x 6"));
  writePicture(folder.path() / "phone2.exr", {}, 12);
  EXPECT_EQ(scanShotFolder(test::builtinColors(), folder.path()).shots.size(), 4U)
      << "nobody knows which two are meant";
}

TEST(ShotFolder, AFolderWithoutPhotographsIsSaid) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { static_cast<void>(scanShotFolder(test::builtinColors(), folder.path())); },
              ThrowsMessage<InputError>(HasSubstr("has no photographs")));
  EXPECT_THAT([&] { static_cast<void>(scanShotFolder(test::builtinColors(), folder.path() / "none")); },
              ThrowsMessage<InputError>(HasSubstr("is no folder")));
}

TEST(PhotographChoice, ACaptureTellsOfThePhotographsBesideIt) {
  const TemporaryFolder folder;
  for (const char* name : {"1.exr", "2.exr", "3.exr", "4.exr"}) writePicture(folder.path() / name);
  const ShotFolder all = scanShotFolder(test::builtinColors(), folder.path());
  const ShotFolder used = withShotsLeftOut(all, {"2.exr"}, "--leave-out");
  EXPECT_THAT(filesOf(used), ElementsAre("1.exr", "3.exr", "4.exr"));
  CaptureDraft draft = draftOf(used, {"key", "fill"});
  setLighting(draft, 0, shotColorsFromText("0.9/0.2/0.15,off"));
  setLighting(draft, 1, shotColorsFromText("unknown,?a"));
  Capture capture = captureOf(draft);
  capture.shots.pop_back();  // a photograph that came later
  std::vector<Shot> leftOut = leftOutOf(capture);
  leftOut[0].lightColors[1] = Rgb(1);
  capture = withLeftOut(std::move(capture), leftOut);
  const std::vector<ToldPhotograph> told = toldPhotographs(capture, all);
  ASSERT_EQ(told.size(), 4u);
  EXPECT_THAT(told[0].colors, ElementsAre("0.9/0.2/0.15", "off"));
  EXPECT_FALSE(told[1].used);
  EXPECT_THAT(told[1].colors, ElementsAre("", "white"));
  EXPECT_THAT(told[2].colors, ElementsAre("unknown", "?a"));
  EXPECT_TRUE(told[3].used);
  EXPECT_THAT(told[3].colors, IsEmpty());
  EXPECT_THAT([&] { static_cast<void>(withShotsLeftOut(all, {"5.exr"}, "--leave-out")); },
              ThrowsMessage<InputError>(HasSubstr("no photograph \"5.exr\" to leave out")));
}

TEST(PhotographChoice, PicturesOfSomeAreThoseOfTheirPlaces) {
  auto pixels = std::make_shared<CapturePixels>();
  for (const float value : {1.0F, 2.0F, 3.0F}) {
    pixels->shots.emplace_back(ImageSpec::rgb(2, 2), value);
    pixels->clipLevel.push_back(10 * value);
    pixels->quantum.push_back(100 * value);
  }
  EXPECT_EQ(pixelsOf(pixels, {0, 1, 2}), pixels) << "nothing is copied";
  const auto some = pixelsOf(pixels, {0, 2});
  ASSERT_EQ(some->shots.size(), 2u);
  EXPECT_EQ(some->shots[1].plane(0)[0], 3);
  EXPECT_THAT(some->clipLevel, ElementsAre(10, 30));
  EXPECT_THAT(some->quantum, ElementsAre(100, 300));
}

TEST(ShotColor, IsAGelANumberOrUnknown) {
  EXPECT_EQ(shotColorFromText("0.9/0.2/0.1").color, Rgb(0.9F, 0.2F, 0.1F));
  EXPECT_EQ(shotColorFromText(" off ").color, Rgb(0));
  EXPECT_EQ(shotColorFromText("l106").text, "l106");
  EXPECT_GT(shotColorFromText("L106").color->r, 3 * shotColorFromText("L106").color->b);
  EXPECT_FALSE(shotColorFromText("unknown").color);
  EXPECT_THAT([] { static_cast<void>(shotColorFromText("reddish")); },
              ThrowsMessage<InputError>(HasSubstr("'reddish' is no colour of a light")));
}

TEST(ReplacedColors, FollowAGelFromLightToLight) {
  Capture capture = rotatedCapture(3);
  *capture.shots[1].lightColors[0] *= 1.05F;  // lamps differ a little
  capture.shots[2].lightColors[2] = Rgb(0);
  const Capture replaced = withReplacedColors(capture, shotColorsFromText("1/1/1,?x,L106"));
  EXPECT_EQ(replaced.shots[0].lightColors[0], Rgb(1));
  EXPECT_EQ(replaced.shots[1].lightColors[2], Rgb(1));
  EXPECT_EQ(replaced.shots[1].colorName(0), "?x");
  EXPECT_EQ(replaced.shots[0].colorName(1), "?x");
  EXPECT_EQ(replaced.shots[2].lightColors[2], Rgb(0)) << "what is like none of them stays";
  const Capture again = withReplacedColors(replaced, shotColorsFromText("1/1/1,.2/.3/.4,L106"));
  EXPECT_EQ(again.shots[1].lightColors[0], Rgb(.2F, .3F, .4F)) << "a name is followed, too";
  EXPECT_THROW(static_cast<void>(withReplacedColors(capture, shotColorsFromText("1/1/1"))), InputError);
  capture.shots[0].lightColors[1].reset();
  EXPECT_THROW(static_cast<void>(withReplacedColors(capture, shotColorsFromText("L106,?,L119"))), InputError);
}

TEST(ShotColor, IsReadOffACard) {
  Image shot(ImageSpec::rgb(40, 30), 0);
  for (int y = 10; y < 20; ++y)
    for (int x = 5; x < 15; ++x)
      for (int c = 0; c < 3; ++c) shot.span().at(c, x, y) = c == 0 ? 0.6F : 0.2F;
  const Rgb color = *colorOfCard(shot, 10, 15, 5).color;
  EXPECT_NEAR(color.r, 0.6F, 1e-5);
  EXPECT_NEAR(color.g, 0.2F, 1e-5);
  EXPECT_THROW(static_cast<void>(colorOfCard(shot, 30, 25)), InputError);
  EXPECT_THROW(static_cast<void>(colorOfCard(shot, 40, 2)), InputError);
}

/// A draft of pictures that were never in files.
CaptureDraft draftFor(const Capture& capture) {
  ShotFolder folder;
  folder.folder = "/set";
  for (size_t k = 0; k < capture.shots.size(); ++k)
    folder.shots.push_back({fmt::format("{}.exr", k + 1), "", "lin_rec709", "openexr", 128, 64, {}});
  std::vector<std::string> names;
  names.reserve(capture.lights.size());
  for (const Light& light : capture.lights) names.push_back(light.name);
  return draftOf(folder, names);
}

std::vector<ShotColor> ringOf(int lights) {
  std::vector<ShotColor> ring;
  ring.reserve(static_cast<size_t>(lights));
  for (int i = 0; i < lights; ++i) ring.push_back(shotColorFromRgb(defaultColors()[static_cast<size_t>(i)]));
  return ring;
}

TEST(ShotColor, UnknownOfTheSameNameIsTheSame) {
  EXPECT_EQ(shotColorFromText("?a").name(), "?a");
  EXPECT_EQ(shotColorFromText("?").name(), "");
  const std::vector<ShotColor> ring = namedUnknowns(shotColorsFromText("?a,?,L106,unknown"));
  EXPECT_EQ(ring[0].name(), "?a");
  EXPECT_EQ(ring[1].name(), "?b");
  EXPECT_TRUE(ring[2].color);
  EXPECT_EQ(ring[3].name(), "?c");
  const Capture capture = captureOf(
      withRotation(draftFor(rotatedCapture(2)), namedUnknowns(shotColorsFromText("L106,?")), {0, 1}));
  EXPECT_EQ(capture.shots[0].colorName(1), "?a");
  EXPECT_EQ(capture.shots[1].colorName(0), "?a");
}

TEST(RotationGuess, FindsHowTheColoursMoved) {
  for (const int lights : {2, 3, 4})
    for (const int direction : {1, -1}) {
      Capture capture = rotatedCapture(lights);
      if (direction < 0) std::reverse(capture.shots.begin() + 1, capture.shots.end());
      capture.noise = SensorNoise{0.002, 20000};
      const CapturePixels pixels = photograph(capture, SyntheticSet(lights, 0.3F));
      const RotationGuess guess = guessRotation(draftFor(capture), pixels, ringOf(lights));
      for (int k = 0; k < lights; ++k)
        EXPECT_EQ(guess.steps[static_cast<size_t>(k)], ((direction * k) % lights + lights) % lights)
            << lights << " lights: " << guess.words;
      EXPECT_THAT(guess.words, Not(HasSubstr("please check")));
    }
}

TEST(RotationGuess, SaysWhenTheColoursDoNotFit) {
  Capture capture = rotatedCapture(2);
  const CapturePixels pixels = photograph(capture, SyntheticSet(2, 0));
  const std::vector<ShotColor> wrong{shotColorFromText("0.9/0.85/0.8"), shotColorFromText("0.5/0.55/0.6")};
  EXPECT_THAT(guessRotation(draftFor(capture), pixels, wrong).words, HasSubstr("poor fit"));
}

TEST(RotationGuess, NeedsKnownColoursOneALight) {
  const Capture capture = rotatedCapture(2);
  const CapturePixels pixels = photograph(capture, SyntheticSet(2, 0));
  EXPECT_THROW(static_cast<void>(guessRotation(draftFor(capture), pixels, ringOf(3))), InputError);
  EXPECT_THROW(
      static_cast<void>(guessRotation(draftFor(capture), pixels, shotColorsFromText("L106,unknown"))),
      InputError);
}

TEST(CaptureDraft, RolesComeFromNamesOrFromTheOrder) {
  Capture capture = rotatedCapture(2);
  capture.lights[0].name = "back";
  EXPECT_EQ(captureOf(draftFor(capture)).lights[0].role, Role::Back);
  EXPECT_EQ(captureOf(draftFor(capture)).lights[1].role, Role::Other);
  EXPECT_EQ(captureOf(draftFor(rotatedCapture(2))).lights[1].role, Role::Fill);
}

TEST(CaptureDraft, ExposuresOfTheFilesAreCountedIn) {
  CaptureDraft draft = draftFor(rotatedCapture(2));
  draft.folder.shots[0].exposureStops = 3;
  draft.folder.shots[1].exposureStops = 2.01;
  EXPECT_FLOAT_EQ(captureOf(draft).shots[1].exposureStops, -1);
  draft.folder.shots[0].exposureStops.reset();
  EXPECT_EQ(captureOf(draft).shots[1].exposureStops, 0);
}

TEST(CaptureDraft, KeepsWhatAReplacedDescriptionSaysBeyondIt) {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "b.exr", "c.exr", "card.exr", "black.exr"})
    writePicture(folder.path() / name);
  std::ofstream(folder.path() / "capture.json") << R"({
    "format": "swaplight-capture", "version": 1, "name": "kitchen", "color_space": "srgb", "crew": "second unit",
    "lights": [{"name": "key", "role": "practical", "lamp": "Dedo"}, {"name": "gone"}],
    "shots": [{"image": "a.exr", "light_colors": [[1, 1, 1], [0, 0, 0]], "slate": "12A"},
              {"image": "lost.exr", "light_colors": [[0, 0, 0], [1, 1, 1]]}],
    "left_out": [{"image": "c.exr", "light_colors": [[1, 1, 1], [1, 1, 1]], "why": "moved", "flats": {"gone": "card.exr"}}],
    "dark": "black.exr", "ambient": "lost.exr", "noise": {"read": 0.002, "full_well": 20000, "iso": 800},
    "flats": {"key": "card.exr", "gone": "card.exr"}, "vignetting": "lost.exr",
    "truth": {"key": "T_key.exr", "gone": "T_gone.exr"}})";
  const ShotFolder found =
      withShots(test::builtinColors(), scanShotFolder(test::builtinColors(), folder.path()),
                {"a.exr", "b.exr", "c.exr"});
  CaptureDraft draft = draftOf(withShotsLeftOut(found, {"c.exr"}, "here"), {"key", "fill"});
  const Capture made = readCapture(test::builtinColors(), writeDraft(draft, true));
  EXPECT_EQ(made.name, "kitchen");
  EXPECT_EQ(made.colorSpace, draft.colorSpace);
  EXPECT_EQ(made.lights[0].role, Role::Practical);
  EXPECT_EQ(made.lights[0].extra.json()["lamp"], "Dedo");
  EXPECT_EQ(made.lights[1].name, "fill");
  ASSERT_EQ(made.shots.size(), 2U);
  EXPECT_FALSE(made.shots[0].lightColors[0]) << "the colours are the draft's";
  EXPECT_EQ(made.shots[0].extra.json()["slate"], "12A");
  EXPECT_EQ(leftOutOf(made).at(0).extra.json()["why"], "moved");
  EXPECT_FALSE(leftOutOf(made).at(0).extra.json().contains("flats")) << "it could not be read again";
  EXPECT_EQ(made.dark, "black.exr");
  EXPECT_FALSE(made.ambient) << "it is not there";
  EXPECT_EQ(made.noise, (SensorNoise{.002, 20000}));
  EXPECT_EQ(made.truth, (std::map<std::string, std::string>{{"key", "T_key.exr"}}));
  EXPECT_EQ(flatNamesOf(made).lamps, (std::map<std::string, std::string>{{"key", "card.exr"}}));
  EXPECT_FALSE(flatNamesOf(made).lens);
  EXPECT_EQ(made.extra.json()["crew"], "second unit");
  EXPECT_EQ(made.extra.json()["noise"]["iso"], 800);
}

TEST(CaptureDraft, APictureThatIsAShotNowIsNotKeptAsAmbientLight) {
  const TemporaryFolder folder;
  for (const char* name : {"a.exr", "b.exr"}) writePicture(folder.path() / name);
  std::ofstream(folder.path() / "capture.json") << R"({
    "format": "swaplight-capture", "version": 1, "lights": [{"name": "key"}], "ambient": "b.exr",
    "shots": [{"image": "a.exr", "light_colors": [[1, 1, 1]]}]})";
  const CaptureDraft draft = draftOf(scanShotFolder(test::builtinColors(), folder.path()), {"key"});
  EXPECT_FALSE(readCapture(test::builtinColors(), writeDraft(draft, true)).ambient);
}

TEST(CaptureDraft, ReplacesADescriptionThatCannotBeRead) {
  const TemporaryFolder folder;
  writePicture(folder.path() / "a.exr");
  std::ofstream(folder.path() / "capture.json") << "{";
  const CaptureDraft draft = draftOf(scanShotFolder(test::builtinColors(), folder.path()), {"key"});
  EXPECT_EQ(readCapture(test::builtinColors(), writeDraft(draft, true)).shots.size(), 1U);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "capture.json.broken"));
}

TEST(CaptureDraft, WarnsOfColoursThatAreTooAlike) {
  const CaptureDraft same =
      withRotation(draftFor(rotatedCapture(2)), shotColorsFromText("0.5/0.5/0.5,0.5/0.5/0.5"), {0, 1});
  EXPECT_THAT(colorWarnings(same), Contains(HasSubstr("light1")));
  EXPECT_THAT(colorWarnings(withRotation(draftFor(rotatedCapture(2)), ringOf(2), {0, 1})), IsEmpty());
}

TEST(CaptureDraft, WarnsOfClippedPicturesAndAMovedCamera) {
  const Capture capture = rotatedCapture(2);
  CapturePixels pixels = photograph(capture, SyntheticSet(2, 0));
  pixels.clipLevel = {0.4F, INFINITY};
  const CaptureDraft draft = withRotation(draftFor(capture), ringOf(2), {0, 1});
  EXPECT_THAT(pictureWarnings(draft, pixels), Contains(HasSubstr("1.exr: ")));
}

TEST(CaptureDraft, SaysWhatItAssumesOfAnUnknownColour) {
  CaptureDraft draft = withRotation(draftFor(rotatedCapture(2)), ringOf(2), {0, 1});
  draft.colors[0][1] = shotColorFromText("unknown");
  EXPECT_THAT(colorWarnings(draft),
              ElementsAre(HasSubstr("the colour of light1 in 1.exr is unknown: it is estimated from the")));
}

TEST(CaptureDraft, SaysWhereTwoPhotographsLeaveAColourOpen) {
  const std::vector<ShotColor> ring = namedUnknowns(shotColorsFromText("L106,?"));
  EXPECT_THAT(colorWarnings(withRotation(draftFor(rotatedCapture(2)), ring, {0, 1})),
              ElementsAre(HasSubstr("?a, the colour of light1 in 1.exr, light0 in 2.exr, is unknown: it is "
                                    "estimated from the pictures, but two photographs leave one number of it "
                                    "open")));
}

TEST(CaptureDraft, AnUnknownColourIsFoundAndSaidByTheSolve) {
  const Capture truth = rotatedCapture(2);
  const CapturePixels pixels = photograph(truth, SyntheticSet(2, 0));
  Capture capture = truth;
  capture.shots[0].lightColors[1].reset();
  const SolvedSet set = solve(capture, pixels, {});
  EXPECT_THAT(set.report->message, HasSubstr("The colour of light1 in shot 1 was not known: estimated"));
  const Rgb wanted = *truth.shots[0].lightColors[1];
  // Up to a factor: how bright the light was there can only be seen against its other shots.
  const Rgb& found = set.report->refinedColors[1];
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c] / found.g, wanted[c] / wanted.g, 0.1);
}

}  // namespace
}  // namespace swaplight
