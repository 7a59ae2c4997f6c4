#include "core/solve/model/solve_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/json.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::inputError;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(SolveOptions, DenoisingComesBackFromJson) {
  SolveOptions options;
  options.denoise = Denoise::Guided;
  options.guidedRadius = 3;
  const Json json = jsonFromSolveOptions(options);
  EXPECT_EQ(json["denoise"], "guided");
  EXPECT_EQ(solveOptionsFromJson(json), options);
  EXPECT_EQ(jsonFromSolveOptions({})["denoise"], "off");
}

TEST(SolveOptions, ACorrectedToneComesBackFromJson) {
  SolveOptions options;
  options.correctTone = Remedy::On;
  EXPECT_EQ(solveOptionsFromJson(jsonFromSolveOptions(options)), options);
  options.correctTone = Remedy::Off, options.align = Remedy::On;
  EXPECT_EQ(solveOptionsFromJson(jsonFromSolveOptions(options)), options);
  EXPECT_EQ(solveOptionsFromJson({{"align", false}}).align, Remedy::Sure)
      << "so older programs wrote what nobody asked";
  for (const char* key : {"correct_tone", "align"})
    EXPECT_FALSE(jsonFromSolveOptions({}).contains(key)) << "what older programs do not know";
}

TEST(SolveOptions, EveningOfLampsComesBackFromJson) {
  SolveOptions options;
  options.field = true;
  EXPECT_EQ(solveOptionsFromJson(jsonFromSolveOptions(options)), options);
  EXPECT_EQ(jsonFromSolveOptions({}).count("field"), 0U) << "a solve without it stays the same file";
}

TEST(SolveOptions, WhatSettlesAnOpenColourComesBackFromJson) {
  SolveOptions options;
  options.openColor.oneLamp = {"key", 12, 34};
  options.openColor.grey = {5, 6};
  options.openColor.luminance = .4F;
  options.openColor.position = .25F;
  options.openColor.exchanged = true;
  EXPECT_EQ(solveOptionsFromJson(jsonFromSolveOptions(options)), options);
  EXPECT_EQ(jsonFromSolveOptions({}).count("open_color"), 0U);
  EXPECT_THAT(inputError([] {
                static_cast<void>(solveOptionsFromJson({{"open_color", {{"grey", {1}}}}}));
              }),
              HasSubstr("grey"));
  EXPECT_THAT(inputError([] {
                static_cast<void>(solveOptionsFromJson({{"open_color", {{"grey", {1, 4294967297}}}}}));
              }),
              HasSubstr("4294967297"));
}

TEST(SolveOptions, AnUnknownDenoisingIsNotTakenForNone) {
  EXPECT_THAT(inputError([] {
                static_cast<void>(solveOptionsFromJson({{"denoise", "strong"}}));
              }),
              AllOf(HasSubstr("\"strong\""), HasSubstr("off, guided")));
}

TEST(SolveOptions, WhatLiesOutOfItsRangeIsSaid) {
  EXPECT_NO_THROW(SolveOptions().check());
  const auto message = [](const auto& spoil) {
    SolveOptions options;
    spoil(options);
    return inputError([&] { options.check(); });
  };
  EXPECT_THAT(message([](SolveOptions& options) { options.guidedRadius = 0; }),
              AllOf(HasSubstr("radius"), HasSubstr("1 to 1000")));
  EXPECT_THAT(message([](SolveOptions& options) { options.colorUncertainty = 2; }), HasSubstr("0 to 1"));
  EXPECT_THAT(message([](SolveOptions& options) { options.colorUncertainty = NAN; }), HasSubstr("nan"));
  EXPECT_THAT(message([](SolveOptions& options) {
                options.noise = SensorNoise{-.1, 2e4};
              }),
              HasSubstr("read noise"));
  EXPECT_THAT(message([](SolveOptions& options) {
                options.noise = SensorNoise{.1, 0};
              }),
              HasSubstr("full well"));
}

}  // namespace
}  // namespace swaplight
