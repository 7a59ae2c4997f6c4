#include "core/export/still_tone.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/photo.hpp>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace swaplight {
namespace {

struct Parameter {
  std::string_view name;
  float StillTone::*value;
  float low, high;
};

struct Mapping {
  std::string_view name;
  StillTone::Operator mapping;
  std::vector<Parameter> parameters;
};

const std::vector<Mapping>& mappings() {
  using Operator = StillTone::Operator;
  static const std::vector<Mapping> all = {
      {"drago",
       Operator::Drago,
       {{"bias", &StillTone::bias, 0.5F, 1}, {"saturation", &StillTone::saturation, 0, 2}}},
      {"mantiuk",
       Operator::Mantiuk,
       {{"scale", &StillTone::scale, 0.1F, 1}, {"saturation", &StillTone::saturation, 0, 2}}},
      {"reinhard",
       Operator::Reinhard,
       {{"intensity", &StillTone::intensity, -8, 8},
        {"adapt", &StillTone::adapt, 0, 1},
        {"color_adapt", &StillTone::colorAdapt, 0, 1}}}};
  return all;
}

template <typename List>
std::string namesOf(const List& list) {
  std::vector<std::string_view> names;
  names.reserve(list.size());
  for (const auto& entry : list) names.push_back(entry.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void setParameter(StillTone& tone, const Mapping& mapping, std::string_view text) {
  const size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = text.substr(0, equals);
  const auto known = std::find_if(mapping.parameters.begin(), mapping.parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  if (known == mapping.parameters.end())
    throw InputError("the tone mapping {} has no parameter '{}'; it has {}", mapping.name, name,
                     namesOf(mapping.parameters));
  const std::string_view number = text.substr(std::min(equals + 1, text.size()));
  float value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  const bool right = error == std::errc() && end == number.data() + number.size() && value >= known->low &&
                     value <= known->high;
  if (!right)
    throw InputError("{} '{}' is not right: give a number from {} to {}, as {}={}", known->name, number,
                     known->low, known->high, known->name, tone.*known->value);
  tone.*known->value = value;
}

cv::Ptr<cv::Tonemap> operatorOf(const StillTone& tone) {
  constexpr float kLinear = 1;  // no gamma: the display's encoding comes later
  switch (tone.mapping) {
    case StillTone::Operator::Drago:
      return cv::createTonemapDrago(kLinear, tone.saturation, tone.bias);
    case StillTone::Operator::Mantiuk:
      return cv::createTonemapMantiuk(kLinear, tone.scale, tone.saturation);
    case StillTone::Operator::Reinhard:
      break;
  }
  return cv::createTonemapReinhard(kLinear, tone.intensity, tone.adapt, tone.colorAdapt);
}

float usable(float value) {
  constexpr float kLargest = 65504;
  return value > 0 ? std::min(value, kLargest) : 0;  // NaN: 0
}

void blackOut(ImageSpan picture) {
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < picture.height; ++y) std::fill_n(picture.row(c, y), picture.width, 0.F);
}

}  // namespace

StillTone stillToneFromText(const std::string& text) {
  const size_t colon = std::min(text.find(':'), text.size());
  const std::string name = text.substr(0, colon);
  const auto known = std::find_if(mappings().begin(), mappings().end(),
                                  [&](const Mapping& mapping) { return mapping.name == name; });
  if (known == mappings().end())
    throw InputError("there is no tone mapping '{}'; there are {}", name, namesOf(mappings()));
  StillTone tone;
  tone.mapping = known->mapping;
  std::string_view rest = std::string_view(text).substr(std::min(colon + 1, text.size()));
  while (!rest.empty()) {
    const size_t comma = std::min(rest.find(','), rest.size());
    setParameter(tone, *known, rest.substr(0, comma));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return tone;
}

void applyStillTone(ImageSpan picture, const StillTone& tone) {
  cv::Mat pixels(picture.height, picture.width, CV_32FC3);
  for (int y = 0; y < picture.height; ++y) {
    auto* out = pixels.ptr<cv::Vec3f>(y);
    for (int c = 0; c < 3; ++c) {
      const float* in = picture.row(c, y);
      for (int x = 0; x < picture.width; ++x) out[x][c] = usable(in[x]);
    }
  }
  // OpenCV's operators compare with the brightest pixel, and Mantiuk's looks at ever smaller pictures.
  double brightest = 0;
  cv::minMaxIdx(pixels.reshape(1), nullptr, &brightest);
  if (brightest <= 0) return blackOut(picture);
  if (tone.mapping == StillTone::Operator::Mantiuk && std::min(picture.width, picture.height) < 2)
    throw InputError("the tone mapping mantiuk needs a picture of 2 x 2 pixels or more; this has {} x {}",
                     picture.width, picture.height);
  cv::Mat mapped;
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_ERROR);  // it warns of its own code
  operatorOf(tone)->process(pixels, mapped);
  for (int y = 0; y < picture.height; ++y) {
    const auto* in = mapped.ptr<cv::Vec3f>(y);
    for (int c = 0; c < 3; ++c) {
      float* out = picture.row(c, y);
      for (int x = 0; x < picture.width; ++x) out[x] = std::min(usable(in[x][c]), 1.0F);
    }
  }
}

}  // namespace swaplight
