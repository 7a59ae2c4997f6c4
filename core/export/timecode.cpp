#include "core/export/timecode.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace swaplight {
namespace {

constexpr const char* kTimecode = "smpte:TimeCode";
constexpr PackedTime kDropFrame = 1U << 6;
constexpr PackedTime kField = 1U << 15;
constexpr PackedTime kFlagBits = 0xc0U | kField | 0x800000U | 0xc0000000U;
constexpr int kMostCounted = 30;  // frames, or pairs of them, in a second

/// Two decimal digits from bit `shift` on; `tens` bits hold the first of them.
int digits(PackedTime time, int shift, int tens) {
  const auto low = static_cast<int>(time >> shift & 15U);
  const auto high = static_cast<int>(time >> (shift + 4) & ((1U << tens) - 1));
  return 10 * high + low;
}

PackedTime packed(int value, int shift) {
  return static_cast<PackedTime>(value / 10 << 4 | value % 10) << shift;
}

int framesPerSecond(const HeaderValues& header) {
  constexpr int kUsual = 24, kLargest = 10000;
  const auto found = header.find("FramesPerSecond");
  if (found == header.end()) return kUsual;
  const HeaderValue& value = found->second;
  double rate = 0;
  if (value.kind == HeaderValue::Kind::Rational && value.integers.size() == 2 && value.integers[1] != 0)
    rate = static_cast<double>(value.integers[0]) / value.integers[1];
  if (!value.floats.empty()) rate = value.floats.front();
  return rate > 0 ? static_cast<int>(std::lround(std::min(rate, double{kLargest}))) : kUsual;
}

}  // namespace

bool countsFrames(int fps) {
  return fps >= 1 && (fps <= kMostCounted || (fps <= 2 * kMostCounted && fps % 2 == 0));
}

PackedTime advanced(PackedTime time, int frames, int fps) {
  SWAPLIGHT_CHECK(countsFrames(fps));
  if (fps > kMostCounted) {
    const int64_t ofPair = int64_t{frames} + ((time & kField) != 0 ? 1 : 0);
    const int64_t odd = ofPair & 1;
    const PackedTime pair = advanced(time & ~kField, static_cast<int>((ofPair - odd) / 2), fps / 2);
    return odd != 0 ? pair | kField : pair;
  }
  constexpr int64_t kMinutes = 24 * 60;
  // Frames since midnight.
  const int hours = digits(time, 24, 2), minutes = digits(time, 16, 3), seconds = digits(time, 8, 3);
  const int dropped = (time & kDropFrame) != 0 ? 2 : 0;
  const int64_t minute = int64_t{hours} * 60 + minutes;
  int64_t count = (minute * 60 + seconds) * fps + digits(time, 0, 2) - dropped * (minute - minute / 10);
  const int64_t day = kMinutes * 60 * fps - dropped * (kMinutes - kMinutes / 10);
  count = ((count + frames) % day + day) % day;
  // Numbers that are not used come back in.
  if (dropped > 0) {
    const int64_t tenMinutes = int64_t{600} * fps - 9 * dropped, one = int64_t{60} * fps - dropped;
    const int64_t tens = count / tenMinutes, rest = count % tenMinutes;
    count += dropped * (9 * tens + (rest >= int64_t{60} * fps ? (rest - int64_t{60} * fps) / one + 1 : 0));
  }
  const int64_t total = count / fps;
  return (time & kFlagBits) | packed(static_cast<int>(count % fps), 0) |
         packed(static_cast<int>(total % 60), 8) | packed(static_cast<int>(total / 60 % 60), 16) |
         packed(static_cast<int>(total / 3600), 24);
}

std::shared_ptr<const CarriedData> withTimecode(const std::shared_ptr<const CarriedData>& carried,
                                                int frames) {
  if (!carried || frames == 0) return carried;
  const auto found = carried->header.find(kTimecode);
  if (found == carried->header.end() || found->second.kind != HeaderValue::Kind::Timecode) return carried;
  auto later = std::make_shared<CarriedData>();
  later->header = carried->header;
  later->pixelAspect = carried->pixelAspect;
  later->dataWindow = carried->dataWindow;
  if (carried->channels.channelCount() > 0) later->channels = carried->channels.clone();
  later->types = carried->types;
  const int fps = framesPerSecond(carried->header);
  if (!countsFrames(fps)) {
    later->header.erase(kTimecode);
    return later;
  }
  int& time = later->header[kTimecode].integers.at(0);
  time = static_cast<int>(advanced(static_cast<PackedTime>(time), frames, fps));
  return later;
}

}  // namespace swaplight
