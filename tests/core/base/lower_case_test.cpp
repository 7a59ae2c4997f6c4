#include "core/base/lower_case.h"

#include <gtest/gtest.h>

namespace swaplight {
namespace {

TEST(LowerCase, ChangesLettersOfAsciiOnly) {
  EXPECT_EQ(lowerCase("Key-1 AZ az"), "key-1 az az");
  EXPECT_EQ(lowerCase("\xc3\x84"), "\xc3\x84") << "no part of another letter";
  EXPECT_EQ(lowerCase(""), "");
}

TEST(LowerCase, OfAFilesExtension) {
  EXPECT_EQ(lowerExtension("Folder.EXR/Look.CUBE"), ".cube");
  EXPECT_EQ(lowerExtension("set.0001.Exr"), ".exr");
  EXPECT_EQ(lowerExtension("README"), "");
}

}  // namespace
}  // namespace swaplight
