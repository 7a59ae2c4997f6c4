#include "core/session/kept_pictures.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::TemporaryFolder;

SmallPicture gradient(int width, int height) {
  SmallPicture picture{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int value : {8 * x, 16 * y, 100, 255}) picture.rgba.push_back(static_cast<uint8_t>(value));
  return picture;
}

TEST(KeptPictures, WhatWasKeptOfAFileIsFoundByItsPath) {
  const TemporaryFolder folder;
  const KeptPictures pictures(folder / "pictures");
  pictures.keep("/sets/one/capture.json", gradient(16, 9));
  pictures.keep("/sets/two/capture.json", gradient(8, 8));
  const SmallPicture found =
      readSmallPicture(KeptPictures(folder / "pictures").pictureOf("/sets/./one/capture.json"));
  EXPECT_EQ(found.width, 16);
  EXPECT_EQ(found.height, 9);
  EXPECT_EQ(found.rgba, gradient(16, 9).rgba);
  EXPECT_TRUE(readSmallPicture(pictures.pictureOf("/sets/three/capture.json")).empty());
}

TEST(KeptPictures, ThoseOfOtherFilesAreRemoved) {
  const TemporaryFolder folder;
  const KeptPictures pictures(folder.path());
  for (const char* file : {"/a", "/b", "/c"}) pictures.keep(file, gradient(4, 4));
  std::ofstream(folder / "not_ours.txt") << "kept";
  pictures.keepOnly({"/b", "/d"});
  EXPECT_TRUE(readSmallPicture(pictures.pictureOf("/a")).empty());
  EXPECT_FALSE(readSmallPicture(pictures.pictureOf("/b")).empty());
  EXPECT_TRUE(readSmallPicture(pictures.pictureOf("/c")).empty());
  EXPECT_TRUE(std::filesystem::exists(folder / "not_ours.txt"));
}

TEST(KeptPictures, WhatCannotBeWrittenOrReadIsNoPicture) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "no folder";
  const KeptPictures nowhere(folder / "file");
  EXPECT_NO_THROW(nowhere.keep("/a", gradient(4, 4)));
  EXPECT_TRUE(readSmallPicture(nowhere.pictureOf("/a")).empty());
  EXPECT_TRUE(readSmallPicture(folder / "file").empty());
  EXPECT_TRUE(readSmallPicture(folder / "missing.png").empty());
}

}  // namespace
}  // namespace swaplight
