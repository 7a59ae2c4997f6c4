#include "app/arguments/grade_arguments.h"

#include "core/base/error.h"
#include "core/ocio/grade_file.h"

namespace swaplight {
namespace {

constexpr const char* kNoGrade = "none";

}  // namespace

void GradeArguments::addTo(CLI::App& verb) {
  constexpr const char* kGroup = "Grade";
  verb.add_option("--cdl", m_file,
                  "Grade of the finished frame: an ASC CDL (.cc, .ccc, .cdl), in ACEScct or the "
                  "configuration's color_timing; none: not the session's either")
      ->type_name("FILE")
      ->group(kGroup);
  verb.add_option("--cdl-id", m_id, "Which correction of a .ccc or .cdl (default: its first)")
      ->type_name("ID")
      ->group(kGroup);
}

std::optional<ColorGrade> GradeArguments::grade() const {
  if (m_file.empty() && !m_id.empty()) throw InputError("--cdl-id {}: name the file too, by --cdl", m_id);
  if (m_file.empty()) return std::nullopt;
  return m_file == kNoGrade ? ColorGrade{} : readGrade(m_file, m_id);
}

std::vector<std::filesystem::path> GradeArguments::inputs() const {
  if (m_file.empty() || m_file == kNoGrade) return {};
  return {m_file};
}

}  // namespace swaplight
