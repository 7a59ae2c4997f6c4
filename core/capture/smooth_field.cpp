#include "core/capture/smooth_field.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/core.hpp>
#include <span>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/color/chromaticity.h"

namespace swaplight {
namespace {

constexpr int kBlocksAcross = 48;    // of the picture's larger side
constexpr double kLeastUsed = 0.25;  // of the blocks: a smaller part does not say what the rest is
constexpr float kDarkMean = 2e-3F;   // of full scale: darker blocks are noise and black level
constexpr int kRobustRounds = 6;
constexpr double kTukey = 4.685;  // 95 % efficient for normal errors
constexpr double kNormalMad = 1.4826;
constexpr float kLeastFactor = 1e-3F;  // ten stops: what is divided stays a number
constexpr int kFieldRows = 64;
constexpr int kSearch = 33;  // places a side among which the brightest is looked for

using FieldTerms = std::array<double, SmoothField::kTerms>;

FieldTerms fieldTerms(double x, double y) {
  FieldTerms terms;
  size_t next = 0;
  for (int sum = 0; sum <= SmoothField::kDegree; ++sum)
    for (int i = sum; i >= 0; --i) terms[next++] = std::pow(x, i) * std::pow(y, sum - i);
  return terms;
}

/// The mean of a part of the picture.
struct FieldBlock {
  double x = 0, y = 0;  ///< -1..1
  Rgb mean;
};

std::vector<FieldBlock> blocksOf(const Image& flat) {
  const int side = std::max(1, std::max(flat.width(), flat.height()) / kBlocksAcross);
  std::vector<FieldBlock> blocks;
  for (int top = 0; top + side <= flat.height(); top += side)
    for (int left = 0; left + side <= flat.width(); left += side) {
      FieldBlock block{(2.0 * left + side) / flat.width() - 1, (2.0 * top + side) / flat.height() - 1,
                       Rgb(0)};
      bool usable = true;
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int y = top; y < top + side; ++y)
          for (int x = left; x < left + side; ++x) {
            const float value = flat.view().at(c, x, y);
            usable = usable && std::isfinite(value);
            sum += value;
          }
        block.mean[c] = static_cast<float>(sum / side / side);
      }
      if (usable && luminance(block.mean) > kDarkMean) blocks.push_back(block);
    }
  const double all = double(flat.height() / side) * double(flat.width() / side);
  if (double(blocks.size()) < kLeastUsed * all) blocks.clear();
  return blocks;
}

std::vector<FieldBlock> blocksFor(const Image& flat, const std::string& where) {
  std::vector<FieldBlock> blocks = blocksOf(flat);
  if (blocks.size() < 2 * SmoothField::kTerms)
    throw InputError(
        "{}: most of it is clipped, black or broken: photograph an even grey surface that fills the picture, "
        "well exposed",
        where);
  return blocks;
}

double valueOf(const FieldTerms& coefficients, const FieldTerms& terms) {
  return std::inner_product(terms.begin(), terms.end(), coefficients.begin(), 0.0);
}

/// Least squares with a weight for each block.
FieldTerms weightedTerms(const std::vector<FieldTerms>& rows, const std::vector<double>& values,
                         const std::vector<double>& weights) {
  constexpr int kTerms = SmoothField::kTerms;
  cv::Mat a = cv::Mat::zeros(kTerms, kTerms, CV_64F), b = cv::Mat::zeros(kTerms, 1, CV_64F), found;
  for (size_t k = 0; k < rows.size(); ++k)
    for (int i = 0; i < kTerms; ++i) {
      const double weighted = weights[k] * rows[k][static_cast<size_t>(i)];
      for (int j = 0; j < kTerms; ++j) a.at<double>(i, j) += weighted * rows[k][static_cast<size_t>(j)];
      b.at<double>(i) += weighted * values[k];
    }
  cv::solve(a, b, found, cv::DECOMP_SVD);
  FieldTerms result;
  std::copy_n(found.ptr<double>(), kTerms, result.begin());
  return result;
}

/// The terms through the blocks' values, and the blocks' median distance from them.
FieldTerms robustTerms(const std::vector<FieldBlock>& blocks, const std::vector<double>& values,
                       double& misfit) {
  std::vector<FieldTerms> rows;
  for (const FieldBlock& block : blocks) rows.push_back(fieldTerms(block.x, block.y));
  std::vector<double> weights(values.size(), 1), distances(values.size());
  FieldTerms result{};
  for (int round = 0; round < kRobustRounds; ++round) {
    result = weightedTerms(rows, values, weights);
    for (size_t j = 0; j < rows.size(); ++j) distances[j] = std::abs(values[j] - valueOf(result, rows[j]));
    std::vector<double> ordered = distances;
    misfit = median(std::span(ordered));
    const double reach = kTukey * kNormalMad * std::max(misfit, 1e-6);
    for (size_t j = 0; j < rows.size(); ++j)
      weights[j] = distances[j] < reach ? std::pow(1 - std::pow(distances[j] / reach, 2), 2) : 0;
  }
  return result;
}

}  // namespace

double SmoothField::at(int channel, double x, double y) const {
  return std::exp(valueOf(m_terms[static_cast<size_t>(channel)], fieldTerms(m_across.at(x), m_down.at(y))));
}

void SmoothField::row(int channel, int y, int width, int height, float* out) const {
  const FieldTerms& terms = m_terms[static_cast<size_t>(channel)];
  const double down = m_down.at((2.0 * y + 1) / height - 1);
  std::array<double, kDegree + 1> powers{};  // of x
  size_t next = 0;
  for (int sum = 0; sum <= kDegree; ++sum)
    for (int i = sum; i >= 0; --i) powers[static_cast<size_t>(i)] += terms[next++] * std::pow(down, sum - i);
  for (int column = 0; column < width; ++column) {
    const double x = m_across.at((2.0 * column + 1) / width - 1);
    double value = powers[kDegree];
    for (int i = kDegree - 1; i >= 0; --i) value = value * x + powers[static_cast<size_t>(i)];
    out[column] = static_cast<float>(std::exp(value));
  }
}

SmoothField SmoothField::within(const PixelRect& part, int width, int height) const {
  SmoothField field = *this;
  field.m_across = m_across.part(part.x, part.width, width);
  field.m_down = m_down.part(part.y, part.height, height);
  return field;
}

void SmoothField::takeFrom(Image& image) const {
  parallelRows(image.height(), kFieldRows, [&](int begin, int end) {
    std::vector<float> factor(static_cast<size_t>(image.width()));
    for (int c = 0; c < 3; ++c)
      for (int y = begin; y < end; ++y) {
        row(c, y, image.width(), image.height(), factor.data());
        float* values = image.span().row(c, y);
        for (size_t x = 0; x < factor.size(); ++x) values[x] /= std::max(factor[x], kLeastFactor);
      }
  });
}

FieldFit colorFieldOf(const Image& flat, const std::string& where) {
  const std::vector<FieldBlock> blocks = blocksFor(flat, where);
  std::array<FieldTerms, 3> terms{};
  FieldFit fit;
  for (int c = 0; c < 3; ++c) {
    std::vector<double> values;
    size_t dark = 0;
    for (const FieldBlock& block : blocks) {
      dark += block.mean[c] > kDarkMean ? 0 : 1;
      values.push_back(std::log(std::max(block.mean[c], kDarkMean) / luminance(block.mean)));
    }
    if (2 * dark > blocks.size()) continue;
    double misfit = 0, mean = 0;
    FieldTerms& found = terms[static_cast<size_t>(c)] = robustTerms(blocks, values, misfit);
    const SmoothField field(terms);
    for (const FieldBlock& block : blocks) mean += std::log(field.at(c, block.x, block.y));
    found[0] -= mean / double(blocks.size());
    fit.misfit = std::max(fit.misfit, misfit);
  }
  fit.field = SmoothField(terms);
  return fit;
}

FieldFit levelFieldOf(const Image& flat, const std::string& where) {
  const std::vector<FieldBlock> blocks = blocksFor(flat, where);
  std::array<FieldTerms, 3> terms{};
  FieldFit fit;
  for (int c = 0; c < 3; ++c) {
    std::vector<double> values;
    for (const FieldBlock& block : blocks) values.push_back(std::log(std::max(block.mean[c], kDarkMean)));
    double misfit = 0;
    terms[static_cast<size_t>(c)] = robustTerms(blocks, values, misfit);
    fit.misfit = std::max(fit.misfit, misfit);
  }
  fit.field = SmoothField(terms);
  for (int c = 0; c < 3; ++c) {
    double brightest = 0;
    for (int j = 0; j < kSearch * kSearch; ++j)
      brightest = std::max(brightest, fit.field.at(c, 2.0 * (j % kSearch) / (kSearch - 1) - 1,
                                                   2.0 * double(j / kSearch) / (kSearch - 1) - 1));
    fit.field.shiftLevel(c, -std::log(brightest));
  }
  return fit;
}

}  // namespace swaplight
