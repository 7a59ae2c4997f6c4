#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "core/base/json.h"
#include "core/edit/operations/operation_json.h"
#include "core/edit/stack/edit.h"
#include "core/file/json_fields.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

SelectionShape selectionOfTwo() {
  const std::vector<SelectionPart> parts = {
      {{EllipseShape{60, 50, 20, 10, 2}, false}, SelectionPart::Combine::Add},
      {{ShadowShape{"key", false, 0, 0}, true}, SelectionPart::Combine::Subtract}};
  return {std::make_shared<const std::vector<SelectionPart>>(parts), 3};
}

EditStack everyKind() {
  Painting painting(200, 100);
  Stroke stroke;
  stroke.radius = 12.5f;
  stroke.erase = true;
  stroke.points = {{10, 20, .3f}, {40, 25, 1}};
  painting.begin(stroke);
  const std::vector<Operation> operations = {
      FillOperation{.25f},
      GainOperation{1.5f, -.1f},
      CurveOperation{{{0, .1f}, {.5f, .2f}, {1, 2}}},
      InvertOperation{},
      BlurOperation{17},
      SharpenOperation{5, .3f},
      BetaMapOperation{"beta.exr", "beta.key"},
      ShadowOperation{ShadowOperation::Kind::Recolor, .6f, 9, {1, .2f, .1f}},
      PlaceOperation{-120, 35.5f, 2.5f, .4f}};
  const std::vector<MaskShape> shapes = {{RectangleShape{1, 2, 3, 4, 5}, true},
                                         {EllipseShape{1.5f, 2, 3, 4, 5}, false},
                                         {PolygonShape{{{1, 2}, {30, 4}, {5, 60}}, 2}, false},
                                         {LinearGradientShape{0, 1, 2, 3}, false},
                                         {RadialGradientShape{1, 2, 3, 4}, true},
                                         {PatternShape{PatternShape::Kind::Dots, 30, 45, .3f, 1}, false},
                                         {TextShape{"EXIT \"2\"", 5, 50, 40, 1}, false},
                                         {ImageShape{"gobo.png", 1, 2, 30, 40}, false},
                                         {PaintShape{std::make_shared<const Painting>(painting)}, false},
                                         {ShadowShape{"key", true, 7, 8}, false},
                                         {SimilarShape{SimilarShape::By::Share, 4, 5, .25f, false}, false},
                                         {selectionOfTwo(), true}};
  EditStack stack;
  stack.newLights = {"sun"};
  stack.shadowThresholds = {{"key", .125f}};
  stack.shadowMarks = {{"key", {{ShadowMark::Kind::Lit, 5, 6}, {ShadowMark::Kind::Shadow, 7, 8}}}};
  stack.lampPlaces = {{"key", {-40, 30, 3, 1.5}}, {"sun", {120.5, -10, {}, {}}}};
  for (size_t i = 0; i < shapes.size(); ++i) {
    Edit edit;
    edit.name = "edit " + std::to_string(i);
    edit.on = i % 2 == 0;
    edit.opacity = std::min(1.f, .1f * static_cast<float>(i));
    edit.lights = {"key", "sun"};
    edit.energy = i % 3 ? EnergyMode::Add : EnergyMode::Redistribute;
    edit.operation = operations[i % operations.size()];
    edit.mask = {shapes[i], shapes[(i + 3) % shapes.size()]};
    stack.append(edit);
  }
  return stack;
}

TEST(EditJson, RoundTripKeepsEverything) {
  const EditStack stack = everyKind();
  const Json json = jsonFromEditStack(stack);
  const EditStack back = editStackFromJson(Json::parse(json.dump()), 200, 100);
  EXPECT_EQ(back, stack);
  EXPECT_EQ(jsonFromEditStack(back), json);
  // Replayed strokes give the same pixels.
  const auto& before = std::get<PaintShape>(stack.edits[8]->mask[0].shape).painting->mask();
  const auto& after = std::get<PaintShape>(back.edits[8]->mask[0].shape).painting->mask();
  EXPECT_TRUE(before.differences(after).empty());
}

// Files that are out there have to open, and what is written has to be read by older programs.
TEST(EditJson, WarnsOfKeysThatMasksDoNotUse) {
  Json json = jsonFromEditStack(everyKind());
  const auto warningsOf = [&] {
    std::vector<std::string> warnings;
    static_cast<void>(editStackFromJson(json, 200, 100, "a.json", &warnings));
    return warnings;
  };
  EXPECT_THAT(warningsOf(), testing::IsEmpty()) << "all that is written is read";
  for (Json& edit : json["edits"])
    for (Json& shape : edit["mask"]) {
      if (shape["shape"] == "ellipse") shape["fether"] = 3;
      if (shape.contains("parts")) shape["parts"][1]["cmobine"] = "add";
    }
  EXPECT_THAT(warningsOf(), testing::Contains(HasSubstr("\"fether\"")));
  EXPECT_THAT(warningsOf(), testing::Contains(testing::AllOf(HasSubstr("part 2"), HasSubstr("\"cmobine\""))));
}

TEST(EditJson, TheFormatIsKeptToTheByte) {
  std::ifstream file(SWAPLIGHT_TEST_DATA "/edits/every_kind.json");
  ASSERT_TRUE(file);
  std::stringstream kept;
  kept << file.rdbuf();
  EXPECT_EQ(jsonFromEditStack(everyKind()).dump(1) + "\n", kept.str());
}

TEST(EditJson, SaysWhereSomethingIsWrong) {
  const auto message = [](const char* text) {
    return test::inputError(
        [&] { (void)editStackFromJson(Json::parse(text), 10, 10, "a.swaplight: edits"); });
  };
  EXPECT_THAT(message(R"({})"), HasSubstr("edits"));
  EXPECT_THAT(message(R"({"edits": [{"operation": "fill"}, {"operation": "smudge"}]})"),
              testing::AllOf(HasSubstr("edit 2"), HasSubstr("smudge"), HasSubstr("sharpen")));
  EXPECT_THAT(message(R"({"edits": [{"operation": "fill", "opacity": 3}]})"), HasSubstr("opacity"));
  EXPECT_THAT(message(R"({"edits": [{"operation": "fill", "meaning": "steal"}]})"),
              HasSubstr("share or add"));
  EXPECT_THAT(message(R"({"edits": [{"operation": "fill", "mask": [{"shape": "blob"}]}]})"),
              testing::AllOf(HasSubstr("shape 1"), HasSubstr("ellipse")));
  EXPECT_THAT(message(R"({"edits": [], "shadow_thresholds": {"key": 7}})"),
              testing::AllOf(HasSubstr("key"), HasSubstr("between 0 and 1")));
  EXPECT_THAT(message(R"({"edits": [], "shadow_marks": {"key": [{"is": "dark", "at": [1, 2]}]}})"),
              testing::AllOf(HasSubstr("mark 1 of key"), HasSubstr("dark"), HasSubstr("shadow or lit")));
  EXPECT_THAT(message(R"({"edits": [], "shadow_marks": {"key": [{"is": "lit"}]}})"), HasSubstr("[x, y]"));
  EXPECT_THAT(message(R"({"edits": [], "shadow_marks": {"key": [{"is": "lit", "at": [-1, 2]}]}})"),
              HasSubstr("pixel of the picture"));
  EXPECT_THAT(message(R"({"edits": [], "shadow_marks": {"key": 3}})"), HasSubstr("list of marks"));
  EXPECT_THAT(message(R"({"edits": [], "shadow_marks": 3})"), HasSubstr("by light"));
  EXPECT_THAT(message(R"({"edits": [], "lamp_places": 3})"), HasSubstr("places by light"));
  EXPECT_THAT(message(R"({"edits": [], "lamp_places": {"key": {"azimuth": 3}}})"),
              HasSubstr("\"elevation\""));
  EXPECT_THAT(message(R"({"edits": [], "lamp_places": {"key": {"azimuth": 300, "elevation": 0}}})"),
              HasSubstr("lamp_places of \"key\""));
  for (const char* shape : {"similar", "shadow"})
    for (const char* at : {"[1e39, 2]", "[3, -1e9]"})
      EXPECT_THAT(
          message(
              fmt::format(R"({{"edits": [{{"operation": "fill", "mask": [{{"shape": "{}", "at": {}}}]}}]}})",
                          shape, at)
                  .c_str()),
          HasSubstr("pixel of the picture"));
  EXPECT_THAT(message(R"({"edits": [{"operation": "curve", "points": [[0, 1], 3]}]})"), HasSubstr("[x, y]"));
  EXPECT_THAT(
      message(
          R"({"edits": [{"operation": "fill", "mask": [{"shape": "painted", "strokes": [{"points": [1]}]}]}]})"),
      HasSubstr("stroke 1"));
}

// What the studio's menu and its controls are made from.
TEST(EditJson, EveryEditDescribesItself) {
  std::set<std::string> names;
  forEachOperation([&]<typename T>(const T& operation) {
    SCOPED_TRACE(T::info.name);
    EXPECT_TRUE(names.insert(T::info.name).second) << "two edits of one name";
    EXPECT_TRUE(!T::info.inMenu || *T::info.tip);
    Json json = Json::object();
    writeOperation(operation, json);
    JsonFields fields(json, "test");
    EXPECT_EQ(readOperation(fields), Operation(operation)) << json.dump();
    forEachField(operation, [](const auto& field, const auto& /*value*/) {
      EXPECT_LE(field.scale.least, field.scale.sliderLeast) << field.key;
      EXPECT_GE(field.scale.most, field.scale.sliderMost) << field.key;
      EXPECT_EQ(field.titles.size(), field.choices.size()) << field.key;
    });
  });
  EXPECT_EQ(names.size(), std::variant_size_v<Operation>);
}

TEST(EditJson, NumbersOutOfAFieldsRangeAreRefused) {
  const auto message = [](const char* text) {
    return test::inputError(
        [&] { (void)editStackFromJson(Json::parse(text), 10, 10, "a.swaplight: edits"); });
  };
  EXPECT_THAT(message(R"({"edits": [{"operation": "blur", "radius": 257}]})"), HasSubstr("radius"));
  EXPECT_THAT(message(R"({"edits": [{"operation": "gain", "gain": -1}]})"), HasSubstr("gain"));
  EXPECT_THAT(message(R"({"edits": [{"operation": "shadow", "kind": "remove"}]})"),
              testing::AllOf(HasSubstr("remove"), HasSubstr("lighten")));
}

}  // namespace
}  // namespace swaplight
