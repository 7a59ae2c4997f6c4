#include "core/image/exr/exr_attributes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/image/io/image_io.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

/// The bytes of a picture of two channels.
std::string pictureBytes(const TemporaryFolder& folder) {
  writeImage(Image({4, 3, {"R", "key.R"}, "lin_rec709"}), folder / "whole.exr", {});
  std::ifstream in(folder / "whole.exr", std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string faultOf(const TemporaryFolder& folder, const std::string& bytes) {
  std::ofstream(folder / "damaged.exr", std::ios::binary) << bytes;
  return exrHeaderFault(folder / "damaged.exr");
}

/// Where the size of an attribute is written: after its name and type, each with the zero that ends it.
size_t sizeAt(const std::string& bytes, const std::string& name, const std::string& type) {
  const std::string words = name + '\0' + type + '\0';
  return bytes.find(words) + words.size();
}

TEST(ExrAttributes, AWholeHeaderHasNoFault) {
  const TemporaryFolder folder;
  EXPECT_EQ(faultOf(folder, pictureBytes(folder)), "");
}

// OpenEXR reads channels up to the empty name: beyond the size that is written, and from there on out of
// step.
TEST(ExrAttributes, AListOfChannelsIsAsLongAsItSays) {
  const TemporaryFolder folder;
  std::string bytes = pictureBytes(folder);
  const size_t at = sizeAt(bytes, "channels", "chlist");
  for (const int change : {-1, 1, -18}) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] + change);
    EXPECT_THAT(faultOf(folder, damaged), HasSubstr("the header's channels, of")) << change;
  }
  bytes.replace(bytes.find("key.R") + 5, 1, "x");  // no zero after its name: the list has no end there
  EXPECT_NE(faultOf(folder, bytes), "");
}

// OpenImageIO 2.4 ends the process at a type that it does not know.
TEST(ExrAttributes, AChannelIsOfAKnownType) {
  const TemporaryFolder folder;
  std::string bytes = pictureBytes(folder);
  const size_t type = sizeAt(bytes, "channels", "chlist") + 4 + 2;  // behind "R"
  bytes[type] = 3;
  EXPECT_THAT(faultOf(folder, bytes), HasSubstr("channels"));
  EXPECT_THROW((void)readImageSpec(folder / "damaged.exr"), InputError);
}

TEST(ExrAttributes, ANumberIsAsLongAsItsType) {
  const TemporaryFolder folder;
  for (const auto& [name, type] :
       {std::pair{"compression", "compression"}, {"dataWindow", "box2i"}, {"pixelAspectRatio", "float"}}) {
    std::string bytes = pictureBytes(folder);
    const size_t at = sizeAt(bytes, name, type);
    bytes.insert(at + 4, "\0", 1);
    ++bytes[at];
    EXPECT_THAT(faultOf(folder, bytes), HasSubstr(name));
  }
}

// OpenEXR asks for the lines of every part while the file is opened.
TEST(ExrAttributes, ThePixelsWindowHasSidesOfAPicture) {
  const TemporaryFolder folder;
  const std::string bytes = pictureBytes(folder);
  const size_t right = sizeAt(bytes, "dataWindow", "box2i") + 4 + 8;
  const auto withRight = [&](const std::string& number) {
    std::string changed = bytes;
    return changed.replace(right, 4, number);
  };
  EXPECT_EQ(faultOf(folder, withRight(std::string{-1, -1, 1, 0})), "");
  EXPECT_THAT(faultOf(folder, withRight(std::string{0, 0, 2, 0})), HasSubstr("131073 x 3 pixels"));
  EXPECT_THAT(faultOf(folder, withRight(std::string(4, '\xff'))), HasSubstr("0 x 3 pixels"));
}

TEST(ExrAttributes, APreviewHasThePixelsItSays) {
  const TemporaryFolder folder;
  const std::string bytes = pictureBytes(folder);
  const auto withPreview = [&](char width) {
    std::string preview("preview\0preview\0\x0c\0\0\0", 20);
    preview += std::string{width, 0, 0, 0, 1, 0, 0, 0} + "RGBA";
    return bytes.substr(0, 8) + preview + bytes.substr(8);
  };
  EXPECT_EQ(faultOf(folder, withPreview(1)), "");
  EXPECT_THAT(faultOf(folder, withPreview(2)), HasSubstr("preview"));
  EXPECT_THAT(faultOf(folder, withPreview(-1)), HasSubstr("preview"));
}

}  // namespace
}  // namespace swaplight
