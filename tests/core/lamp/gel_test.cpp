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

}  // namespace
}  // namespace swaplight
