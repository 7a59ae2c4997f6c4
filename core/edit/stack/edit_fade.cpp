#include "core/edit/stack/edit_fade.h"

#include <algorithm>

namespace swaplight {
namespace {

using Kept = std::shared_ptr<const Edit>;

float opacityOf(const Kept& edit) {
  return edit && edit->on ? edit->opacity : 0;
}

bool sameButOpacity(const Kept& a, const Kept& b) {
  if (a == b) return true;
  return a->lights == b->lights && a->energy == b->energy && a->operation == b->operation &&
         a->mask == b->mask;
}

/// How many edits of the ends a[i..], b[j..] can be paired in order: [i][j].
class PairCounts {
 public:
  PairCounts(const std::vector<Kept>& a, const std::vector<Kept>& b)
      : m_columns(b.size() + 1), m_counts((a.size() + 1) * m_columns) {
    for (size_t i = a.size(); i-- > 0;)
      for (size_t j = b.size(); j-- > 0;)
        at(i, j) = sameButOpacity(a[i], b[j]) ? 1 + at(i + 1, j + 1) : std::max(at(i + 1, j), at(i, j + 1));
  }
  int& at(size_t i, size_t j) { return m_counts[i * m_columns + j]; }

 private:
  size_t m_columns;
  std::vector<int> m_counts;
};

Kept withOpacity(const Kept& edit, float opacity) {
  if (opacityOf(edit) == opacity) return edit;
  Edit faded = *edit;
  faded.on = true;
  faded.opacity = opacity;
  return std::make_shared<const Edit>(std::move(faded));
}

}  // namespace

EditFade::EditFade(EditStack from, EditStack to) : m_from(std::move(from)), m_to(std::move(to)) {
  const std::vector<Kept>&a = m_from.edits, &b = m_to.edits;
  PairCounts counts(a, b);
  size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && sameButOpacity(a[i], b[j]))
      m_pairs.push_back({a[i++], b[j++]});
    else if (j == b.size() || (i < a.size() && counts.at(i + 1, j) >= counts.at(i, j + 1)))
      m_pairs.push_back({a[i++], nullptr});
    else
      m_pairs.push_back({nullptr, b[j++]});
  }
}

EditStack EditFade::at(float amount) const {
  if (amount <= 0 || m_from == m_to) return m_from;
  if (amount >= 1) return m_to;
  EditStack stack = m_from;
  stack.edits.clear();
  for (const Pair& pair : m_pairs) {
    const float from = opacityOf(pair.from), to = opacityOf(pair.to);
    stack.edits.push_back(
        withOpacity(pair.from ? pair.from : pair.to, from == to ? from : from + amount * (to - from)));
  }
  for (const std::string& light : m_to.newLights)
    if (std::find(stack.newLights.begin(), stack.newLights.end(), light) == stack.newLights.end())
      stack.newLights.push_back(light);
  // Those of one side as they are: places of two would be metered, or not, by halves.
  if (stack.lampPlaces.empty()) stack.lampPlaces = m_to.lampPlaces;
  if (stack.width == 0) {
    stack.width = m_to.width;
    stack.height = m_to.height;
  }
  return stack;
}

}  // namespace swaplight
