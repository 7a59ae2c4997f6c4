#include "render/filter/pipeline_memory.h"

#include <vector>

#include "render/filter/pipeline_renderer.h"
#include "tests/render/gl_test.h"

namespace swaplight {
namespace {

class PipelineMemoryTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    m_renderer = std::make_unique<PipelineRenderer>();
    m_options.displayFromScene = [this](ImageSpan) { ++m_views; };
  }
  void TearDown() override {
    m_renderer.reset();
    GlTest::TearDown();
  }
  [[nodiscard]] std::vector<ResolvedStage> stages(float exposure, int levels) const {
    std::vector<ResolvedStage> resolved;
    for (const FilterStage& stage :
         {FilterStage{"gaussian-blur", true, {{"sigma", 30.0F}}, {}},
          FilterStage{"exposure", true, {{"stops", exposure}}, {}},
          FilterStage{"posterize", true, {{"levels", static_cast<float>(levels)}}, {}},
          FilterStage{"exposure", true, {{"stops", 0.25F}}, {}}, FilterStage{"vignette", true, {}, {}}})
      resolved.push_back(resolveStage(m_library, stage, {}, "test"));
    return resolved;
  }
  Image draw(const std::vector<ResolvedStage>& stages, PipelineMemory* memory) {
    m_options.memory = memory;
    m_views = 0;
    return m_renderer->apply({m_frame.clone(), FilterSpace::SceneLinear}, stages, m_options).image;
  }
  void expectSame(const std::vector<ResolvedStage>& stages, PipelineMemory& memory, int views) {
    const Image plain = draw(stages, nullptr);
    const Image kept = draw(stages, &memory);
    EXPECT_EQ(m_views, views);
    for (int c = 0; c < 3; ++c)
      ASSERT_TRUE(std::equal(plain.plane(c), plain.plane(c) + plain.pixelCount(), kept.plane(c)));
  }

  Image m_frame = randomImage(200, 120, 3, 7);
  PipelineOptions m_options;
  std::unique_ptr<PipelineRenderer> m_renderer;
  FilterLibrary m_library = installedFilters();
  int m_views = 0;  ///< how often scene light became codes
};

TEST_F(PipelineMemoryTest, DrawsAgainFromTheChangedFilterOnToTheSameBits) {
  PipelineMemory memory;
  expectSame(stages(0, 4), memory, 1);
  expectSame(stages(0, 5), memory, 1);  // of two pictures alike nothing is known before the second
  expectSame(stages(0, 6), memory, 0);
  expectSame(stages(0, 7), memory, 0);
  expectSame(stages(1, 7), memory, 1);  // an earlier filter
  expectSame(stages(1, 7), memory, 1);
  expectSame(stages(1, 4), memory, 1);
  expectSame(stages(1, 5), memory, 0);
}

TEST_F(PipelineMemoryTest, AFilterThatIsTakenOutOrPutInIsAChange) {
  PipelineMemory memory;
  std::vector<ResolvedStage> all = stages(0, 4);
  expectSame(all, memory, 1);
  all.erase(all.begin() + 3);
  expectSame(all, memory, 1);
  all.insert(all.begin() + 3, stages(2, 4)[1]);
  expectSame(all, memory, 1);
  all.erase(all.begin());
  expectSame(all, memory, 1);
}

TEST_F(PipelineMemoryTest, KeepsNothingOfFiltersThatAreNotTheProgramsOwn) {
  PipelineMemory memory;
  std::vector<ResolvedStage> mixed = stages(0, 4);
  const auto foreign = std::make_shared<Filter>(*mixed[0].filter);
  foreign->builtIn = false;
  mixed[0].filter = foreign;
  expectSame(mixed, memory, 1);
  mixed[4].values[0] = 0.5F;
  expectSame(mixed, memory, 1);
  mixed[4].values[0] = 0.6F;
  expectSame(mixed, memory, 1);
}

}  // namespace
}  // namespace swaplight
