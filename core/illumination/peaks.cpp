#include "core/illumination/peaks.h"

#include <algorithm>
#include <numeric>

namespace swaplight {
namespace {

// Land that rises out of the water as it sinks: each pixel belongs to the highest peak that it hangs together
// with.
class Islands {
 public:
  explicit Islands(const cv::Mat& picture) : m_picture(picture), m_parent(picture.total(), kSea) {}

  void rise(int pixel) {
    const float level = at(pixel);
    const int x = pixel % m_picture.cols;
    const int y = pixel / m_picture.cols;
    int highest = kSea;
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, m_picture.rows - 1); ++ny)
      for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, m_picture.cols - 1); ++nx) {
        const int neighbour = ny * m_picture.cols + nx;
        if (parent(neighbour) != kSea) highest = joined(highest, rootOf(neighbour), level);
      }
    parent(pixel) = highest == kSea ? pixel : highest;
  }
  [[nodiscard]] std::vector<Peak> peaks(int highest, float lowest) {
    drown(highest, lowest);
    return std::move(m_peaks);
  }

 private:
  static constexpr int kSea = -1;

  int& parent(int pixel) { return m_parent[static_cast<size_t>(pixel)]; }
  [[nodiscard]] float at(int pixel) const {
    return m_picture.at<float>(pixel / m_picture.cols, pixel % m_picture.cols);
  }
  int rootOf(int pixel) {
    while (parent(pixel) != pixel) pixel = parent(pixel) = parent(parent(pixel));
    return pixel;
  }
  int joined(int a, int b, float level) {
    if (a == kSea || a == b) return b;
    const int low = at(a) < at(b) ? a : b;
    const int high = low == a ? b : a;
    drown(low, level);
    return parent(low) = high;
  }
  void drown(int peak, float level) {
    m_peaks.push_back({peak % m_picture.cols, peak / m_picture.cols, double{at(peak)} - level});
  }

  const cv::Mat& m_picture;
  std::vector<int> m_parent;
  std::vector<Peak> m_peaks;
};

}  // namespace

std::vector<Peak> peaksOf(const cv::Mat& picture) {
  std::vector<int> order(picture.total());
  if (order.empty()) return {};
  std::iota(order.begin(), order.end(), 0);
  const cv::Mat values = picture.isContinuous() ? picture : picture.clone();
  const auto* level = values.ptr<float>();
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return level[a] > level[b]; });
  Islands islands(values);
  for (const int pixel : order) islands.rise(pixel);
  std::vector<Peak> peaks = islands.peaks(order.front(), level[order.back()]);
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const Peak& a, const Peak& b) { return a.prominence > b.prominence; });
  return peaks;
}

}  // namespace swaplight
