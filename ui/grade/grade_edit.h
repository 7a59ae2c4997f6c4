#pragma once

#include <string>

#include "core/session/document_editor.h"

namespace swaplight {

/// The document's grade; one that changes nothing where it has none.
[[nodiscard]] ColorGrade gradeOf(const Document& document);
/// Another one: a step of its own, or, `live`, part of one while something is held.
void setGrade(DocumentEditor& editor, const std::string& step, const ColorGrade& grade, bool live);

}  // namespace swaplight
