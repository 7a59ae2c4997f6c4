#include "core/filter/kept_filter.h"

#include <gtest/gtest.h>

#include "core/file/atomic_file.h"
#include "core/filter/filter_file.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

TEST(KeptFilter, WithoutParametersIsReadAgain) {
  const test::TemporaryFolder folder;
  writeFile(folder / "Grey.fs",
            R"(/*{"DESCRIPTION": "An even grey."}*/ void main() { gl_FragColor = vec4(0.5); })");
  ResolvedStage stage;
  stage.filter = std::make_shared<const Filter>(readFilter(folder / "Grey.fs"));
  const Filter kept = readFilter(keepFilter(stage, folder / "own"));
  EXPECT_EQ(kept.description, "An even grey.");
  EXPECT_EQ(kept.source, stage.filter->source);
  EXPECT_TRUE(kept.inputs.empty());
}

}  // namespace
}  // namespace swaplight
