#pragma once

#include <memory>
#include <vector>

#include "core/edit/stack/edit.h"

namespace swaplight {

/// The way from one stack to another by opacity, as a desk fades what can be faded: an edit of only the first
/// goes, one of only the second comes, one of both goes from the one opacity to the other. Edits are the same
/// where they differ in nothing but opacity and whether they are on (off is opacity 0); of several ways to
/// pair them in order the longest is taken (longest common subsequence), so that the order of either holds.
class EditFade {
 public:
  EditFade(EditStack from, EditStack to);

  /// amount 0..1: at 0 and 1 the stacks as they are. Between them there are the new lights of both; what has
  /// no opacity (thresholds of shadows) is that of the first.
  [[nodiscard]] EditStack at(float amount) const;

 private:
  /// An edit on its way; one of them may be missing.
  struct Pair {
    std::shared_ptr<const Edit> from, to;
  };
  EditStack m_from, m_to;
  std::vector<Pair> m_pairs;  ///< in an order that suits both
};

}  // namespace swaplight
