#include "core/export/layer_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace swaplight {
namespace {

using testing::ElementsAre;

TEST(LayerNames, HighlightsStandBesideTheirLight) {
  const std::vector<std::string> layers = {"key", "fill"};
  EXPECT_THAT(highlightLayerNames(layers, '.'), ElementsAre("key.spec", "fill.spec"));
  EXPECT_THAT(highlightLayerNames(layers, '_'), ElementsAre("key_spec", "fill_spec"));
}

TEST(LayerNames, HighlightsAreNotTakenForALight) {
  const std::vector<std::string> layers = {"key", "Key_spec", "key_spec_2"};
  EXPECT_THAT(highlightLayerNames(layers, '.'),
              ElementsAre("key.spec_3", "Key_spec.spec", "key_spec_2.spec"));
  EXPECT_THAT(highlightLayerNames(layers, '_'),
              ElementsAre("key_spec_3", "Key_spec_spec", "key_spec_2_spec"));
}

}  // namespace
}  // namespace swaplight
