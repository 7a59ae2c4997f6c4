#include "core/cue/cue_span.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

/// A cue's place in the list; 0 for the first one and for one that is not there.
size_t laterCue(const CueList& cues, int number) {
  const Cue* found = findCue(cues, number);
  return found ? static_cast<size_t>(found - cues.data()) : 0;
}

float rounded(double seconds, double step) {
  return static_cast<float>(
      std::clamp(std::round(seconds / step) * step, 0.0, static_cast<double>(kMostCueSeconds)));
}

}  // namespace

std::vector<CueSpan> cueSpans(const CueList& cues, double holdSeconds) {
  std::vector<CueSpan> spans;
  double now = 0;
  for (const Cue& cue : cues) {
    const bool first = spans.empty(), last = &cue == &cues.back();
    CueSpan span{cue.number, now, now, 0, !cue.followSeconds || last};
    if (!first) span.stands += static_cast<double>(cue.fadeSeconds);
    span.ends = now = span.stands + (span.waits ? holdSeconds : static_cast<double>(*cue.followSeconds));
    spans.push_back(span);
  }
  return spans;
}

CueList withCueBegin(CueList cues, int number, double seconds, double holdSeconds, double step) {
  const size_t place = laterCue(cues, number);
  if (place == 0) return cues;
  const double before = cueSpans(cues, holdSeconds)[place - 1].stands;
  cues[place - 1].followSeconds = rounded(seconds - before, step);
  return cues;
}

CueList withCueStand(CueList cues, int number, double seconds, double holdSeconds, double step) {
  const size_t place = laterCue(cues, number);
  if (place == 0) return cues;
  cues[place].fadeSeconds = rounded(seconds - cueSpans(cues, holdSeconds)[place].begins, step);
  return cues;
}

}  // namespace swaplight
