#include "render/filter/part_plan.h"

#include <memory>
#include <optional>
#include <vector>

#include "core/filter/filter_file.h"
#include "tests/render/gl_test.h"

namespace swaplight {
namespace {

constexpr int kWidth = 15360, kHeight = 8640;
constexpr PartLimits kLimits{4096, 16384, size_t{512} << 20};

class PartPlan : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    m_program.emplace(std::make_shared<Filter>(
        filterFromText("/*{\"INPUTS\": [{\"NAME\": \"inputImage\", \"TYPE\": \"image\"}]}*/\n"
                       "void main() { gl_FragColor = IMG_THIS_PIXEL(inputImage); }",
                       "some.fs")));
  }
  void TearDown() override {
    m_program.reset();
    GlTest::TearDown();
  }
  /// Stages that draw the same and have these halos.
  [[nodiscard]] std::vector<PartGroup> plan(std::initializer_list<int> halos, int width = kWidth,
                                            int height = kHeight) const {
    std::vector<PlannedStage> stages;
    for (const int halo : halos) stages.push_back({&*m_program, {}, halo});
    return planParts(stages, width, height, kLimits);
  }

 private:
  std::optional<FilterProgram> m_program;
};

/// How often a pixel of a 16K frame is drawn, the halos of parts included.
double timesDrawn(const PartGroup& group) {
  const double across = (kWidth + group.side - 1) / group.side, up = (kHeight + group.side - 1) / group.side;
  return across * up * static_cast<double>(largestInput(group, kWidth, kHeight).pixelCount()) /
         (static_cast<double>(kWidth) * kHeight);
}

TEST_F(PartPlan, AFrameThatFitsIsDrawnAtOnce) {
  const std::vector<PartGroup> groups = plan({0, 200, 900}, 1920, 1080);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].end, 3U);
  EXPECT_GE(groups[0].side, 1920);
  EXPECT_EQ(largestInput(groups[0], 1920, 1080), FilterWindow::whole(1920, 1080));
}

TEST_F(PartPlan, TexturesStayBelowTheLimit) {
  for (const int halo : {0, 60, 300}) {
    const std::vector<PartGroup> groups = plan({halo});
    ASSERT_EQ(groups.size(), 1U);
    const auto part = static_cast<size_t>(groups[0].side);
    EXPECT_LE((largestInput(groups[0], kWidth, kHeight).pixelCount() + part * part) * 16,
              kLimits.textureBytes);
    EXPECT_GT(part, 2048U);
  }
}

TEST_F(PartPlan, HalosWiderThanWhatFitsDoNotDrawTheFrameOverAndOver) {
  for (const int halo : {1921, 2400, 4800, 8800}) {
    const std::vector<PartGroup> groups = plan({halo});
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_LE(timesDrawn(groups[0]), 12) << halo;
  }
}

TEST_F(PartPlan, FiltersThatLookFarAreDrawnByThemselves) {
  const std::vector<PartGroup> groups = plan({0, 300, 0, 20, 20, 0});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].end, 3U);
  EXPECT_EQ(groups[0].halo, 300);
  EXPECT_EQ(groups[1].halo, 40);
}

TEST_F(PartPlan, APartAndItsHaloAreNoWiderThanATexture) {
  const PartGroup wide = plan({7517}, 30000, 2000).at(0);
  EXPECT_LE(largestInput(wide, 30000, 2000).width, kLimits.textureSide);
  const PartGroup impossible = plan({9000}, 30000, 2000).at(0);
  EXPECT_GT(largestInput(impossible, 30000, 2000).width, kLimits.textureSide);
}

}  // namespace
}  // namespace swaplight
