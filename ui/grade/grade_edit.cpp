#include "ui/grade/grade_edit.h"

#include <utility>

namespace swaplight {

ColorGrade gradeOf(const Document& document) {
  return document.display.grade.value_or(ColorGrade{});
}

void setGrade(DocumentEditor& editor, const std::string& step, const ColorGrade& grade, bool live) {
  Document next = editor.document();
  if (grade == ColorGrade{})
    next.display.grade.reset();
  else
    next.display.grade = grade;
  if (live)
    editor.preview(step, std::move(next));
  else
    editor.edit(step, std::move(next));
}

}  // namespace swaplight
