#include "core/edit/stack/edit_file.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_file.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

TEST(EditFile, EditsComeBackAsTheyWereWritten) {
  const test::TemporaryFolder folder;
  EditStack stack;
  Edit edit;
  edit.name = "less spread";
  edit.lights = {"key"};
  edit.operation = CurveOperation{{{0, 0}, {.5f, .2f}, {1, 1}}};
  edit.mask = {{EllipseShape{10, 12, 5, 6, 2}, false}};
  stack.append(edit);
  writeEdits(stack, folder.path() / "edits.json");
  EXPECT_TRUE(readEdits(folder.path() / "edits.json", 32, 32) == stack);
}

TEST(EditFile, FilesAreNamedFromWhereItLies) {
  const test::TemporaryFolder folder;
  EditStack stack;
  Edit edit;
  edit.operation = BetaMapOperation{"beta.exr", ""};
  stack.append(edit);
  writeEdits(stack, folder.path() / "edits.json");
  const EditStack read = readEdits(folder.path() / "edits.json", 32, 32);
  EXPECT_EQ(std::get<BetaMapOperation>(read.edits[0]->operation).file, (folder.path() / "beta.exr").string());
}

TEST(EditFile, AnotherFileIsRefusedByName) {
  const test::TemporaryFolder folder;
  writeJson({{"format", "swaplight-rig"}}, folder.path() / "rig.json");
  EXPECT_THROW(static_cast<void>(readEdits(folder.path() / "rig.json", 32, 32)), InputError);
  writeJson({{"format", "swaplight-edits"}, {"version", 9}}, folder.path() / "new.json");
  EXPECT_THROW(static_cast<void>(readEdits(folder.path() / "new.json", 32, 32)), InputError);
  writeJson({{"format", "swaplight-edits"}, {"version", 4294967297}, {"edits", Json::array()}},
            folder.path() / "newest.json");
  EXPECT_THROW(static_cast<void>(readEdits(folder.path() / "newest.json", 32, 32)), InputError);
}

}  // namespace
}  // namespace swaplight
