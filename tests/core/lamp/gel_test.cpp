#include "core/lamp/gel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "core/lamp/kelvin.h"
#include "core/lamp/lamp.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

CorrelatedTemperature through(const char* gel, double kelvin) {
  Lamp lamp = Lamp::white(kelvin);
  lamp.through(findGel(gel));
  return correlatedTemperature(xyFromRec709(lamp.color()));
}

TEST(Gel, CorrectionGelsReachTheTemperaturesThatTheirMakersState) {
  // Lee: L201 3200 to 5700 K, L202 to 4300 K, L203 to 3600 K; L204 6500 to 3200 K, L205 to 3800 K.
  EXPECT_NEAR(through("L201", 3200).kelvin, 5700, 60);
  EXPECT_NEAR(through("L202", 3200).kelvin, 4270, 60);
  EXPECT_NEAR(through("L203", 3200).kelvin, 3600, 30);
  EXPECT_NEAR(through("L204", 6500).kelvin, 3200, 20);
  EXPECT_NEAR(through("L205", 6500).kelvin, 3800, 30);
  EXPECT_NEAR(through("L206", 6500).kelvin, 4590, 60);
}

TEST(Gel, AFullGreenGelIsOneUnitOfGreen) {
  // Daylight of 5000 K lies 0.003 above the black body.
  EXPECT_NEAR(through("L244", 5000).duv, kFullGreenDuv + 0.003, 1e-3);
  EXPECT_NEAR(through("L247", 5000).duv, -kFullGreenDuv + 0.003, 1e-3);
}

TEST(Gel, ANeutralDensityTakesStopsAndNoColor) {
  Lamp lamp = Lamp::white(kD65Kelvin);
  lamp.through(findGel("L209"));
  EXPECT_EQ(lamp.color().x, lamp.color().y);
  EXPECT_NEAR(std::log2(lamp.color().x), -1, 0.01);
}

TEST(Gel, EveryGelTakesLightAndMakesNone) {
  for (const Gel& gel : builtInGels())
    for (const double kelvin : {2000.0, 3200.0, 6504.0, 20000.0}) {
      Lamp lamp = Lamp::white(kelvin);
      lamp.through(gel);
      EXPECT_GT(luminance(lamp.color()), 0) << gel.id;
      EXPECT_LE(luminance(lamp.color()), 1) << gel.id;
    }
}

TEST(Gel, EveryIdIsThereOnce) {
  std::set<std::string> ids;
  for (const Gel& gel : builtInGels()) EXPECT_TRUE(ids.insert(gel.id).second) << gel.id;
}

TEST(Gel, IsFoundWhateverTheCaseAndTheKnownOnesAreListed) {
  EXPECT_EQ(findGel("l201").id, "L201");
  EXPECT_THAT([] { static_cast<void>(findGel("L9999")); },
              testing::ThrowsMessage<InputError>(
                  testing::AllOf(testing::HasSubstr("L9999"), testing::HasSubstr("L201"))));
}

TEST(GelCsv, ReadsATableWithOrWithoutNamedColumns) {
  const auto gels = gelsFromCsv(
      "# my gels\n"
      "brand,number,name,x,y,T\n"
      "Lee,777,\"Rust, dark\",0.5,0.4,34%\n"
      "\n"
      "gam,12,Mint,0.3,0.4,0.5\r\n",
      "gels.csv");
  ASSERT_EQ(gels.size(), 2u);
  EXPECT_EQ(gels[0].id, "L777");
  EXPECT_EQ(gels[0].name, "Rust, dark");
  EXPECT_NEAR(gels[0].transmission, 0.34, 1e-6);
  EXPECT_NEAR(luminance(gels[0].filter), 0.34, 1e-5);
  EXPECT_NEAR(xyFromRec709(gels[0].filter).x, 0.5, 1e-5);
  EXPECT_EQ(gels[1].id, "G12");
  EXPECT_EQ(gelsFromCsv("T,y,x,name,number,brand\n50,0.33,0.31,Grey,1,Lee\n", "a").at(0).id, "L1");
}

TEST(GelCsv, SaysWhichLineIsWrong) {
  const auto message = [](const char* text) {
    return test::inputError([&] { static_cast<void>(gelsFromCsv(text, "gels.csv")); });
  };
  EXPECT_THAT(message("Lee,1,a,0.3,0.3,1\nLee,2,b,0.3\n"),
              testing::HasSubstr("gels.csv: line 2: has 4 columns"));
  EXPECT_THAT(message("Lee,1,a,0.3,wide,1\n"), testing::HasSubstr("line 1: y is 'wide'"));
  EXPECT_THAT(message("Lee,1,a,0.3,0,1\n"), testing::HasSubstr("y is '0'"));
  EXPECT_THAT(message(",1,a,0.3,0.3,1\n"), testing::HasSubstr("brand and number"));
}

TEST(Gel, SaysHowItIsKnown) {
  // BALANCE: linear .701/.227/.133, .023/.376/.114, 1/.597/0, 0/.019/.117.
  const struct {
    const char* id;
    Rgb filter;
  } published[] = {{"R4660", {.701F, .227F, .133F}},
                   {"R89", {.023F, .376F, .114F}},
                   {"R12", {1, .597F, 0}},
                   {"R59", {0, .019F, .117F}}};
  for (const auto& one : published) {
    const Gel& gel = findGel(one.id);
    EXPECT_EQ(gel.source, Gel::Source::Published) << one.id;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(gel.filter[c], one.filter[c], 1e-3) << one.id;
  }
  EXPECT_EQ(findGel("L201").source, Gel::Source::Maker);
  EXPECT_EQ(findGel("L106").source, Gel::Source::ByEye);
  const auto own = gelsFromCsv(
      "brand,number,name,x,y,T,source\nA,1,a,.3,.3,.5,measured\nB,2,b,.3,.3,.5,\nC,3,c,.3,.3,.5\n",
      "gels.csv");
  EXPECT_EQ(own[0].source, Gel::Source::Measured);
  EXPECT_EQ(own[1].source, Gel::Source::Table);
  EXPECT_EQ(own[2].source, Gel::Source::Table);
}

TEST(GelCsv, TakesInMeasuredGels) {
  const Rgb filter(.7F, .2F, .1F);
  const GelLabel label = GelLabel::fromText("Rosco,4660,\"60 Red, old\"");
  EXPECT_EQ(label.name, "60 Red, old");
  const std::string table = withMeasuredGel("", "gels.csv", label, filter);
  const Gel gel = gelsFromCsv(table, "gels.csv").at(0);
  EXPECT_EQ(gel.id, "R4660");
  EXPECT_EQ(gel.name, "60 Red, old");
  EXPECT_EQ(gel.source, Gel::Source::Measured);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(gel.filter[c], filter[c], 1e-4);
  EXPECT_THAT(test::inputError([&] { (void)withMeasuredGel(table, "gels.csv", label, filter); }),
              testing::HasSubstr("R4660"));
  // A table that is there keeps its columns, comments and order.
  const std::string own = "# mine\nT,y,x,name,number,brand,note\n50,0.33,0.31,Grey,1,Lee,dear";
  const std::string more = withMeasuredGel(own, "gels.csv", GelLabel::fromText("Lee,2"), filter);
  EXPECT_THAT(more, testing::StartsWith(own + "\n"));
  EXPECT_EQ(gelsFromCsv(more, "gels.csv").at(1).id, "L2");
  EXPECT_NEAR(gelsFromCsv(more, "gels.csv").at(1).filter.r, filter.r, 1e-4);
  EXPECT_THROW((void)withMeasuredGel(own, "gels.csv", label, Rgb(0)), InputError);
  EXPECT_THAT(test::inputError([&] { (void)withMeasuredGel(own, "gels.csv", label, Rgb(1.3F)); }),
              testing::HasSubstr("more through than there was"));
  EXPECT_EQ(gelsFromCsv(withMeasuredGel("", "gels.csv", label, Rgb(1.02F)), "gels.csv").at(0).transmission, 1)
      << "noise";
  // What begins with # is no comment.
  const std::string byName = "name,brand,number,x,y,T\n";
  const std::string numbered =
      withMeasuredGel(byName, "gels.csv", GelLabel::fromText("Lee,3,#3 Red"), filter);
  EXPECT_EQ(gelsFromCsv(numbered, "gels.csv").at(0).name, "#3 Red");
  for (const char* wrong : {"", "Lee", "Lee,", ",1", "Lee,1,a,b", "#Lee,1", "Lee,1,a\nb"})
    EXPECT_THROW((void)GelLabel::fromText(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace swaplight
