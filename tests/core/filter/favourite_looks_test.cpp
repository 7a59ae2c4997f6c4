#include "core/filter/favourite_looks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Names = std::vector<std::string>;

TEST(FavouriteLooks, AreTheSceneTypesUntilSomebodyChooses) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "data/favourites.json";
  EXPECT_EQ(readFavouriteLooks(file), sceneTypes());
  writeFavouriteLooks(withFavourite(withoutFavourite(sceneTypes(), "snow"), "My look"), file);
  const Names names = readFavouriteLooks(file);
  EXPECT_EQ(names.size(), sceneTypes().size());
  EXPECT_EQ(names[0], "My look");
  EXPECT_EQ(names[1], "Indoor");
  writeFavouriteLooks({}, file);
  EXPECT_THAT(readFavouriteLooks(file), ElementsAre()) << "nobody wants any: that is a choice too";
}

TEST(FavouriteLooks, NamesAreAlikeWhateverTheirCaseAndDashes) {
  const Names names = {"Magic hour"};
  EXPECT_TRUE(isFavourite(names, "magic-hour"));
  EXPECT_FALSE(isFavourite(names, "magic"));
  EXPECT_EQ(withFavourite(names, "MAGIC_HOUR"), names);
  EXPECT_THAT(withoutFavourite(names, "magic hour"), ElementsAre());
}

TEST(FavouriteLooks, BadFilesAreOneLine) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "favourites.json";
  const auto error = [&](const std::string& text) {
    test::writeBytes(file, text);
    return test::inputError([&] { static_cast<void>(readFavouriteLooks(file)); });
  };
  EXPECT_THAT(error("{"), HasSubstr("favourites.json"));
  EXPECT_THAT(error("[]"), HasSubstr("favourites.json"));
  EXPECT_THAT(error(R"({"format": "x"})"), HasSubstr("remove the file"));
  EXPECT_THAT(error(R"({"format": "swaplight-favourite-looks", "version": 2})"), HasSubstr("newer version"));
  EXPECT_THAT(error(R"({"format": "swaplight-favourite-looks"})"), HasSubstr("camera_looks"));
  EXPECT_THAT(error(R"({"format": "swaplight-favourite-looks", "camera_looks": [3]})"),
              HasSubstr("expected names"));
}

}  // namespace
}  // namespace swaplight
