#pragma once

#include <array>
#include <vector>

#include "core/image/image.h"
#include "core/image/pixel_rect.h"

namespace swaplight {

/// A factor that changes smoothly over a picture, in each channel: the exponential of a polynomial of degree
/// 4 in x and y, which holds cos^4 of a wide lens to a thousandth. The same at every size of the picture.
class SmoothField {
 public:
  static constexpr int kDegree = 4;
  static constexpr int kTerms = (kDegree + 1) * (kDegree + 2) / 2;

  /// 1 everywhere.
  SmoothField() = default;
  /// [channel][term]: x^i y^j, i + j <= 4, in the order of fieldTerms.
  explicit SmoothField(const std::array<std::array<double, kTerms>, 3>& terms) : m_terms(terms) {}

  /// Of the pixels of a row; `out` has room for `width`.
  void row(int channel, int y, int width, int height, float* out) const;
  /// x, y from -1 (left, top edge) to 1.
  [[nodiscard]] double at(int channel, double x, double y) const;
  /// The same times e^level in a channel.
  void shiftLevel(int channel, double level) { m_terms[static_cast<size_t>(channel)][0] += level; }
  /// Divides a picture by the field; infinite values stay.
  void takeFrom(Image& image) const;
  /// The field over a part of a picture of that size: as the field of a picture that is no more than this.
  [[nodiscard]] SmoothField within(const PixelRect& part, int width, int height) const;

 private:
  /// Where the picture lies in that of the terms, whose sides are -1 and 1.
  struct Side {
    double middle = 0, half = 1;
    [[nodiscard]] double at(double place) const { return middle + half * place; }
    [[nodiscard]] Side part(int begin, int length, int size) const {
      return {at((2.0 * begin + length) / size - 1), half * length / size};
    }
  };
  Side m_across, m_down;
  std::array<std::array<double, kTerms>, 3> m_terms{};
};

/// What a flat picture shows: blocks of it, and the field through them.
struct FieldFit {
  SmoothField field;
  double misfit = 0;  ///< median distance of the blocks from it, relative
};

/// The colour of a picture of an even grey surface, place by place, over that of the mean: the luminance is
/// taken out of every block first, so that the level of the light, folds and shadows of the surface do not
/// count. A channel that is too dark to tell is 1. Robust (Tukey's biweight). Values that are not
/// numbers do not count. Throws InputError that begins with `where`: too little of the picture can be used.
[[nodiscard]] FieldFit colorFieldOf(const Image& flat, const std::string& where);

/// The same of the level, in each channel: 1 in the brightest place. What a lens takes of an even surface.
[[nodiscard]] FieldFit levelFieldOf(const Image& flat, const std::string& where);

}  // namespace swaplight
