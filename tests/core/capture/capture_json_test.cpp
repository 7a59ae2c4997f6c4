#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/capture.h"
#include "core/capture/left_out.h"
#include "tests/support/builtin_colors.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Json manifest() {
  return Json::parse(R"({
    "format": "swaplight-capture", "version": 1, "name": "spheres", "color_space": "lin_rec709",
    "lights": [{"name": "key", "role": "key"}, {"name": "fill", "role": "fill"}],
    "shots": [
      {"image": "shot_01.exr", "light_colors": [[0.9, 0.2, 0.15], [0.15, 0.8, 0.25]], "exposure_stops": 0.5},
      {"image": "shot_02.exr", "light_colors": [[0.15, 0.8, 0.25], null]}
    ],
    "ambient": "ambient.exr", "noise": {"read": 0.002, "full_well": 20000},
    "truth": {"key": "truth/T_key.exr", "fill": "truth/T_fill.exr"}
  })");
}

std::string errorOf(const Json& json) {
  return inputError([&] { (void)captureFromJson(json, "set", "set/capture.json"); });
}

std::string errorOfText(const std::string& text) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "capture.json", text);
  return inputError([&] { (void)readCapture(test::builtinColors(), folder / "capture.json"); });
}

TEST(CaptureJson, AnAmbientPictureOfAnUnclearExposureIsWarnedOf) {
  const TemporaryFolder folder;
  const auto warningsOf = [&](float stops) {
    Json json = manifest();
    json["shots"][0]["exposure_stops"] = stops;
    test::writeBytes(folder / "capture.json", json.dump());
    return readCapture(test::builtinColors(), folder / "capture.json").warnings;
  };
  EXPECT_THAT(warningsOf(0.5F), ElementsAre(HasSubstr("the ambient picture is taken as exposed at 0")));
  EXPECT_THAT(warningsOf(0), IsEmpty());
}

TEST(CaptureJson, ReadsEveryFieldOfTheContract) {
  const Capture capture = captureFromJson(manifest(), "set");
  EXPECT_EQ(capture.name, "spheres");
  EXPECT_EQ(capture.colorSpace, "lin_rec709");
  ASSERT_EQ(capture.lightCount(), 2);
  EXPECT_EQ(capture.lights[1].role, Role::Fill);
  EXPECT_EQ(capture.lightIndex("fill"), 1);
  EXPECT_EQ(capture.lightIndex("rim"), -1);
  ASSERT_EQ(capture.shotCount(), 2);
  EXPECT_EQ(capture.shots[0].lightColors[1], Rgb(0.15f, 0.8f, 0.25f));
  EXPECT_FALSE(capture.shots[1].lightColors[1].has_value()) << "null is a colour to estimate";
  EXPECT_FLOAT_EQ(capture.shots[0].exposureStops, 0.5f);
  EXPECT_EQ(capture.ambient, "ambient.exr");
  EXPECT_FALSE(capture.dark);
  EXPECT_EQ(capture.noise, (SensorNoise{0.002, 20000}));
  EXPECT_EQ(capture.truth.at("fill"), "truth/T_fill.exr");
  EXPECT_THAT(capture.warnings, IsEmpty());
}

TEST(CaptureJson, WrittenBackIsTheSameJson) {
  EXPECT_EQ(jsonFromCapture(captureFromJson(manifest(), "set")), manifest());
}

TEST(CaptureJson, AnUnknownColourMayHaveAName) {
  Json json = manifest();
  json["shots"][0]["light_colors"][1] = "?a";
  const Capture capture = captureFromJson(json, "set");
  EXPECT_FALSE(capture.shots[0].lightColors[1]);
  EXPECT_EQ(capture.shots[0].colorName(1), "?a");
  EXPECT_EQ(capture.shots[0].colorName(0), "") << "a colour that is known has no name";
  EXPECT_EQ(capture.shots[1].colorName(1), "");
  EXPECT_EQ(jsonFromCapture(capture)["shots"], json["shots"]);
  json["shots"][0]["light_colors"][1] = "?";
  EXPECT_EQ(jsonFromCapture(captureFromJson(json, "set"))["shots"][0]["light_colors"][1], nullptr);
  for (const char* wrong : {"red", "a?", "?a b"}) {
    json["shots"][0]["light_colors"][1] = wrong;
    EXPECT_THAT(errorOf(json), AllOf(HasSubstr("the colour of fill"), HasSubstr(wrong), HasSubstr("\"?a\"")));
  }
}

TEST(CaptureJson, UnknownKeysAreKeptAndWarnedAbout) {
  Json json = manifest();
  json["camera"] = {{"iso", 100}};
  json["lights"][0]["gel"] = "L106";
  json["shots"][1]["note"] = "door open";
  json["noise"]["temperature"] = 20;
  const Capture capture = captureFromJson(json, "set", "set/capture.json");
  EXPECT_EQ(jsonFromCapture(capture), json);
  ASSERT_EQ(capture.warnings.size(), 4u);
  EXPECT_THAT(capture.warnings[0], HasSubstr("set/capture.json: light 1: the unknown key \"gel\" is kept"));
}

TEST(CaptureJson, ExposuresOfABracketAreRepeatedByAllOthers) {
  Json json = manifest();
  json["shots"][0].erase("exposure_stops");
  for (int k = 0; k < 2; ++k) json["shots"].push_back(json["shots"][size_t(k)]);
  json["exposures"] = {1, -2};
  const Capture capture = captureFromJson(json, "set");
  for (size_t k = 0; k < 4; ++k) EXPECT_FLOAT_EQ(capture.shots[k].exposureStops, k % 2 ? -3 : 0) << k;
  EXPECT_FLOAT_EQ(captureFromJson(jsonFromCapture(capture), "set").shots[3].exposureStops, -3);
  json["exposures"] = {0, -3, 2};
  EXPECT_THAT(errorOf(json), HasSubstr("\"exposures\" is "));
  json["exposures"] = {0, "much"};
  EXPECT_THAT(errorOf(json), HasSubstr("one for each of the 4 shots"));
  json["exposures"] = {0, -3};
  json["shots"][1]["exposure_stops"] = 1;
  EXPECT_THAT(errorOf(json), HasSubstr("shot 2 has \"exposure_stops\""));
}

TEST(CaptureJson, WhatIsLeftOutIsKeptWithItsColoursAndNoShot) {
  Json json = manifest();
  json["left_out"] = {json["shots"][1]};
  json["left_out"][0]["image"] = "blurred.exr";
  json["left_out"][0]["light_colors"][1] = nullptr;
  const Capture capture = captureFromJson(json, "set");
  EXPECT_EQ(capture.shotCount(), 2);
  const std::vector<Shot> leftOut = leftOutOf(capture);
  ASSERT_EQ(leftOut.size(), 1u);
  EXPECT_EQ(leftOut[0].image, "blurred.exr");
  EXPECT_FALSE(leftOut[0].lightColors[1]);
  EXPECT_TRUE(capture.warnings.empty());
  EXPECT_EQ(jsonFromCapture(capture), json);
  json["left_out"][0]["light_colors"] = {1, 2};
  EXPECT_THAT(errorOf(json), HasSubstr("left-out shot 1 (blurred.exr)"));
}

TEST(CaptureJson, ShotsThatAreLeftOutKeepTheOthersExposures) {
  Json json = manifest();
  json["shots"][1]["exposure_stops"] = -1;
  const Capture fewer = withShotsLeftOut(captureFromJson(json, "set"), {"shot_01.exr"}, "--leave-out");
  ASSERT_EQ(fewer.shotCount(), 1);
  EXPECT_EQ(fewer.shots[0].exposureStops, -1);
  EXPECT_EQ(leftOutOf(fewer)[0].lightColors.size(), 2u);
  EXPECT_EQ(inputError([&] { (void)withShotsLeftOut(fewer, {"shot_01.exr"}, "--leave-out"); }),
            "--leave-out: there is no photograph \"shot_01.exr\" to leave out; those in use are shot_02.exr");
  EXPECT_EQ(inputError([&] { (void)withShotsLeftOut(fewer, {"shot_02.exr"}, "--leave-out"); }),
            "--leave-out: leaves out all photographs. Keep at least as many as there are lights.");
}

TEST(CaptureJson, SurvivesTheDisk) {
  const TemporaryFolder folder;
  writeCapture(captureFromJson(manifest(), "set"), folder / "capture.json");
  const Capture capture = readCapture(test::builtinColors(), folder / "capture.json");
  EXPECT_EQ(jsonFromCapture(capture), manifest());
  EXPECT_EQ(capture.folder, folder.path());
  EXPECT_EQ(folder.fileCount(), 1u) << "no temporary file stays behind";
}

TEST(CaptureJson, SyntaxErrorsAreSaidWithLineAndColumn) {
  EXPECT_THAT(errorOfText("{\n  \"lights\": [1,]\n}"),
              HasSubstr("capture.json: line 2, column 16: syntax error"));
  EXPECT_THAT(errorOfText(""), HasSubstr("line 1, column 1"));
  EXPECT_THAT(errorOfText("{\n\"shots\": [NaN]}"),
              AllOf(HasSubstr("line 2, column 11"), HasSubstr("no NaN")));
  EXPECT_THAT(errorOfText("{\n\n\"a\": 1e999}"),
              HasSubstr("line 3, column 6: the number 1e999 is too large"));
  EXPECT_THAT(errorOfText("\xff\xfe"), HasSubstr("line 1, column 1"));
  EXPECT_THAT(errorOfText(std::string(100000, '[')), HasSubstr("nested deeper"));
}

TEST(CaptureJson, MissingFileAndFolderAreSaid) {
  const TemporaryFolder folder;
  EXPECT_THAT(inputError([&] { (void)readCapture(test::builtinColors(), folder / "none.json"); }),
              HasSubstr("none.json: no such file"));
  EXPECT_THAT(inputError([&] { (void)readCapture(test::builtinColors(), folder.path()); }),
              HasSubstr("is a folder"));
}

TEST(CaptureJson, NoLightsAndNoShotsAreSaid) {
  Json json = manifest();
  json["lights"] = Json::array();
  EXPECT_THAT(errorOf(json), HasSubstr("set/capture.json: has no lights"));
  json.erase("lights");
  EXPECT_THAT(errorOf(json), HasSubstr("\"lights\" is missing"));
  json = manifest();
  json["shots"] = Json::array();
  EXPECT_THAT(errorOf(json), HasSubstr("has no shots"));
  json.erase("shots");
  EXPECT_THAT(errorOf(json), HasSubstr("\"shots\" is missing"));
}

TEST(CaptureJson, ColourCountMustEqualLightCount) {
  Json json = manifest();
  json["shots"][1]["light_colors"].erase(1);
  EXPECT_EQ(
      errorOf(json),
      "set/capture.json: shot 2 (shot_02.exr): \"light_colors\" has 1 colour, the capture has 2 lights. "
      "Give one colour a light.");
  json["shots"][1].erase("light_colors");
  EXPECT_THAT(errorOf(json), HasSubstr("shot 2 (shot_02.exr): \"light_colors\" is missing"));
}

TEST(CaptureJson, NegativeNonFiniteAndImpossibleColoursAreRefused) {
  Json json = manifest();
  Json& channel = json["shots"][0]["light_colors"][1][2];
  channel = -0.1;
  EXPECT_THAT(errorOf(json),
              HasSubstr("shot 1 (shot_01.exr): the colour of fill: holds the negative number -0.1"));
  channel = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(errorOf(json), HasSubstr("which no lamp gives"));
  channel = 1e30;
  EXPECT_THAT(errorOf(json), HasSubstr("holds 1e+30, which no lamp gives"));
  channel = "red";
  EXPECT_THAT(errorOf(json), HasSubstr("holds the text \"red\", expected [red, green, blue]"));
  json["shots"][0]["light_colors"][1] = {1, 2};
  EXPECT_THAT(errorOf(json), HasSubstr("is a list of 2"));
}

TEST(CaptureJson, LightNamesMustSuitCompositors) {
  const auto named = [](const std::string& first, const std::string& second) {
    Json json = manifest();
    json["lights"][0]["name"] = first;
    json["lights"][1]["name"] = second;
    return errorOf(json);
  };
  EXPECT_THAT(named("key.left", "fill"), AllOf(HasSubstr("has a dot"), HasSubstr("Call it \"key_left\"")));
  EXPECT_THAT(named("1key", "fill"), HasSubstr("Call it \"light_1key\""));
  EXPECT_THAT(named("", "fill"), HasSubstr("empty name"));
  EXPECT_THAT(named("k\xc3\xa9y", "fill"), HasSubstr("is not allowed"));
  EXPECT_THAT(named("key", "key"), HasSubstr("two lights are called \"key\""));
  EXPECT_THAT(named("key", "KEY"), HasSubstr("differ in case only"));
  EXPECT_THAT(named("key", "Ambient"), HasSubstr("solved files keep that layer"));
}

TEST(CaptureJson, RolesAreListedWhereOneIsUnknown) {
  Json json = manifest();
  json["lights"][0]["role"] = "rim";
  EXPECT_THAT(errorOf(json),
              HasSubstr("light 1: the role \"rim\" is not known. Known roles: key, fill, back"));
}

TEST(CaptureJson, NewerVersionAndOtherFormatsAreRefused) {
  Json json = manifest();
  json["version"] = 2;
  EXPECT_THAT(errorOf(json), HasSubstr("is version 2 of swaplight-capture, this program reads up to 1"));
  json["version"] = "1";
  EXPECT_THAT(errorOf(json), HasSubstr("\"version\" is the text \"1\", expected a number"));
  json = manifest();
  json["format"] = "swaplight-session";
  EXPECT_THAT(errorOf(json), HasSubstr("\"format\" is \"swaplight-session\""));
  EXPECT_THAT(errorOf(Json::array()), HasSubstr("is a list of 0, expected an object"));
}

TEST(CaptureJson, WrongTypesAreSaid) {
  const auto with = [](const char* pointer, const Json& value) {
    Json json = manifest();
    json[Json::json_pointer(pointer)] = value;
    return errorOf(json);
  };
  EXPECT_THAT(with("/name", 3), HasSubstr("\"name\" is the number 3, expected a text"));
  EXPECT_THAT(with("/lights", "key"), HasSubstr("\"lights\" is the text \"key\""));
  EXPECT_THAT(with("/lights/0", 3), HasSubstr("light 1: is the number 3, expected an object"));
  EXPECT_THAT(with("/shots/0", nullptr), HasSubstr("shot 1: is null"));
  EXPECT_THAT(with("/shots/0/image", ""), HasSubstr("shot 1: \"image\" is empty"));
  EXPECT_THAT(with("/shots/0/exposure_stops", "one"), HasSubstr("\"exposure_stops\" is the text \"one\""));
  EXPECT_THAT(with("/noise", 3), HasSubstr("noise: is the number 3"));
  EXPECT_THAT(with("/noise/full_well", 0), HasSubstr("\"full_well\" is the number 0"));
  EXPECT_THAT(with("/noise/read", -1), HasSubstr("\"read\" is the number -1"));
  EXPECT_THAT(with("/ambient", false), HasSubstr("\"ambient\" is false"));
  EXPECT_THAT(with("/truth", Json::array()), HasSubstr("truth: is a list of 0"));
}

TEST(CaptureJson, WhatIsAssumedIsWarnedAbout) {
  Json json = manifest();
  for (const char* key : {"format", "version", "name", "color_space"}) json.erase(key);
  const Capture capture = captureFromJson(json, "sets/night");
  EXPECT_EQ(capture.name, "night");
  EXPECT_EQ(capture.warnings.size(), 3u);
}

}  // namespace
}  // namespace swaplight
