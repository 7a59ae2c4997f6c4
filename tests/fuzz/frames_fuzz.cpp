#include "core/file/frame_range.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

namespace {

/// A range of a million frames is right, and takes the sanitizers a second: most inputs would be such ones.
bool asksForMany(const std::string& text) {
  int digits = 0;
  for (const char c : text)
    if (digits = c >= '0' && c <= '9' ? digits + 1 : 0; digits > 4) return true;
  return false;
}

}  // namespace

// The first line: a range; the rest: a name with a place for the number.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = fuzz::textOf(data, size);
  const size_t line = std::min(text.find('\n'), text.size());
  if (asksForMany(text)) return 0;
  fuzz::load([&] {
    const auto frames = framesFromRange(text.substr(0, line));
    const std::string pattern = line < text.size() ? text.substr(line + 1) : "f.####.exr";
    if (hasFrameNumber(pattern) && !frames.empty()) static_cast<void>(frameName(pattern, frames.front()));
    static_cast<void>(shareOfFrames(frames, 0, 3));
  });
  return 0;
}
