#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace swaplight {

/// How small a draft of a camera look is drawn, so that it follows the hand: by what the drafts before it
/// took.
class DraftSize {
 public:
  /// Of the frame's sides, 0.26 to 1; the smallest for a look of other filters, of which nothing is known.
  [[nodiscard]] float scaleFor(const std::vector<std::string>& filters);
  /// What a picture took, from its start to its end.
  void tell(float scale, double seconds);
  /// Whether the next draft can be waited for within the frame of the interface that shows it.
  [[nodiscard]] bool isQuick() const;

 private:
  std::vector<std::string> m_filters;
  size_t m_step = 0;
  double m_seconds = 0;  ///< of the last draft; 0: not known
};

}  // namespace swaplight
