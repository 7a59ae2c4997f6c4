#include "core/session/version.h"

namespace swaplight {
namespace {

/// The place of a cue's own version, which no other cue shows; nothing where it has none.
std::optional<size_t> ownVersion(const Document& document, const Cue& cue) {
  for (const Cue& other : document.cues)
    if (other.number != cue.number && other.look == cue.look) return std::nullopt;
  const SavedLook* look = findSavedLook(document.looks, cue.look);
  if (!look || !look->scene) return std::nullopt;
  return static_cast<size_t>(look - document.looks.data());
}

}  // namespace

Stage stageOfDocument(const Document& document) {
  return {document.rig, document.edits};
}

Document withStage(Document document, Stage stage) {
  document.rig = std::move(stage.rig);
  document.edits = std::move(stage.edits);
  return document;
}

SavedLook versionOf(const Document& document, std::string name, std::string note) {
  return {std::move(name), std::move(note), document.rig,
          VersionScene{document.edits, document.display, document.cameraLook}};
}

Document recalled(Document document, const SavedLook& look, float amount) {
  const Stage now = stageOfDocument(document);
  document = withStage(std::move(document), StageFade(now, stageOf(look, now)).at(amount));
  if (look.scene && amount >= 1) {
    document.display = look.scene->display;
    document.cameraLook = look.scene->cameraLook;
  }
  return document;
}

RecordedCue recordCue(Document document, std::optional<int> number) {
  const Cue* known = number ? findCue(document.cues, *number) : nullptr;
  Cue cue = known ? *known : Cue{number.value_or(freeCueNumber(document.cues)), {}};
  const auto own = known ? ownVersion(document, cue) : std::nullopt;
  if (own) {
    const SavedLook& before = document.looks[*own];
    document.looks[*own] = versionOf(document, before.name, before.note);
  } else {
    std::string name = "Cue " + cueNumberText(cue.number);
    if (findSavedLook(document.looks, name)) name = freeLookName(document.looks, name + " take");
    cue.look = name;
    addLook(document.looks, versionOf(document, name));
  }
  document.cues = withCue(std::move(document.cues), cue);
  return {std::move(document), cue.number};
}

Document withLookNamed(Document document, size_t look, const std::string& name) {
  document.cues = withLookRenamed(std::move(document.cues), document.looks[look].name, name);
  document.looks[look].name = name;
  return document;
}

Document withLookRemoved(Document document, size_t look) {
  document.cues = withoutLook(std::move(document.cues), document.looks[look].name);
  document.looks.erase(document.looks.begin() + static_cast<ptrdiff_t>(look));
  return document;
}

}  // namespace swaplight
