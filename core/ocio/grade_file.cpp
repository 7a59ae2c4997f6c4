#include "core/ocio/grade_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <system_error>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/file/atomic_file.h"
#include "core/ocio/grade_transform.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kLargestGrade = uintmax_t{16} << 20;
constexpr const char* kGradeId = "swaplight_grade";

struct Format {
  const char* extension;
  const char* name;  ///< OpenColorIO's
};
constexpr std::array<Format, 3> kFormats = {
    {{".cc", "ColorCorrection"}, {".ccc", "ColorCorrectionCollection"}, {".cdl", "ColorDecisionList"}}};

const Format* formatOf(const fs::path& file) {
  const std::string extension = lowerExtension(file);
  const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const Format& format) { return extension == format.extension; });
  return found == kFormats.end() ? nullptr : &*found;
}

const Format& knownFormat(const fs::path& file) {
  const Format* format = formatOf(file);
  if (!format)
    throw InputError("{}: no colour correction by its ending: give a .cc, .ccc or .cdl file", file.string());
  return *format;
}

/// Pipes and devices would be read for ever.
void checkReadable(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) throw InputError("{}: there is no such file", file.string());
  if (!fs::is_regular_file(file, error)) throw InputError("{}: is no regular file", file.string());
  const uintmax_t size = fs::file_size(file, error);
  if (!error && size > kLargestGrade)
    throw InputError("{}: is larger than {} MiB, which no colour correction is", file.string(),
                     kLargestGrade >> 20);
}

std::string firstLine(std::string words) {
  words = words.substr(0, words.find('\n'));
  while (!words.empty() && (words.back() == ' ' || words.back() == '.')) words.pop_back();
  return words;
}

void checkValue(double value, double least, double most, const char* what, const std::string& where) {
  if (std::isfinite(value) && value >= least && value <= most) return;
  throw InputError("{}: the {} is {:g}, expected {:g} to {:g}", where, what, value, least, most);
}

}  // namespace

bool isGradeFile(const fs::path& file) {
  return formatOf(file) != nullptr;
}

void checkGrade(const ColorGrade& grade, const std::string& where) {
  for (size_t c = 0; c < 3; ++c) {
    checkValue(grade.slope[c], 0, kMostGrade, "slope", where);
    checkValue(grade.offset[c], -kMostGrade, kMostGrade, "offset", where);
    checkValue(grade.power[c], 1 / kMostGrade, kMostGrade, "power", where);
  }
  checkValue(grade.saturation, 0, kMostGrade, "saturation", where);
}

ColorGrade readGrade(const fs::path& file, const std::string& id) {
  knownFormat(file);
  checkReadable(file);
  ColorGrade grade;
  const std::lock_guard lock(processorMutex());
  try {
    OCIO::ClearAllCaches();  // which know a file by its name, also when it has changed
    const auto cdl = OCIO::CDLTransform::CreateFromFile(file.c_str(), id.c_str());
    cdl->getSlope(grade.slope.data());
    cdl->getOffset(grade.offset.data());
    cdl->getPower(grade.power.data());
    grade.saturation = cdl->getSat();
  } catch (const OCIO::Exception& error) {
    throw InputError("{}: no colour correction that can be read: OpenColorIO: {}", file.string(),
                     firstLine(error.what()));
  }
  checkGrade(grade, file.string());
  return grade;
}

void writeGrade(const ColorGrade& grade, const fs::path& file, const std::string& description) {
  const Format& format = knownFormat(file);
  checkGrade(grade, file.string());
  const auto cdl = cdlOf(grade);
  cdl->setID(kGradeId);
  cdl->setFirstSOPDescription(description.c_str());
  const auto group = OCIO::GroupTransform::Create();
  group->appendTransform(cdl);
  std::ostringstream text;
  try {
    const std::lock_guard lock(processorMutex());
    group->write(OCIO::Config::CreateRaw(), format.name, text);
  } catch (const OCIO::Exception& error) {
    throw InputError("{}: OpenColorIO: {}", file.string(), firstLine(error.what()));
  }
  writeFile(file, text.str());
}

}  // namespace swaplight
