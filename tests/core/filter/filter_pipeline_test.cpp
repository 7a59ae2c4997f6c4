#include "core/filter/filter_pipeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/atomic_file.h"
#include "core/filter/filter_library.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

constexpr const char* kSoft = R"(/*{"INPUTS": [{"NAME": "inputImage", "TYPE": "image"},
  {"NAME": "amount", "TYPE": "float", "DEFAULT": 0.5, "MIN": 0, "MAX": 1},
  {"NAME": "tint", "TYPE": "color"}], "SWAPLIGHT": {}}*/ void main() {})";

template <typename Function>
std::string errorOf(Function&& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing thrown";
}

class FilterPipelineTest : public testing::Test {
 protected:
  FilterPipelineTest() { writeFile(m_folder.path() / "Very Soft.fs", kSoft); }
  [[nodiscard]] FilterLibrary library() const {
    const std::vector<FilterFolder> folders = {{m_folder.path()}};
    return FilterLibrary(folders);
  }
  test::TemporaryFolder m_folder;
};

TEST_F(FilterPipelineTest, ComesBackFromItsFileWithUnknownKeys) {
  const Json json =
      Json::parse(R"json({"format": "swaplight-look", "version": 1, "name": "Dream", "filters": [
    {"filter": "very-soft", "on": false, "parameters": {"amount": 0.25, "tint": [1, 0.5, 0, 1]}, "colour": "later"}],
    "author": "someone"})json");
  const FilterPipeline pipeline = pipelineFromJson(json, "a.swaplook");
  EXPECT_EQ(jsonFromPipeline(pipeline), json);
  writePipeline(pipeline, m_folder.path() / "a.swaplook");
  FilterPipeline again = readPipeline(m_folder.path() / "a.swaplook");
  again.folder.clear();
  EXPECT_EQ(again, pipeline);
}

TEST_F(FilterPipelineTest, BadFilesAreOneLine) {
  const auto error = [](const char* text) {
    return errorOf([&] { static_cast<void>(pipelineFromJson(Json::parse(text), "a.swaplook")); });
  };
  EXPECT_THAT(error(R"json({"format": "x"})json"), HasSubstr("this is no camera look"));
  EXPECT_THAT(error(R"json({"format": "swaplight-look", "version": 9})json"), HasSubstr("newer version"));
  EXPECT_THAT(error(R"json({"format": "swaplight-look", "filters": []})json"),
              HasSubstr("\"name\" is missing"));
  EXPECT_THAT(error(R"json({"format": "swaplight-look", "name": "a", "filters": []})json"),
              HasSubstr("at least one"));
  EXPECT_THAT(
      error(
          R"json({"format": "swaplight-look", "name": "a", "filters": [{"filter": "x", "parameters": 3}]})json"),
      HasSubstr("filter 1 (x): \"parameters\""));
}

TEST_F(FilterPipelineTest, ParametersAreTypedWhenTheFilterIsKnown) {
  const FilterStage stage = stageFromText("very_soft,amount=0.75,tint=#ff8000");
  const ResolvedStage resolved = resolveStage(library(), stage, {}, "--filter");
  EXPECT_EQ(std::get<float>(resolved.values[0]), 0.75F);
  EXPECT_EQ(std::get<FilterColor>(resolved.values[1])[0], 1.0F);
  const auto error = [&](const char* text) {
    return errorOf([&] { static_cast<void>(resolveStage(library(), stageFromText(text), {}, "--filter")); });
  };
  EXPECT_THAT(error("very-soft,amount=2"), HasSubstr("expected 0 to 1"));
  EXPECT_THAT(error("very-soft,amount=lots"), HasSubstr("\"lots\", expected a number"));
  EXPECT_THAT(error("very-soft,amuont=1"), HasSubstr("it has amount, tint"));
  EXPECT_THAT(error("verysofd"), HasSubstr("did you mean Very Soft?"));
  EXPECT_THROW(static_cast<void>(stageFromText("soft,amount")), InputError);
}

TEST_F(FilterPipelineTest, FormerParametersGoOnBeingRead) {
  const auto parameters = [](const char* filter) {
    const std::string look =
        std::string(R"json({"format": "swaplight-look", "name": "a", "filters": [)json") + filter + "]}";
    return pipelineFromJson(Json::parse(look), "a.swaplook").stages[0].parameters;
  };
  const auto mixer = parameters(
      R"json({"filter": "channel-mixer", "parameters": {"red": [0, 1, 0, 1], "blue": [0.5, 0, 1, 1]}})json");
  ASSERT_EQ(mixer.size(), 1U);
  EXPECT_EQ(std::get<FilterMatrix>(mixer.at("matrix")), (FilterMatrix{{0, 1, 0}, {0, 1, 0}, {0.5F, 0, 1}}));
  const auto curves = parameters(R"json({"filter": "curves", "parameters": {"middle": 0.6}})json");
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(std::get<FilterCurve>(curves.at("tone")),
            (FilterCurve{{0, 0}, {0.25F, 0.2F}, {0.5F, 0.6F}, {0.75F, 0.8F}, {1, 1}}));
  const auto cdl = parameters(
      R"json({"filter": "CDL", "parameters": {"slope": [2, 1, 0.5, 1], "offset": [0.75, 0.5, 0.25, 1],
      "power": [0.5, 1, 0.25, 1], "saturation": 0.5}})json");
  ASSERT_EQ(cdl.size(), 4U);
  EXPECT_EQ(std::get<FilterVector>(cdl.at("slopes")), (FilterVector{2, 1, 0.5F}));
  EXPECT_EQ(std::get<FilterVector>(cdl.at("offsets")), (FilterVector{0.25F, 0, -0.25F}));
  EXPECT_EQ(std::get<FilterVector>(cdl.at("powers")), (FilterVector{1, 2, 0.5F}));
  EXPECT_EQ(std::get<FilterVector>(stageFromText("cdl,offset=#ffffff").parameters.at("offsets")),
            (FilterVector{0.5F, 0.5F, 0.5F}));
  const auto wrong = parameters(R"json({"filter": "curves", "parameters": {"middle": "high"}})json");
  EXPECT_TRUE(wrong.contains("middle")) << "said where the filter is known";
}

TEST_F(FilterPipelineTest, LibrarySkipsAndNamesBrokenFilesAndTakesTheFirstOfAName) {
  writeFile(m_folder.path() / "Broken.fs", "/*{*/");
  std::filesystem::create_directory(m_folder.path() / "z");
  writeFile(m_folder.path() / "z" / "very-soft.fs", kSoft);
  const FilterLibrary filters = library();
  EXPECT_EQ(filters.filters().size(), 1U);
  ASSERT_EQ(filters.problems().size(), 1U);
  EXPECT_THAT(filters.problems()[0], HasSubstr("Broken.fs"));
  EXPECT_THAT(errorOf([&] { static_cast<void>(filters.find("broken")); }),
              HasSubstr("Broken.fs: the header: line 1"));
}

}  // namespace
}  // namespace swaplight
