#include "core/illumination/local_fit.h"

#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"
#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

// Weighted means under the window.
class WindowMean {
 public:
  WindowMean(const cv::Mat& weight, double sigma) : m_weight(weight), m_sigma(sigma) {
    cv::GaussianBlur(weight, m_sum, {}, sigma, 0, cv::BORDER_REPLICATE);
    m_sum = cv::max(m_sum, 1e-9);
  }
  [[nodiscard]] cv::Mat of(const cv::Mat& x) const {
    cv::Mat mean;
    cv::GaussianBlur(x.mul(m_weight), mean, {}, m_sigma, 0, cv::BORDER_REPLICATE);
    return mean / m_sum;
  }

 private:
  cv::Mat m_weight, m_sum;
  double m_sigma;
};

// Covariances of the guides with each other and with the target, and the means.
struct Moments {
  std::vector<cv::Mat> means;
  std::vector<std::vector<cv::Mat>> among;  // [i][j], j <= i
  std::vector<cv::Mat> withTarget;
  cv::Mat targetMean;
};

Moments momentsOf(const cv::Mat& target, std::span<const FitGuide> guides, const WindowMean& window) {
  Moments m;
  m.targetMean = window.of(target);
  const size_t count = guides.size();
  m.means.resize(count);
  m.among.resize(count);
  m.withTarget.resize(count);
  parallelEach(static_cast<int>(count), [&](int k) {
    m.means[static_cast<size_t>(k)] = window.of(guides[static_cast<size_t>(k)].values);
  });
  parallelEach(static_cast<int>(count), [&](int index) {
    const auto i = static_cast<size_t>(index);
    for (size_t j = 0; j <= i; ++j)
      m.among[i].push_back(window.of(guides[i].values.mul(guides[j].values)) - m.means[i].mul(m.means[j]));
    m.withTarget[i] = window.of(guides[i].values.mul(target)) - m.means[i].mul(m.targetMean);
  });
  return m;
}

void solveRow(const Moments& m, std::span<const FitGuide> guides, int y, LocalFit& fit) {
  const auto count = static_cast<Eigen::Index>(guides.size());
  Eigen::MatrixXd a(count, count);
  Eigen::MatrixXd b(count, 1);
  for (int x = 0; x < fit.offset.cols; ++x) {
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto row = static_cast<size_t>(i);
      for (Eigen::Index j = 0; j <= i; ++j)
        a(i, j) = a(j, i) = m.among[row][static_cast<size_t>(j)].at<float>(y, x);
      a(i, i) += guides[row].ridge;
      b(i, 0) = m.withTarget[row].at<float>(y, x);
    }
    const Eigen::MatrixXd slopes = solveSymmetric(a, b);
    double offset = m.targetMean.at<float>(y, x);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto k = static_cast<size_t>(i);
      fit.slopes[k].at<float>(y, x) = static_cast<float>(slopes(i, 0));
      offset -= slopes(i, 0) * m.means[k].at<float>(y, x);
    }
    fit.offset.at<float>(y, x) = static_cast<float>(offset);
  }
}

}  // namespace

LocalFit fitLocally(const cv::Mat& target, std::span<const FitGuide> guides, const cv::Mat& weight,
                    double sigma) {
  const WindowMean window(weight, sigma);
  const Moments moments = momentsOf(target, guides, window);
  LocalFit fit;
  fit.offset = cv::Mat(target.size(), CV_32F);
  for (size_t k = 0; k < guides.size(); ++k) fit.slopes.emplace_back(target.size(), CV_32F);
  parallelRows(target.rows, 8, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) solveRow(moments, guides, y, fit);
  });
  fit.offset = window.of(fit.offset);
  for (cv::Mat& slope : fit.slopes) slope = window.of(slope);
  return fit;
}

}  // namespace swaplight
