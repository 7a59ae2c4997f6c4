#pragma once

#include <optional>
#include <string>

#include "core/filter/filter.h"
#include "core/session/document_editor.h"

namespace swaplight {

// How panels and actions change the document's camera look: each is a step of its own, that can be undone.

/// The filter's name for people: of a file without its folder and ending.
[[nodiscard]] std::string stageName(const FilterStage& stage);

/// A filter at a place, or behind all others. Gives its index.
size_t addFilter(DocumentEditor& editor, const std::string& filter, std::optional<size_t> at = {});
void removeFilter(DocumentEditor& editor, size_t index);
/// Behind the one that is duplicated.
void duplicateFilter(DocumentEditor& editor, size_t index);
/// To the place that another one has.
void moveFilter(DocumentEditor& editor, size_t from, size_t to);
void switchFilter(DocumentEditor& editor, size_t index, bool on);
/// One parameter; `live`: while a slider is held, as part of one step. A default is not written.
void setFilterParameter(DocumentEditor& editor, size_t index, const FilterInput& input,
                        const FilterValue& value, bool live);
/// The four of the filter "review" that photo programs have: brightness, contrast, saturation, sharpness; 1
/// changes nothing. They work on the last such filter of the look, which is added where there is none.
inline constexpr const char* kReviewFilter = "review";
[[nodiscard]] float reviewValue(const Document& document, const std::string& name);
void setReview(DocumentEditor& editor, const std::string& name, float value, bool live);
/// Another look in the place of the document's.
void useCameraLook(DocumentEditor& editor, FilterPipeline look);
void removeCameraLook(DocumentEditor& editor);

}  // namespace swaplight
