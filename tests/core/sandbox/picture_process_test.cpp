#include "core/image/io/picture_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <fstream>
#include <random>
#include <thread>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/image/io/image_io.h"
#include "core/image/io/picture_decoder.h"
#include "core/image/io/picture_message.h"
#include "tests/support/made_tiff.h"
#include "tests/support/temporary_folder.h"

namespace swaplight {
namespace {

#ifndef SWAPLIGHT_SANITIZE

PictureProcesses g_processes;  // before there are threads

Image noise(int width, int height, int channels) {
  ImageSpec spec{width, height, {"R", "G", "B"}, "lin_rec709"};
  for (int c = 3; c < channels; ++c) spec.channels.push_back("extra." + std::to_string(c));
  Image image(spec);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value(0, 1);
  for (int c = 0; c < channels; ++c)
    std::generate_n(image.plane(c), image.pixelCount(), [&] { return value(random); });
  return image;
}

/// All bands of a picture, as bytes.
std::string bandsOf(PictureSource& source) {
  std::string bytes;
  source.eachBand([&](const PictureBand& band, const std::byte* rows) {
    const PicturePart& part = source.contents().parts[static_cast<size_t>(band.part)];
    bytes.append(reinterpret_cast<const char*>(rows), part.rowBytes() * static_cast<size_t>(band.rows));
  });
  return bytes;
}

std::string bandsHere(const std::filesystem::path& file) {
  PictureDecoder decoder(file);
  std::vector<std::byte> rows(decoder.bandBytes());
  std::string bytes;
  while (const auto band = decoder.next(rows.data())) {
    const PicturePart& part = decoder.contents().parts[static_cast<size_t>(band->part)];
    bytes.append(reinterpret_cast<const char*>(rows.data()),
                 part.rowBytes() * static_cast<size_t>(band->rows));
  }
  return bytes;
}

WriteOptions typed(const std::string& type, const std::string& compression = {}) {
  WriteOptions options;
  options.pixelType = type;
  options.compression = compression;
  return options;
}

TEST(PictureProcess, GivesWhatDecodingHereGives) {
  const test::TemporaryFolder folder;
  const std::vector<std::pair<const char*, WriteOptions>> files = {{"a.exr", {}},
                                                                   {"piz.exr", typed("half", "piz")},
                                                                   {"none.exr", typed("float", "none")},
                                                                   {"a.png", typed("uint16")},
                                                                   {"a.tif", typed("uint8")},
                                                                   {"a.jpg", {}},
                                                                   {"a.hdr", {}}};
  for (const auto& [name, options] : files) {
    const auto file = folder / name;
    writeImage(noise(301, 211, 3), file, options);
    const auto apart = openPictureApart(file);
    ASSERT_TRUE(apart);
    EXPECT_EQ(apart->contents(), PictureDecoder(file).contents()) << name;
    EXPECT_EQ(bandsOf(*apart), bandsHere(file)) << name;
  }
}

TEST(PictureProcess, PassesManyBandsInTheirOrder) {
  const test::TemporaryFolder folder;
  const auto file = folder / "large.exr";
  const Image image = noise(2000, 1500, 8);
  writeImage(image, file, typed("float"));
  const ImageFile read = readImage(file);
  for (int c = 0; c < 8; ++c)
    EXPECT_EQ(std::memcmp(read.image.plane(c), image.plane(c), 4 * image.pixelCount()), 0) << c;
}

TEST(PictureProcess, SaysTheSameErrors) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "cut.png") << "\x89PNG\r\n\x1a\nxx";
  for (const char* name : {"cut.png", "missing.exr"}) {
    std::string here, apart;
    try {
      const PictureDecoder decoder(folder / name);
    } catch (const InputError& error) {
      here = error.what();
    }
    try {
      static_cast<void>(readImage(folder / name));
    } catch (const InputError& error) {
      apart = error.what();
    }
    EXPECT_FALSE(here.empty());
    EXPECT_EQ(apart, here);
  }
}

TEST(PictureProcess, APictureThatCrashesItsDecoderIsALine) {
  const test::TemporaryFolder folder;
  const auto file = folder / "crash.tif";
  test::writeCrashingTiff(file);
  try {
    static_cast<void>(readImage(file));
    FAIL() << "it was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(file.string()));
    EXPECT_THAT(error.what(), testing::HasSubstr("crashed its decoder"));
  }
  writeImage(noise(10, 10, 3), folder / "good.png");
  EXPECT_EQ(readImage(folder / "good.png").image.width(), 10);
}

TEST(PictureProcess, CanBeLeftInTheMiddle) {
  const test::TemporaryFolder folder;
  const auto file = folder / "large.exr";
  writeImage(noise(2000, 1500, 8), file, typed("float"));
  for (int i = 0; i < 3; ++i) {
    const auto apart = openPictureApart(file);
    EXPECT_THROW(apart->eachBand([](const PictureBand&, const std::byte*) { throw Stopped(); }), Stopped);
  }
  EXPECT_EQ(readImage(file).image.width(), 2000);
}

TEST(PictureProcess, SeveralThreadsReadAtOnce) {
  const test::TemporaryFolder folder;
  const auto file = folder / "a.exr";
  writeImage(noise(200, 200, 3), file);
  std::atomic<int> good{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 4; ++k) good += readImage(file).image.width() == 200;
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(good, 32);
}

TEST(PictureMessage, DamagedMessagesAreRefused) {
  const test::TemporaryFolder folder;
  const auto file = folder / "a.exr";
  writeImage(noise(64, 48, 4), file);
  PictureDecoder decoder(file);
  const std::string whole = messageOf(PictureAnswer{decoder.contents(), decoder.bandBytes()});
  EXPECT_EQ(pictureAnswerOf(whole, "a").contents, decoder.contents());
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string damaged = whole;
    for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
    try {
      const PictureAnswer answer = pictureAnswerOf(damaged, "a");
      size_t channels = 0;
      for (const PicturePart& part : answer.contents.parts) channels += part.channels.size();
      EXPECT_EQ(channels, answer.contents.spec.channels.size());
    } catch (const std::exception&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 5000);
}

// Found by fuzzing: a number beyond what an int holds was converted all the same.
TEST(PictureMessage, NumbersThatNoIntHoldsAreRefused) {
  const test::TemporaryFolder folder;
  writeImage(noise(8, 6, 3), folder / "a.exr");
  PictureDecoder decoder(folder / "a.exr");
  const std::string whole = messageOf(PictureAnswer{decoder.contents(), decoder.bandBytes()});
  const auto with = [&](const char* where, const Json& number) {
    Json json = Json::from_cbor(whole);
    json.at(Json::json_pointer(where)) = number;
    std::string damaged;
    Json::to_cbor(json, damaged);
    return damaged;
  };
  EXPECT_EQ(pictureAnswerOf(with("/size/0", 8), "a").contents, decoder.contents());
  for (const char* where : {"/info/bits", "/size/0", "/size/1", "/orientation"})
    for (const char* number :
         {"1e300", "-4.2e155", "5000000000", "4294967304", "18446744073709551615", "1.5"})
      EXPECT_THROW(static_cast<void>(pictureAnswerOf(with(where, Json::parse(number)), "a")),
                   std::runtime_error)
          << where << " " << number;
}

#endif

}  // namespace
}  // namespace swaplight
