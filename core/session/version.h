#pragma once

#include <optional>
#include <string>

#include "core/cue/stage.h"
#include "core/session/document.h"

namespace swaplight {

/// The lights and edits of a document, which cues change.
[[nodiscard]] Stage stageOfDocument(const Document& document);
[[nodiscard]] Document withStage(Document document, Stage stage);

/// What there is now as a version: lighting, edits, display and camera look.
[[nodiscard]] SavedLook versionOf(const Document& document, std::string name, std::string note = "");

/// The document as one of the gallery has it: of a look the lighting; of a version all. In part (amount 0..1)
/// lights and edits go so far, display and camera look stay.
[[nodiscard]] Document recalled(Document document, const SavedLook& look, float amount = 1);

/// Makes a cue of what there is now: its version (named "Cue 2") is kept in the gallery. The cue of that
/// number, where there is one, keeps its times, and its version is made anew. Without a number: a new cue at
/// the end. Gives the document and the number. Throws InputError where the gallery takes no more looks.
struct RecordedCue {
  Document document;
  int number = 0;
};
[[nodiscard]] RecordedCue recordCue(Document document, std::optional<int> number = {});

/// The gallery with one name changed, or one look less; the cues follow.
[[nodiscard]] Document withLookNamed(Document document, size_t look, const std::string& name);
[[nodiscard]] Document withLookRemoved(Document document, size_t look);

}  // namespace swaplight
