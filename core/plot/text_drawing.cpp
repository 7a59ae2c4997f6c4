#include "core/plot/text_drawing.h"

#include <filesystem>
#include <mutex>
#include <opencv2/freetype.hpp>
#include <opencv2/imgproc.hpp>

namespace swaplight {
namespace {

constexpr const char* kFontFiles[] = {"/usr/share/fonts/opentype/inter/Inter-Regular.otf",
                                      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"};
constexpr int kStrokes = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kStrokesHeight = 30;  // of a line at scale 1

// FreeType's state is one object, used by one thread at a time.
std::mutex& fontMutex() {
  static std::mutex mutex;
  return mutex;
}

cv::freetype::FreeType2* font() {
  static const cv::Ptr<cv::freetype::FreeType2> loaded = [] {
    for (const char* file : kFontFiles)
      if (std::filesystem::exists(file)) {
        auto made = cv::freetype::createFreeType2();
        made->loadFontData(file, 0);
        return made;
      }
    return cv::Ptr<cv::freetype::FreeType2>();
  }();
  return loaded.get();
}

}  // namespace

void drawText(cv::Mat& image, const std::string& text, cv::Point leftBaseline, int height,
              const cv::Scalar& color) {
  if (text.empty()) return;
  const std::lock_guard lock(fontMutex());
  if (auto* face = font())
    face->putText(image, text, leftBaseline, height, color, -1, cv::LINE_AA, true);
  else
    cv::putText(image, text, leftBaseline, kStrokes, height / kStrokesHeight, color, 1, cv::LINE_AA);
}

cv::Size textSize(const std::string& text, int height) {
  if (text.empty()) return {};
  const std::lock_guard lock(fontMutex());
  int baseline = 0;
  if (auto* face = font()) return face->getTextSize(text, height, -1, &baseline);
  return cv::getTextSize(text, kStrokes, height / kStrokesHeight, 1, &baseline);
}

}  // namespace swaplight
