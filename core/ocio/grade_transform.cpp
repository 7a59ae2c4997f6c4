#include "core/ocio/grade_transform.h"

namespace swaplight {
namespace {

OCIO::RangeTransformRcPtr upTo(double highest) {
  const auto range = OCIO::RangeTransform::Create();
  range->setMaxInValue(highest);
  range->setMaxOutValue(highest);
  return range;
}

}  // namespace

OCIO::CDLTransformRcPtr cdlOf(const ColorGrade& grade) {
  const auto cdl = OCIO::CDLTransform::Create();
  cdl->setStyle(OCIO::CDL_NO_CLAMP);
  cdl->setSlope(grade.slope.data());
  cdl->setOffset(grade.offset.data());
  cdl->setPower(grade.power.data());
  cdl->setSat(grade.saturation);
  return cdl;
}

OCIO::ConstTransformRcPtr gradeTransform(const ColorGrade& grade, double highest) {
  ColorGrade balance = grade;
  balance.saturation = 1;
  ColorGrade saturation;
  saturation.saturation = grade.saturation;
  const auto group = OCIO::GroupTransform::Create();
  group->appendTransform(cdlOf(balance));
  group->appendTransform(upTo(highest));
  group->appendTransform(cdlOf(saturation));
  group->appendTransform(upTo(highest));
  return group;
}

std::mutex& processorMutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace swaplight
