#pragma once

#include <string>
#include <utility>
#include <vector>

namespace swaplight {

/// Frames by a range: `3`, `1-10`, `1-10x3` (every third), `1,5,10-20x2` (commas or spaces), `-8--5`, `5-1`.
/// Each frame once, in the order given. Throws InputError that quotes the part that is wrong, and above a
/// million frames, those that come again counted.
[[nodiscard]] std::vector<int> framesFromRange(const std::string& text);

/// True where a file's name has a place for the frame's number: %d, %04d, #, ####, @@@.
[[nodiscard]] bool hasFrameNumber(const std::string& pattern);

/// The name of a frame's file: %04d and #### are four digits, a single # too, each @ is one digit; a
/// negative number's sign counts as one of them, as printf has it. The last such place counts.
[[nodiscard]] std::string frameName(const std::string& pattern, int frame);

/// The share of one of `count` jobs: neighbouring frames, as even as can be. Throws InputError where index is
/// not 0 .. count - 1.
[[nodiscard]] std::vector<int> shareOfFrames(const std::vector<int>& frames, int index, int count);

}  // namespace swaplight
