#include "core/file/frame_range.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>
#include <unordered_set>

#include "core/base/error.h"

namespace swaplight {
namespace {

constexpr size_t kMostFrames = 1000000;
constexpr int64_t kHighestFrame = 999999999;

struct Place {
  size_t at = 0;
  size_t length = 0;
  int digits = 0;
};

/// The place that begins at `at`: %d, %4d, %04d, or a row of # or of @.
std::optional<Place> placeAt(const std::string& text, size_t at) {
  const auto isDigit = [&](size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  if (text[at] == '#' || text[at] == '@') {
    const size_t length = std::min(text.find_first_not_of(text[at], at), text.size()) - at;
    return Place{at, length, text[at] == '#' && length == 1 ? 4 : static_cast<int>(length)};
  }
  if (text[at] != '%') return std::nullopt;
  size_t end = at + 1;
  if (isDigit(end) && text[end] == '0') ++end;
  int digits = 1;
  if (isDigit(end)) digits = text[end++] - '0';
  if (end >= text.size() || text[end] != 'd') return std::nullopt;
  return Place{at, end + 1 - at, digits};
}

/// The last one.
std::optional<Place> placeIn(const std::string& pattern) {
  // Only the file's own name: folders may be called anything.
  const size_t slash = pattern.find_last_of('/');
  std::optional<Place> found;
  for (size_t at = slash == std::string::npos ? 0 : slash + 1; at < pattern.size();) {
    const std::optional<Place> place = placeAt(pattern, at);
    if (place) found = place;
    at += place ? place->length : 1;
  }
  return found;
}

/// The frames of one part after those before it. They are counted before any is made: a short text can ask
/// for many.
void addRange(const std::string& part, std::vector<int>& frames) {
  static const std::regex kRange("(-?[0-9]{1,18})(?:-(-?[0-9]{1,18})(?:x([0-9]{1,18}))?)?");
  std::smatch match;
  if (!std::regex_match(part, match, kRange))
    throw InputError("frames '{}': write 7, 1-100, 1-100x5, or several with commas", part);
  const int64_t first = std::stoll(match[1]);
  const int64_t last = match[2].matched ? std::stoll(match[2]) : first;
  const int64_t step = match[3].matched ? std::stoll(match[3]) : 1;
  if (step == 0) throw InputError("frames '{}': the step is 0; write 1 or more", part);
  const int64_t direction = last < first ? -1 : 1;
  const int64_t count = direction * (last - first) / step + 1;
  if (frames.size() + static_cast<size_t>(count) > kMostFrames)
    throw InputError("frames '{}': more than a million; write a shorter range", part);
  if (std::max(std::abs(first), std::abs(last)) > kHighestFrame)
    throw InputError("frames '{}': no frame's number has more than nine digits", part);
  for (int64_t i = 0; i < count; ++i) frames.push_back(static_cast<int>(first + direction * i * step));
}

/// Leaves out what comes again.
std::vector<int> onceEach(const std::vector<int>& frames) {
  std::unordered_set<int> seen(frames.size());
  std::vector<int> once;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(once),
               [&](int frame) { return seen.insert(frame).second; });
  return once;
}

}  // namespace

std::vector<int> framesFromRange(const std::string& text) {
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream parts(spaced);
  std::vector<int> frames;
  std::string part;
  while (parts >> part) addRange(part, frames);
  if (frames.empty()) throw InputError("frames '{}': there are none; write 7, 1-100 or 1-100x5", text);
  return onceEach(frames);
}

bool hasFrameNumber(const std::string& pattern) {
  return placeIn(pattern).has_value();
}

std::string frameName(const std::string& pattern, int frame) {
  const std::optional<Place> place = placeIn(pattern);
  if (!place) return pattern;
  const std::string number = fmt::format("{:0{}}", frame, place->digits);
  return pattern.substr(0, place->at) + number + pattern.substr(place->at + place->length);
}

std::vector<int> shareOfFrames(const std::vector<int>& frames, int index, int count) {
  if (count < 1 || index < 0 || index >= count)
    throw InputError("part {} of {}: the parts are counted 0 to {}", index, count, std::max(count - 1, 0));
  const auto at = [&](int i) { return frames.begin() + static_cast<ptrdiff_t>(frames.size()) * i / count; };
  return {at(index), at(index + 1)};
}

}  // namespace swaplight
