#pragma once

#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/measure/luminance_histogram.h"
#include "core/ocio/color_config.h"
#include "core/relight/rig.h"
#include "core/report/gallery_pictures.h"
#include "core/session/document.h"
#include "core/set/dynamic_range.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// What a report is about.
struct ReportSubject {
  const ColorConfig& config;
  const SolvedSet& set;
  Rig rig;
  DisplayChoice display;
  std::string source;                         ///< as the person named it
  std::vector<GalleryPicture> versions = {};  ///< the session's looks and versions, drawn
};

/// A report on a set under a rig. What it tells is found out once, when it is made.
class SessionReport {
 public:
  /// `subject.config` and `subject.set` must outlive it. Throws InputError where a colour space is not known.
  explicit SessionReport(ReportSubject subject);

  /// A page (HTML) that needs nothing else and prints well: the set before and after, the versions with names
  /// and notes, its lights with colour, temperature, gel, stops and dynamic range, the solver's summary, maps
  /// of residual and sigma, luminance before and after. The same subject gives the same page.
  [[nodiscard]] std::string html() const;
  /// Its figures: lights, dynamic range, solver, luminance.
  [[nodiscard]] Json json() const;
  /// Of each light; empty where the set has no quality.
  [[nodiscard]] const std::vector<LightRange>& ranges() const { return m_ranges; }
  /// Luminance before and after as a plot.
  [[nodiscard]] Image histogram() const;

 private:
  [[nodiscard]] std::string versionSection() const;
  /// Takes a picture into the report: its luminance; gives it at the size of the page.
  Image taken(const Image& picture, const char* name);

  ReportSubject m_subject;
  std::vector<NamedHistogram> m_luminance;  ///< before and after
  Image m_white, m_relit;                   ///< scene-linear, as wide as the page shows them
  std::vector<LightRange> m_ranges;
};

}  // namespace swaplight
