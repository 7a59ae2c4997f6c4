#include "core/report/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/base/error.h"
#include "core/plot/text_drawing.h"

namespace swaplight {
namespace {

constexpr int kMargin = 32, kGutter = 24, kTitleHeight = 30, kNameHeight = 20, kNoteHeight = 16;
constexpr int kLineGap = 8;
constexpr size_t kNoteLines = 3;
constexpr int kMostColumns = 12;
constexpr double kSheetAspect = 16.0 / 9;
const cv::Scalar kGround(30, 30, 30), kInk(226, 226, 226), kQuiet(160, 160, 160);

/// Bytes to the end of the last whole character of UTF-8 before `length`.
size_t wholeCharacters(const std::string& text, size_t length) {
  while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U)
    --length;
  return length;
}

bool fits(const std::string& text, int width, int height) {
  return textSize(text, height).width <= width;
}

/// As much of it as fits, with three dots behind what is cut off.
std::string cutTo(std::string text, int width, int height) {
  if (fits(text, width, height)) return text;
  while (!text.empty() && !fits(text + "...", width, height))
    text.resize(wholeCharacters(text, text.size() - 1));
  return text + "...";
}

struct Sheet {
  int columns, rows;
  int pictureWidth, pictureHeight;  ///< the largest
  int captionHeight;

  [[nodiscard]] int width() const { return 2 * kMargin + columns * pictureWidth + (columns - 1) * kGutter; }
  [[nodiscard]] int cellHeight() const { return pictureHeight + captionHeight + kGutter; }
  [[nodiscard]] int height() const { return 2 * kMargin + 2 * kTitleHeight + rows * cellHeight(); }
  [[nodiscard]] cv::Point corner(int index) const {
    return {kMargin + index % columns * (pictureWidth + kGutter),
            kMargin + 2 * kTitleHeight + index / columns * cellHeight()};
  }
};

int ceilOf(int count, int columns) {
  return (count + columns - 1) / columns;
}

Sheet laidOut(const std::vector<GalleryPicture>& pictures, int columns) {
  Sheet sheet{columns, 0, 0, 0, 0};
  bool notes = false;
  for (const GalleryPicture& picture : pictures) {
    sheet.pictureWidth = std::max(sheet.pictureWidth, picture.codes.width());
    sheet.pictureHeight = std::max(sheet.pictureHeight, picture.codes.height());
    notes |= !picture.note.empty();
  }
  sheet.captionHeight = kNameHeight + 2 * kLineGap;
  if (notes) sheet.captionHeight += static_cast<int>(kNoteLines) * (kNoteHeight + kLineGap);
  const auto count = static_cast<int>(pictures.size());
  if (columns == 0) {
    double best = INFINITY;
    for (int tried = 1; tried <= std::min(count, kMostColumns); ++tried) {
      sheet.columns = tried;
      sheet.rows = ceilOf(count, tried);
      const double off =
          std::abs(std::log(static_cast<double>(sheet.width()) / sheet.height() / kSheetAspect));
      if (off < best) {
        best = off;
        columns = tried;
      }
    }
  }
  sheet.columns = std::min(columns, count);
  sheet.rows = ceilOf(count, sheet.columns);
  return sheet;
}

void drawPicture(cv::Mat& sheet, const Image& codes, cv::Point at) {
  for (int y = 0; y < codes.height(); ++y)
    for (int x = 0; x < codes.width(); ++x)
      for (int c = 0; c < 3; ++c)
        sheet.at<cv::Vec3b>(at.y + y, at.x + x)[c] = static_cast<uint8_t>(std::lround(
            255 * std::clamp(codes.plane(c)[static_cast<size_t>(y) * codes.width() + x], 0.F, 1.F)));
}

void drawCaption(cv::Mat& sheet, const GalleryPicture& picture, int number, cv::Point at, int width) {
  int y = at.y + kLineGap + kNameHeight;
  drawText(sheet, cutTo(std::to_string(number) + "  " + picture.name, width, kNameHeight), {at.x, y},
           kNameHeight, kInk);
  for (const std::string& line : wrappedText(picture.note, width, kNoteHeight, kNoteLines)) {
    y += kNoteHeight + kLineGap;
    drawText(sheet, line, {at.x, y}, kNoteHeight, kQuiet);
  }
}

}  // namespace

std::vector<std::string> wrappedText(const std::string& text, int width, int height, size_t most) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  std::string line, word;
  while (words >> word) {
    const std::string longer = line.empty() ? word : line + " " + word;
    if (line.empty() || fits(longer, width, height)) {
      line = longer;
      continue;
    }
    if (lines.size() + 1 == most) {
      lines.push_back(cutTo(longer, width, height));
      return lines;
    }
    lines.push_back(cutTo(line, width, height));
    line = word;
  }
  if (!line.empty()) lines.push_back(cutTo(line, width, height));
  return lines;
}

Image contactSheet(const std::vector<GalleryPicture>& pictures, const std::string& title, int columns) {
  if (pictures.empty())
    throw InputError("the gallery is empty: keep looks or versions in the studio first (Shift+K, Shift+V)");
  const Sheet sheet = laidOut(pictures, columns);
  cv::Mat drawn(sheet.height(), sheet.width(), CV_8UC3, kGround);
  drawText(drawn, cutTo(title, sheet.width() - 2 * kMargin, kTitleHeight), {kMargin, kMargin + kTitleHeight},
           kTitleHeight, kInk);
  for (size_t i = 0; i < pictures.size(); ++i) {
    const cv::Point at = sheet.corner(static_cast<int>(i));
    drawPicture(drawn, pictures[i].codes, at);
    drawCaption(drawn, pictures[i], static_cast<int>(i) + 1, {at.x, at.y + pictures[i].codes.height()},
                sheet.pictureWidth);
  }
  Image image(ImageSpec::rgb(drawn.cols, drawn.rows));
  for (int y = 0; y < drawn.rows; ++y)
    for (int x = 0; x < drawn.cols; ++x)
      for (int c = 0; c < 3; ++c)
        image.span().at(c, x, y) = static_cast<float>(drawn.at<cv::Vec3b>(y, x)[c]) / 255;
  image.setColorSpace("srgb");
  return image;
}

}  // namespace swaplight
