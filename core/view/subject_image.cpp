#include "core/view/subject_image.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/parallel.h"
#include "core/plot/color_map.h"

namespace swaplight {
namespace {

constexpr int kSteps = 256;  // of a colour map

/// A colour for every value of a plane.
template <typename Color>
Image coloured(ImageView values, int channel, const Color& color) {
  Image image(ImageSpec::rgb(values.width, values.height));
  image.setColorSpace("");
  const ImageSpan out = image.span();
  parallelRows(values.height, 16, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const float* in = values.row(channel, y);
      for (int x = 0; x < values.width; ++x) {
        const Rgb code = color(in[x]);
        for (int c = 0; c < 3; ++c) out.row(c, y)[x] = code[c];
      }
    }
  });
  return image;
}

Image mapped(ImageView values, int channel, float brightest) {
  std::array<Rgb, kSteps> colors;
  for (size_t i = 0; i < colors.size(); ++i) colors[i] = viridis(static_cast<float>(i) / (kSteps - 1));
  return coloured(values, channel, [&](float value) {
    const float at = value > 0 ? std::min(value / brightest, 1.0F) : 0;  // not a number counts as 0
    return colors[static_cast<size_t>(std::lround(at * (kSteps - 1)))];
  });
}

Image flagImage(ImageView quality) {
  return coloured(quality, kFlags, [](float value) {
    Rgb color(0.08F);
    for (const FlagColor& flag : kFlagColors)
      if ((static_cast<int>(value) & flag.flag) != 0) color = flag.color;
    return color;
  });
}

Image betaImage(const SolvedSet& set, int light) {
  Image image(ImageSpec{set.width(), set.height(), {"Y"}, ""});
  parallelRows(set.height(), 16, [&](int begin, int end) {
    const auto first = static_cast<size_t>(begin) * static_cast<size_t>(set.width());
    const auto count = static_cast<size_t>(end - begin) * static_cast<size_t>(set.width());
    std::vector<std::vector<float>> scratch(set.contributions.size(), std::vector<float>(count));
    std::vector<const float*> contributions;
    std::vector<float*> shares;
    for (size_t i = 0; i < set.contributions.size(); ++i) {
      for (int c = 0; c < 3; ++c) contributions.push_back(set.contributions[i].plane(c) + first);
      shares.push_back(static_cast<int>(i) == light ? image.plane(0) + first : scratch[i].data());
    }
    sharesOf(set.lightCount(), contributions.data(), shares.data(), count);
  });
  return image;
}

Image diffuseImage(const SolvedSet& set, size_t light) {
  Image diffuse = set.contributions.at(light).clone();
  const Image& highlight = set.highlights.at(light);
  for (int c = 0; c < 3; ++c)
    std::transform(diffuse.plane(c), diffuse.plane(c) + diffuse.pixelCount(), highlight.plane(c),
                   diffuse.plane(c), std::minus<>());
  return diffuse;
}

Image reflectanceImage(const SolvedSet& set) {
  Image sum = set.contributions.front().clone();
  parallelRows(sum.height(), 16, [&](int begin, int end) {
    const ImageSpan out = sum.span();
    for (size_t i = 1; i < set.contributions.size(); ++i)
      for (int c = 0; c < 3; ++c)
        for (int y = begin; y < end; ++y) {
          const float* in = set.contributions[i].view().row(c, y);
          std::transform(in, in + out.width, out.row(c, y), out.row(c, y), std::plus<>());
        }
  });
  return sum;
}

}  // namespace

Image subjectImage(const SolvedSet& set, const ViewSubject& subject) {
  switch (subject.kind) {
    case ViewSubject::Kind::Beta:
      return betaImage(set, subject.index);
    case ViewSubject::Kind::Reflectance:
      return reflectanceImage(set);
    case ViewSubject::Kind::Residual:
      return mapped(set.quality.view(), kResidual, kResidualShown);
    case ViewSubject::Kind::Sigma:
      return mapped(set.quality.view(), kSigma, kSigmaShown);
    case ViewSubject::Kind::Flags:
      return flagImage(set.quality.view());
    case ViewSubject::Kind::Highlight:
      return set.highlights.at(static_cast<size_t>(subject.index)).clone();
    case ViewSubject::Kind::Diffuse:
      return diffuseImage(set, static_cast<size_t>(subject.index));
    case ViewSubject::Kind::Relit:
    case ViewSubject::Kind::Contribution:
    case ViewSubject::Kind::Photograph:
    case ViewSubject::Kind::Visibility:
    case ViewSubject::Kind::Illumination:
    case ViewSubject::Kind::Lighting:
      break;
  }
  throw std::logic_error("this subject is made from other pictures");
}

bool ofHighlights(const ViewSubject& subject) {
  return subject.kind == ViewSubject::Kind::Highlight || subject.kind == ViewSubject::Kind::Diffuse;
}

ViewSubject subjectWithin(const SolvedSet& set, ViewSubject subject) {
  const bool shots = subject.kind == ViewSubject::Kind::Photograph;
  if (ofHighlights(subject) && set.highlights.empty()) return {};
  const int count = shots ? set.capture.shotCount() : set.lightCount();
  if (shots && count == 0) return {};
  subject.index = std::clamp(subject.index, 0, std::max(0, count - 1));
  return subject;
}

std::string flagWords(int flags) {
  std::string words;
  for (const FlagColor& flag : kFlagColors) {
    if ((flags & flag.flag) == 0) continue;
    if (!words.empty()) words += ", ";
    words += flag.label;
  }
  return words;
}

}  // namespace swaplight
