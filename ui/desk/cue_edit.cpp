#include "ui/desk/cue_edit.h"

#include <fmt/core.h>

#include "core/base/error.h"
#include "core/cue/cue_command.h"
#include "core/session/version.h"

namespace swaplight {
namespace {

std::string firstWord(std::string& text) {
  text.erase(0, text.find_first_not_of(' '));
  const size_t end = std::min(text.find(' '), text.size());
  std::string word = text.substr(0, end);
  text.erase(0, end);
  return word;
}

}  // namespace

int recordCueLine(const LightsContext& lights, const std::string& words) {
  if (lights.document().rig.lights.empty()) throw InputError("open a set first: there are no lights");
  std::string rest = words;
  std::string word = firstWord(rest);
  if (word == "cue") word = firstWord(rest);
  const std::optional<int> number = cueNumberFromText(word);
  if (!word.empty() && !number)
    throw InputError("'{}' is no number of a cue: write record, record 3 or record 3 time 4", word);
  RecordedCue recorded = recordCue(lights.document(), number);
  if (rest.find_first_not_of(' ') != std::string::npos)
    recorded.document.cues =
        cueCommand(recorded.document.cues, recorded.document.looks, cueNumberText(recorded.number) + rest)
            .cues;
  lights.editor.edit("Record cue " + cueNumberText(recorded.number), std::move(recorded.document));
  return recorded.number;
}

std::string runCueLine(const LightsContext& lights, const std::string& line) {
  CueCommand command = cueCommand(lights.document().cues, lights.document().looks, line);
  editCues(lights, "Cue " + line, std::move(command.cues));
  return command.words;
}

void editCues(const LightsContext& lights, const std::string& step, CueList cues) {
  Document next = lights.document();
  next.cues = std::move(cues);
  lights.editor.edit(step, std::move(next));
}

}  // namespace swaplight
