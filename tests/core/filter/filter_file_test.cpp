#include "core/filter/filter_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/base/error.h"
#include "core/filter/glsl/glsl_translation.h"
#include "core/filter/size_expression.h"

namespace swaplight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Filter filterOf(const std::string& header, const std::string& body = "void main() {}") {
  return filterFromText("/*" + header + "*/\n" + body, "folder/soft.fs");
}

std::string errorOf(const std::function<void()>& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(FilterFile, ReadsWhatIsf2Defines) {
  const Filter filter = filterOf(R"json({
    "ISFVSN": "2", "DESCRIPTION": "Soft", "CATEGORIES": ["Blur", "Film"],
    "INPUTS": [{"NAME": "inputImage", "TYPE": "image"},
               {"NAME": "amount", "TYPE": "float", "DEFAULT": 0.5, "MIN": 0, "MAX": 2, "LABEL": "How much"},
               {"NAME": "mode", "TYPE": "long", "VALUES": [3, 5], "LABELS": ["a", "b"], "DEFAULT": 5},
               {"NAME": "at", "TYPE": "point2D", "DEFAULT": [0.1, 0.2]},
               {"NAME": "tint", "TYPE": "color", "DEFAULT": [1, 0, 0, 0.5]},
               {"NAME": "on", "TYPE": "bool", "DEFAULT": 1}],
    "PASSES": [{"TARGET": "small", "WIDTH": "floor($WIDTH / 4.0)", "HEIGHT": 12, "FLOAT": true}, {}]
})json");
  EXPECT_EQ(filter.name, "soft");
  EXPECT_TRUE(filter.takesImage);
  EXPECT_FALSE(filter.ours);
  EXPECT_EQ(filter.space, FilterSpace::Display);
  ASSERT_EQ(filter.inputs.size(), 5U);
  EXPECT_EQ(filter.inputs[0].label, "How much");
  EXPECT_EQ(std::get<float>(filter.inputs[0].standard), 0.5F);
  EXPECT_EQ(std::get<int>(filter.inputs[1].standard), 5);
  EXPECT_EQ(std::get<FilterPoint>(filter.inputs[2].standard), (FilterPoint{0.1F, 0.2F}));
  EXPECT_EQ(std::get<FilterColor>(filter.inputs[3].standard), (FilterColor{1, 0, 0, 0.5F}));
  EXPECT_TRUE(std::get<bool>(filter.inputs[4].standard));
  ASSERT_EQ(filter.passes.size(), 2U);
  EXPECT_EQ(filter.passes[0].target, "small");
  EXPECT_TRUE(filter.passes[0].isFloat);
}

TEST(FilterFile, ReadsPersistentBuffersOfIsf1) {
  const Filter filter = filterOf(
      R"json({"INPUTS": [], "PERSISTENT_BUFFERS": ["last"], "PASSES": [{"TARGET": "last"}, {}]})json");
  EXPECT_TRUE(filter.passes[0].persistent);
  EXPECT_THAT(filter.notes, testing::SizeIs(2));  // it remembers, and it has no picture
}

TEST(FilterFile, OwnKeyNamesSpaceHaloAndUnits) {
  const Filter filter = filterOf(R"json({"INPUTS": [{"NAME": "sigma", "TYPE": "float"}],
    "SWAPLIGHT": {"SPACE": "scene_linear", "HALO": "ceil(3 * $sigma)", "UNIT": {"sigma": "px"}, "SAMPLING": "nearest"
}
})json");
  EXPECT_EQ(filter.space, FilterSpace::SceneLinear);
  EXPECT_EQ(filter.halo, "ceil(3 * $sigma)");
  EXPECT_EQ(filter.inputs[0].unit, "px");
  EXPECT_TRUE(filter.nearest);
}

constexpr const char* kOwnInputs =
    R"json({"INPUTS": [{"NAME": "a", "TYPE": "float"}], "SWAPLIGHT": {"INPUTS": [
    {"NAME": "gains", "TYPE": "vector", "DEFAULT": [1, 2, 3], "MIN": 0, "MAX": 4, "LABEL": "Gain"},
    {"NAME": "mixing", "TYPE": "matrix", "DEFAULT": [[0, 1], [1, 0]]},
    {"NAME": "tone", "TYPE": "curve", "DEFAULT": [[0, 0], [0.5, 0.7], [1, 1]]}], "UNIT": {"gains": "times"}}})json";

TEST(FilterFile, OwnKeyHoldsVectorsMatricesAndCurves) {
  const Filter filter = filterOf(kOwnInputs);
  ASSERT_EQ(filter.inputs.size(), 4U);
  EXPECT_EQ(filter.inputs[1].type, FilterInputType::Vector);
  EXPECT_EQ(std::get<FilterVector>(filter.inputs[1].standard), (FilterVector{1, 2, 3}));
  EXPECT_EQ(filter.inputs[1].label, "Gain");
  EXPECT_EQ(filter.inputs[1].unit, "times");
  EXPECT_EQ(std::get<FilterMatrix>(filter.inputs[2].standard), (FilterMatrix{{0, 1}, {1, 0}}));
  EXPECT_EQ(std::get<FilterCurve>(filter.inputs[3].standard).size(), 3U);
  EXPECT_EQ(filter.inputs[3].high, FilterValue(1.0F)) << "a curve's height, unless it says otherwise";
}

TEST(FilterFile, OwnTypesAndIsfsStandInListsOfTheirOwn) {
  const auto error = [](const std::string& header) { return errorOf([&] { filterOf(header); }); };
  EXPECT_THAT(error(R"json({"INPUTS": [{"NAME": "a", "TYPE": "vector"}]})json"),
              HasSubstr("list it in the key \"SWAPLIGHT\""));
  EXPECT_THAT(error(R"json({"SWAPLIGHT": {"INPUTS": [{"NAME": "a", "TYPE": "float"}]}})json"),
              HasSubstr("expected vector, matrix or curve"));
  EXPECT_THAT(
      error(
          R"json({"SWAPLIGHT": {"INPUTS": [{"NAME": "a", "TYPE": "matrix", "DEFAULT": [[1, 2], [3]]}]}})json"),
      HasSubstr("rows of as many numbers"));
  EXPECT_THAT(
      error(
          R"json({"SWAPLIGHT": {"INPUTS": [{"NAME": "a", "TYPE": "curve", "DEFAULT": [[1, 0], [0, 1]]}]}})json"),
      HasSubstr("as point 2, expected 2 to 16 points"));
  EXPECT_THAT(
      error(
          R"json({"SWAPLIGHT": {"INPUTS": [{"NAME": "a", "TYPE": "vector", "DEFAULT": [9, 0], "MAX": 4}]}})json"),
      HasSubstr("\"DEFAULT\": is 9:0, expected any to 4"));
}

TEST(FilterInput, ChecksEachNumberOfVectorsMatricesAndCurves) {
  const Filter filter = filterOf(kOwnInputs);
  const auto error = [&](size_t input, const FilterValue& value) {
    return errorOf([&] { filter.inputs[input].check(value, "x", true); });
  };
  EXPECT_EQ(error(1, FilterVector{0, 4, 2}), "nothing thrown");
  EXPECT_THAT(error(1, FilterVector{0, 4.5F, 2}), HasSubstr("is 0:4.5:2, expected 0 to 4 times"));
  EXPECT_THAT(error(1, FilterVector{1, 2}), HasSubstr("not of the type vector, as 1:2:3"));
  EXPECT_THAT(error(2, FilterMatrix{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
              HasSubstr("of the type matrix, as 0:1/1:0"));
  EXPECT_EQ(error(3, FilterCurve{{0, 1}, {1, 0}}), "nothing thrown");
  EXPECT_THAT(error(3, FilterCurve{{0, 1}, {1, 1.5F}}), HasSubstr("expected 0 to 1"));
}

TEST(FilterValue, VectorsMatricesAndCurvesComeBackFromTextsAndFiles) {
  using Type = FilterInputType;
  const std::vector<std::pair<Type, FilterValue>> values = {
      {Type::Vector, FilterVector{1, -0.5F, 0.25F}},
      {Type::Matrix, FilterMatrix{{1, 0}, {0.5F, -1}}},
      {Type::Matrix, FilterMatrix{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {Type::Curve, FilterCurve{{0, 0.1F}, {0.25F, 0.5F}, {1, 1}}}};
  for (const auto& [type, value] : values) {
    EXPECT_EQ(filterValueFromText(textFromFilterValue(value), type, "x"), value);
    EXPECT_EQ(filterValueFromJson(jsonFromFilterValue(value), type, "x"), value);
  }
  const auto error = [](const char* text, Type type) {
    return errorOf([&] { static_cast<void>(filterValueFromText(text, type, "x")); });
  };
  EXPECT_EQ(error("1", Type::Vector), "x: is \"1\" (write 1:0.5:0.25), expected two to four numbers");
  EXPECT_THAT(error("1:0:0/0:1", Type::Matrix), HasSubstr("(write 1:0:0/0:1:0/0:0:1)"));
  EXPECT_THAT(error("0:0/0.5:0.5/0.5:1", Type::Curve), HasSubstr("(write 0:0/0.5:0.7/1:1)"));
  EXPECT_THAT(error("up", Type::Curve), HasSubstr("is \"up\""));
}

TEST(FilterFile, ErrorsNameFileLineAndWhatToDo) {
  const auto error = [](const std::string& header) { return errorOf([&] { filterOf(header); }); };
  EXPECT_THAT(errorOf([] { static_cast<void>(filterFromText("void main() {}", "soft.fs")); }),
              HasSubstr("soft.fs: no ISF header"));
  EXPECT_THAT(error("{\n\"INPUTS\": [}\n"),
              HasSubstr("folder/soft.fs: the header: line 2, column 12: syntax error"));
  EXPECT_THAT(error(R"json({"INPUTS": [{"TYPE": "float"}]})json"), HasSubstr("input 1: \"NAME\""));
  EXPECT_THAT(error(R"json({"INPUTS": [{"NAME": "a", "TYPE": "flaot"}]})json"),
              HasSubstr("\"flaot\", expected event"));
  EXPECT_THAT(error(R"json({"INPUTS": [{"NAME": "a", "TYPE": "color", "DEFAULT": "red"}]})json"),
              HasSubstr("three or four"));
  EXPECT_THAT(
      error(R"json({"INPUTS": [{"NAME": "a", "TYPE": "float"}, {"NAME": "a", "TYPE": "float"}]})json"),
      HasSubstr("two inputs are called \"a\""));
  EXPECT_THAT(error(R"json({"PASSES": [{"TARGET": "a", "WIDTH": "$WIDHT / 2"}, {}]})json"),
              HasSubstr("WIDHT"));
  EXPECT_THAT(error(R"json({"SWAPLIGHT": {"SPACE": "linear"}})json"),
              HasSubstr("scene_linear, display or any"));
  EXPECT_THAT(error(R"json({"SWAPLIGHT": {"UNIT": {"x": "px"}}})json"), HasSubstr("no input \"x\""));
}

TEST(FilterInput, ChecksTypeRangeAndChoice) {
  const Filter filter = filterOf(R"json({"INPUTS": [{"NAME": "a", "TYPE": "float", "MIN": 0, "MAX": 2},
    {"NAME": "m", "TYPE": "long", "VALUES": [1, 2], "LABELS": ["one", "two"]}]})json");
  EXPECT_NO_THROW(filter.inputs[0].check(1.5F, "a", true));
  EXPECT_THAT(errorOf([&] { filter.inputs[0].check(2.5F, "a", true); }), HasSubstr("expected 0 to 2"));
  EXPECT_NO_THROW(filter.inputs[0].check(2.5F, "a", false));
  EXPECT_THAT(errorOf([&] { filter.inputs[1].check(3, "m", true); }), HasSubstr("1 (one), 2 (two)"));
  EXPECT_THROW(filter.inputs[0].check(true, "a", true), InputError);
}

TEST(SizeExpression, FollowsThePrecedenceOfArithmetic) {
  const ExpressionVariables variables = [](const std::string& name) -> std::optional<double> {
    return name == "WIDTH" ? std::optional(1920.0) : std::nullopt;
  };
  EXPECT_EQ(expressionValue("1 + 2 * 3 - 8 / 4", variables), 5);
  EXPECT_EQ(expressionValue("max(floor($WIDTH*0.25), 1.0)", variables), 480);
  EXPECT_EQ(expressionValue("-(2 - 5) % 2", variables), 1);
  EXPECT_EQ(expressionValue("1 / 0", variables), 0);
  EXPECT_THAT(errorOf([&] { static_cast<void>(expressionValue("1 +", variables)); }), HasSubstr("its end"));
  EXPECT_THAT(errorOf([&] { static_cast<void>(expressionValue("$x", variables)); }), HasSubstr("$WIDTH"));
  EXPECT_THAT(errorOf([&] { static_cast<void>(expressionValue(std::string(1000, '('), variables)); }),
              HasSubstr("fewer brackets"));
}

TEST(GlslTranslation, MakesIsfsWordsPlainGlsl) {
  const Filter filter = filterOf(R"json({"INPUTS": [{"NAME": "inputImage", "TYPE": "image"}]})json",
                                 "varying vec2 c;\nvoid main() { float sample = 1.0;\n"
                                 "gl_FragColor = sample * IMG_NORM_PIXEL(inputImage, f(c, 1.0)); }");
  const GlslTranslation glsl = translateFilter(filter);
  EXPECT_THAT(glsl.fragment, HasSubstr("in vec2 c;"));
  EXPECT_THAT(glsl.fragment, HasSubstr("isf_normPixel(inputImage, isf_window_inputImage, f(c, 1.0))"));
  EXPECT_THAT(glsl.fragment, HasSubstr("float isf_word_sample"));
  EXPECT_THAT(glsl.fragment, Not(HasSubstr("varying")));
  EXPECT_TRUE(glsl.looksElsewhere);
  EXPECT_THAT(glsl.images, ElementsAre("inputImage"));
}

TEST(GlslTranslation, DeclaresVectorsMatricesAndCurves) {
  const GlslTranslation glsl =
      translateFilter(filterOf(kOwnInputs, "void main() { gl_FragColor = vec4(gains, tone(a)); }"));
  EXPECT_THAT(glsl.fragment, HasSubstr("uniform vec3 gains;"));
  EXPECT_THAT(glsl.fragment, HasSubstr("uniform mat2 mixing;"));
  EXPECT_THAT(glsl.fragment, HasSubstr("float tone(float x)"));
  EXPECT_THAT(glsl.fragment, HasSubstr("#define SWAPLIGHT 1"));
}

TEST(GlslTranslation, BoundsLoopsThatNeedNotEnd) {
  const auto fragment = [](const std::string& body) {
    return translateFilter(filterOf("{}", body)).fragment;
  };
  EXPECT_THAT(fragment("void main() { while (true) {} }"), HasSubstr("while (isf_go() && (true))"));
  EXPECT_THAT(fragment("void main() { for (;;) {} }"), HasSubstr("for (;isf_go();)"));
  EXPECT_THAT(fragment("void main() { do x(); while (a); }"), HasSubstr("while (isf_go() && (a))"));
  EXPECT_THAT(fragment("void main() { for (int i = 0; i < 8; ++i) x(); }"),
              HasSubstr("for (int i = 0; i < 8; ++i)"));
  EXPECT_THAT(fragment("void main() { for (int i = 0; i < 8; ++i) { i -= 1; } }"),
              HasSubstr("isf_go() && ( i < 8)"));
  EXPECT_THAT(fragment("void main() { for (int i = 0; i < 9999; ++i) x(); }"), HasSubstr("isf_go()"));
  EXPECT_THAT(fragment("void main() { for (int i = 0; i < 8; ++i) for (int j = 0; j < 8; ++j) x(); }"),
              HasSubstr("isf_go() && ( i < 8)"));
  EXPECT_THAT(fragment("void main() { for (float x = 0.0; x < n; x += 0.1) y(); }"), HasSubstr("isf_go()"));
}

TEST(GlslTranslation, CompileErrorsNameTheAuthorsLine) {
  EXPECT_EQ(compileErrorLine("0:12(3): error: `isf_word_sample' undeclared", "a.fs"),
            "a.fs:12: `sample' undeclared");
  EXPECT_EQ(compileErrorLine("0(7) : error C1008: undefined variable \"x\"", "a.fs"),
            "a.fs:7: undefined variable \"x\"");
  EXPECT_EQ(compileErrorLine("ERROR: 0:3: 'x' : undeclared", "a.fs"), "a.fs:3: 'x' : undeclared");
}

}  // namespace
}  // namespace swaplight
