#include "ui/dialogs/wizard_rows.h"

#include <algorithm>

namespace swaplight {

std::vector<size_t> usedPhotographs(const std::vector<WizardRow>& rows) {
  std::vector<size_t> used;
  for (const WizardRow& row : rows)
    if (row.used) used.insert(used.end(), row.photographs.begin(), row.photographs.end());
  std::sort(used.begin(), used.end());
  return used;
}

std::vector<WizardRow> regrouped(const std::vector<WizardRow>& rows, size_t length) {
  std::vector<WizardRow> result;
  for (const WizardRow& row : rows)
    if (!row.used) result.push_back(row);
  const std::vector<size_t> used = usedPhotographs(rows);
  for (size_t k = 0; k < used.size(); k += length) {
    const auto begin = used.begin() + static_cast<ptrdiff_t>(k);
    WizardRow row{{begin, begin + static_cast<ptrdiff_t>(length)}};
    for (const WizardRow& old : rows)
      if (std::count(old.photographs.begin(), old.photographs.end(), row.first()) > 0) row.cells = old.cells;
    result.push_back(std::move(row));
  }
  std::sort(result.begin(), result.end(),
            [](const WizardRow& a, const WizardRow& b) { return a.first() < b.first(); });
  return result;
}

}  // namespace swaplight
