#include "core/capture/flat_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/json.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using testing::HasSubstr;
using testing::IsEmpty;

Json manifestWithFlats() {
  return {
      {"format", "swaplight-capture"},
      {"version", 1},
      {"color_space", "lin_rec709"},
      {"name", "flat"},
      {"lights", {{{"name", "key"}, {"role", "key"}}, {{"name", "fill"}, {"role", "fill"}}}},
      {"shots",
       {{{"image", "1.exr"}, {"light_colors", {{1, 0, 0}, {0, 1, 0}}}},
        {{"image", "2.exr"}, {"light_colors", {{0, 1, 0}, {1, 0, 0}}}, {"flats", {{"key", "key2.exr"}}}}}},
      {"flats", {{"fill", "fill.exr"}, {"key", "key.exr"}}},
      {"vignetting", "lens.exr"}};
}

TEST(FlatNames, AreReadAndWrittenAgain) {
  const Capture capture = captureFromJson(manifestWithFlats(), "/set");
  EXPECT_THAT(capture.warnings, IsEmpty());
  const FlatNames names = flatNamesOf(capture);
  EXPECT_EQ(names.lamps.at("fill"), "fill.exr");
  ASSERT_EQ(names.shots.size(), 2U);
  EXPECT_THAT(names.shots[0], IsEmpty());
  EXPECT_EQ(names.shots[1].at("key"), "key2.exr");
  EXPECT_EQ(names.lens, "lens.exr");
  const Json written = jsonFromCapture(capture);
  EXPECT_EQ(written["flats"], manifestWithFlats()["flats"]);
  EXPECT_EQ(written["vignetting"], "lens.exr");
  EXPECT_EQ(written["shots"][1]["flats"], manifestWithFlats()["shots"][1]["flats"]);
  EXPECT_FALSE(written["shots"][0].contains("flats"));
}

TEST(FlatNames, AreAddedToThoseThatAreThere) {
  const Capture capture = withFlats(captureFromJson(manifestWithFlats(), "/set"), {{"key", "new.exr"}}, "");
  const FlatNames names = flatNamesOf(capture);
  EXPECT_EQ(names.lamps.at("key"), "new.exr");
  EXPECT_EQ(names.lamps.at("fill"), "fill.exr");
  EXPECT_EQ(names.lens, "lens.exr");
  EXPECT_THAT(inputError([&] {
                (void)withFlats(capture, {{"moon", "x.exr"}}, "");
              }),
              HasSubstr("there is no light \"moon\""));
}

TEST(FlatNames, WrongOnesAreSaid) {
  const auto complaint = [](const char* key, const Json& value) {
    Json json = manifestWithFlats();
    json[key] = value;
    return inputError([&] { (void)captureFromJson(json, "/set"); });
  };
  EXPECT_THAT(complaint("flats", {{"moon", "x.exr"}}), HasSubstr("flats: there is no light \"moon\""));
  EXPECT_THAT(complaint("flats", {{"key", ""}}), HasSubstr("\"key\" needs the path"));
  EXPECT_THAT(complaint("flats", {{"key", 3}}), HasSubstr("key"));
  EXPECT_THAT(complaint("flats", "all.exr"), HasSubstr("flats"));
  EXPECT_THAT(complaint("vignetting", 1), HasSubstr("vignetting"));
}

}  // namespace
}  // namespace swaplight
