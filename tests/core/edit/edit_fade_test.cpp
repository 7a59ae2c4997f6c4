#include "core/edit/stack/edit_fade.h"

#include <gtest/gtest.h>

namespace swaplight {
namespace {

Edit gainEdit(const char* light, float stops, float opacity = 1, bool on = true) {
  Edit edit;
  edit.lights = {light};
  edit.on = on;
  edit.opacity = opacity;
  edit.operation = GainOperation{stops, .5F};
  return edit;
}

EditStack stackOf(std::initializer_list<Edit> edits) {
  EditStack stack;
  for (const Edit& edit : edits) stack.append(edit);
  return stack;
}

TEST(EditFade, AtItsEndsItIsWhatThereWas) {
  const EditStack a = stackOf({gainEdit("key", 1)}), b = stackOf({gainEdit("fill", 2)});
  EXPECT_TRUE(EditFade(a, b).at(0) == a);
  EXPECT_TRUE(EditFade(a, b).at(1) == b);
}

TEST(EditFade, EditsComeGoAndChangeByTheirOpacity) {
  const EditStack a = stackOf({gainEdit("key", 1), gainEdit("back", 3, .4F)});
  const EditStack b = stackOf({gainEdit("back", 3, .8F), gainEdit("fill", 2)});
  const EditStack half = EditFade(a, b).at(.25F);
  ASSERT_EQ(half.edits.size(), 3U);
  EXPECT_FLOAT_EQ(half.edits[0]->opacity, .75F);
  EXPECT_FLOAT_EQ(half.edits[1]->opacity, .5F);
  EXPECT_FLOAT_EQ(half.edits[2]->opacity, .25F);
  EXPECT_EQ(half.edits[2]->lights.front(), "fill");
}

TEST(EditFade, OffIsWithoutOpacity) {
  const EditFade fade(stackOf({gainEdit("key", 1, .6F, false)}), stackOf({gainEdit("key", 1, .6F)}));
  ASSERT_EQ(fade.at(.5F).edits.size(), 1U);
  EXPECT_FLOAT_EQ(fade.at(.5F).edits[0]->opacity, .3F);
  EXPECT_TRUE(fade.at(.5F).edits[0]->on);
}

TEST(EditFade, WhatStaysIsTheSameObject) {
  EditStack a = stackOf({gainEdit("key", 1), gainEdit("fill", 2)});
  EditStack b = a;
  b.edits.pop_back();
  EXPECT_EQ(EditFade(a, b).at(.5F).edits[0], a.edits[0]) << "else it would be prepared anew in every frame";
}

TEST(EditFade, KeepsTheOrderOfBoth) {
  const Edit key = gainEdit("key", 1), fill = gainEdit("fill", 1), back = gainEdit("back", 1);
  const EditStack half = EditFade(stackOf({key, fill, back}), stackOf({back, key, fill})).at(.5F);
  ASSERT_EQ(half.edits.size(), 4U) << "key and fill are paired; back goes behind them and comes before";
  EXPECT_EQ(half.edits[0]->lights.front(), "back");
  EXPECT_FLOAT_EQ(half.edits[1]->opacity, 1);
  EXPECT_FLOAT_EQ(half.edits[2]->opacity, 1);
  EXPECT_EQ(half.edits[3]->lights.front(), "back");
}

TEST(EditFade, HasTheNewLightsOfBothOnItsWay) {
  EditStack a, b;
  a.newLights = {"window", "lamp"};
  b.newLights = {"lamp", "candle"};
  EXPECT_EQ(EditFade(a, b).at(.5F).newLights, (std::vector<std::string>{"window", "lamp", "candle"}));
}

}  // namespace
}  // namespace swaplight
