#include "core/shadow/numeric/poisson.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace swaplight {
namespace {

constexpr float kLeastWeight = 1e-3f;  // keeps every pixel connected
constexpr int kCoarsest = 24;          // pixels: smaller pictures are solved from their mean

// Minus the divergence of the gradients.
cv::Mat divergence(const cv::Mat& gx, const cv::Mat& gy, cv::Size size) {
  cv::Mat d(size, CV_64F, cv::Scalar(0));
  for (int y = 0; y < gx.rows; ++y)
    for (int x = 0; x < gx.cols; ++x) {
      if (x + 1 < gx.cols) {
        d.at<double>(y, x) += gx.at<float>(y, x);
        d.at<double>(y, x + 1) -= gx.at<float>(y, x);
      }
      if (y + 1 < gx.rows) {
        d.at<double>(y, x) += gy.at<float>(y, x);
        d.at<double>(y + 1, x) -= gy.at<float>(y, x);
      }
    }
  return d;
}

// Where the solver starts: the solution of half the size. Parts that the guide all but cuts off would take it
// very many steps to reach from elsewhere.
cv::Mat startOf(const cv::Mat& values, const cv::Mat& fixed, const cv::Mat& guide, float edge) {
  if (std::min(values.cols, values.rows) < 2 * kCoarsest)
    return {values.size(), CV_32F, cv::Scalar(cv::mean(values, fixed)[0])};
  const cv::Size half((values.cols + 1) / 2, (values.rows + 1) / 2);
  cv::Mat weight, weighted, smallGuide;
  fixed.convertTo(weight, CV_32F, 1 / 255.);
  cv::resize(values.mul(weight), weighted, half, 0, 0, cv::INTER_AREA);
  cv::resize(weight, weight, half, 0, 0, cv::INTER_AREA);
  cv::resize(guide, smallGuide, half, 0, 0, cv::INTER_AREA);
  const cv::Mat known = weight > .25;
  cv::Mat small;
  cv::divide(weighted, cv::max(weight, 1e-6), small);
  cv::Mat start;
  cv::resize(fillSmoothly(small, known, smallGuide, edge), start, values.size(), 0, 0, cv::INTER_LINEAR);
  return start;
}

}  // namespace

cv::Mat integrateGradients(const cv::Mat& gx, const cv::Mat& gy) {
  // OpenCV's cosine transform wants even sizes: a padded column or row has no gradient towards its neighbour.
  const cv::Size size(gx.cols + gx.cols % 2, gx.rows + gx.rows % 2);
  cv::Mat d = divergence(gx, gy, size);
  cv::dct(d, d);
  std::vector<double> across(static_cast<size_t>(size.width));
  for (int x = 0; x < size.width; ++x)
    across[static_cast<size_t>(x)] = 2 * std::cos(std::numbers::pi * x / size.width) - 2;
  for (int y = 0; y < size.height; ++y) {
    const double down = 2 * std::cos(std::numbers::pi * y / size.height) - 2;
    auto* row = d.ptr<double>(y);
    for (int x = 0; x < size.width; ++x) {
      const double laplacian = across[static_cast<size_t>(x)] + down;
      row[x] = laplacian < 0 ? row[x] / laplacian : 0;
    }
  }
  cv::idct(d, d);
  cv::Mat result;
  d(cv::Rect(0, 0, gx.cols, gx.rows)).convertTo(result, CV_32F);
  return result;
}

cv::Mat fillSmoothly(const cv::Mat& values, const cv::Mat& fixed, const cv::Mat& guide, float edge) {
  cv::Mat index(values.size(), CV_32S, cv::Scalar(-1));
  int count = 0;
  for (int y = 0; y < values.rows; ++y)
    for (int x = 0; x < values.cols; ++x)
      if (!fixed.at<uchar>(y, x)) index.at<int>(y, x) = count++;
  cv::Mat filled = values.clone();
  if (count == 0 || cv::countNonZero(fixed) == 0) return filled;

  // One equation a free pixel: its links, and what its fixed neighbours pull towards.
  std::vector<Eigen::Triplet<float>> entries;
  entries.reserve(static_cast<size_t>(count) * 5);
  Eigen::VectorXf diagonal = Eigen::VectorXf::Zero(count);
  Eigen::VectorXf pull = Eigen::VectorXf::Zero(count);
  const auto link = [&](int y, int x, int y2, int x2) {
    const cv::Vec3f apart = guide.at<cv::Vec3f>(y, x) - guide.at<cv::Vec3f>(y2, x2);
    const float step2 = apart.dot(apart) / (3 * edge * edge);
    const float w = 1 / (1 + step2 * step2) + kLeastWeight;
    const int a = index.at<int>(y, x);
    const int b = index.at<int>(y2, x2);
    if (a >= 0) diagonal[a] += w;
    if (b >= 0) diagonal[b] += w;
    if (a >= 0 && b >= 0) {
      entries.emplace_back(a, b, -w);
      entries.emplace_back(b, a, -w);
    } else if (a >= 0) {
      pull[a] += w * values.at<float>(y2, x2);
    } else if (b >= 0) {
      pull[b] += w * values.at<float>(y, x);
    }
  };
  for (int y = 0; y < values.rows; ++y)
    for (int x = 0; x < values.cols; ++x) {
      if (x + 1 < values.cols) link(y, x, y, x + 1);
      if (y + 1 < values.rows) link(y, x, y + 1, x);
    }
  for (int i = 0; i < count; ++i) entries.emplace_back(i, i, diagonal[i]);
  Eigen::SparseMatrix<float, Eigen::RowMajor> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<float, Eigen::RowMajor>, Eigen::Lower | Eigen::Upper> solver(
      matrix);
  solver.setTolerance(1e-6f);
  solver.setMaxIterations(1000);
  const cv::Mat start = startOf(values, fixed, guide, edge);
  Eigen::VectorXf guess(count);
  for (int y = 0; y < values.rows; ++y)
    for (int x = 0; x < values.cols; ++x)
      if (const int i = index.at<int>(y, x); i >= 0) guess[i] = start.at<float>(y, x);
  const Eigen::VectorXf solution = solver.solveWithGuess(pull, guess);
  for (int y = 0; y < values.rows; ++y)
    for (int x = 0; x < values.cols; ++x)
      if (const int i = index.at<int>(y, x); i >= 0) filled.at<float>(y, x) = solution[i];
  return filled;
}

}  // namespace swaplight
