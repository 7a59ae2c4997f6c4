#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <functional>

#include "core/base/error.h"
#include "core/filter/filter_file.h"
#include "core/filter/glsl/glsl_translation.h"
#include "tests/support/temporary_folder.h"

// Filters are downloaded. Nothing in one may crash the program or keep it busy.

namespace swaplight {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Lt;
using testing::Not;
using testing::StartsWith;

constexpr size_t kMany = 400'000;

std::string times(size_t count, const std::string& what) {
  std::string text;
  text.reserve(count * what.size());
  for (size_t i = 0; i < count; ++i) text += what;
  return text;
}

Filter hostileFilter(const std::string& header, const std::string& body = "void main() {}") {
  return filterFromText("/*" + header + "*/\n" + body, "soft.fs");
}

std::string fragmentOf(const std::string& header, const std::string& body) {
  return translateFilter(hostileFilter(header, body)).fragment;
}

double processorSeconds(const std::function<void()>& work) {
  const std::clock_t begun = std::clock();
  work();
  return static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
}

constexpr double kMostSeconds = 3;  // under sanitizers, too

TEST(HostileFilter, MayHoldAnyNumberOfBlanksAndDigits) {
  EXPECT_THAT(fragmentOf("{}", "#" + times(kMany, " ") + "\nvoid main() { float half = 1.0; }"),
              HasSubstr("isf_word_half"));
  EXPECT_THAT(fragmentOf("{}", "#version " + times(kMany, "1") + "\nvoid main() { float half = 1.0; }"),
              AllOf(HasSubstr("float half"), Not(HasSubstr("#version 11"))));
}

TEST(GlslTranslation, AsksAFilterWhichGlslItIs) {
  const auto keepsWords = [](const std::string& directive) {
    return fragmentOf("{}", directive + "\nfloat half;").find("float half") != std::string::npos;
  };
  EXPECT_TRUE(keepsWords("#version 130"));
  EXPECT_TRUE(keepsWords("  #  version\t330 core"));
  EXPECT_FALSE(keepsWords("#version 120"));
  EXPECT_FALSE(keepsWords("#version 99"));
  EXPECT_FALSE(keepsWords("#version"));
  // Types that ISF's GLSL does not have: written for a newer one without saying so.
  EXPECT_TRUE(keepsWords("const uvec4 glyph = uvec4(0u);"));
  EXPECT_TRUE(keepsWords("uint digits(float x) { return uint(x); }"));
  EXPECT_FALSE(keepsWords("float uint = 1.0;"));
  EXPECT_FALSE(keepsWords("#version core"));
  EXPECT_FALSE(keepsWords("// #version 330"));
}

TEST(HostileFilter, AnErrorOfTheCompilerIsOneShortLine) {
  const std::string name = times(kMany, "x");
  for (const std::string& log :
       {"0:3(1): error: `" + name + "' undeclared\n0:4(1): error: more",
        "ERROR: 0:3: '" + name + "' : undeclared\n",
        "0(3) : error C1008: undefined variable \"" + name + "\"\n", name, times(kMany, "0:3(")}) {
    const std::string line = compileErrorLine(log, "soft.fs");
    EXPECT_THAT(line, StartsWith("soft.fs:"));
    EXPECT_THAT(line.size(), Lt(400U));
    EXPECT_THAT(line, Not(HasSubstr("\n")));
  }
}

TEST(HostileFilter, LoopsCostWhatTheirTextIsLong) {
  for (const char* loop :
       {"for(;;)", "for(", "for(;", "while(1)", "for(int i=0;i<8;i++)", "do while(", "for(int i=0;i<8;i++);"})
    EXPECT_LT(processorSeconds([&] {
                static_cast<void>(fragmentOf("{}", "void main() { " + times(60'000, loop) + "; }"));
              }),
              kMostSeconds)
        << loop;
}

TEST(HostileFilter, NamesOfImagesCostWhatTheTextIsLong) {
  std::string inputs;
  for (int i = 0; i < 250; ++i)
    inputs +=
        (i ? ", {\"NAME\": \"image" : "{\"NAME\": \"image") + std::to_string(i) + R"(", "TYPE": "image"})";
  std::string fragment;
  EXPECT_LT(processorSeconds([&] {
              fragment =
                  fragmentOf("{\"INPUTS\": [" + inputs + "]}", times(kMany, "_x ") + "_image7_imgSize");
            }),
            kMostSeconds);
  EXPECT_THAT(fragment, HasSubstr("isf_window_image7.zw"));
}

TEST(HostileFilter, AHeaderKeepsToTheLimitsOfJson) {
  const auto said = [](const std::string& header) {
    return test::inputError([&] { (void)hostileFilter(header); });
  };
  std::string keys;
  for (int i = 0; i < 100'000; ++i) keys += ", \"k" + std::to_string(i) + "\": 0";
  EXPECT_THAT(said("{\"a\": 0" + keys + "}"),
              AllOf(StartsWith("soft.fs: "), HasSubstr("more than 4096 keys")));
  EXPECT_THAT(said(R"({"INPUTS": [{"NAME": "a", "TYPE": "long", "VALUES": [1], "LABELS": [)" +
                   times(kMany, "[") + times(kMany, "]") + "]}]}"),
              HasSubstr("nested deeper"));
  EXPECT_THAT(said(R"({"PASSES": [{"WIDTH": 1e999}]})"),
              AllOf(StartsWith("soft.fs: "), HasSubstr("too large")));
}

TEST(HostileFilter, AnExpressionIsQuotedNoLongerThanItCanBeRead) {
  const std::string header = R"({"PASSES": [{"WIDTH": ")" + times(kMany, "(") + "\"}]}";
  const std::string line = test::inputError([&] { (void)hostileFilter(header); });
  EXPECT_THAT(line, AllOf(HasSubstr("the expression \"(((("), HasSubstr("fewer brackets")));
  EXPECT_THAT(line.size(), Lt(400U));
}

}  // namespace
}  // namespace swaplight
