#pragma once

#include <string>

#include "core/json.h"
#include "core/relight/rig.h"
#include "core/session/document.h"
#include "core/solve/solved_set.h"

namespace swaplight {

/// What a report is about.
struct ReportSubject {
  const SolvedSet& set;
  Rig rig;
  DisplayChoice display;
  std::string source;  ///< as the person named it
};

/// A page (HTML) that needs nothing else and prints well: the set before and after, its lights with colour,
/// temperature, gel, stops and dynamic range, the solver's summary, maps of residual and sigma, luminance
/// before and after. The same subject gives the same page.
[[nodiscard]] std::string reportHtml(const ReportSubject& subject);

/// Its figures: lights, dynamic range, solver, luminance.
[[nodiscard]] Json reportJson(const ReportSubject& subject);

/// Luminance before and after as a plot.
[[nodiscard]] Image reportHistogram(const ReportSubject& subject);

}  // namespace swaplight
