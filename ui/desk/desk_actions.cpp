#include "ui/desk/desk_actions.h"

#include "core/base/error.h"
#include "ui/desk/cue_edit.h"

namespace swaplight {

void addDeskActions(ActionTable& actions, const LightsContext& studio, CommandLine& line, CuePlayer& cues) {
  actions.add({"desk.type", "Type a command", "Ctrl+L",
               "Type a command in words, as at a lighting desk: 1 thru 3 @ 50, key gel L201, go 2.",
               [&studio, &line] {
                 studio.layout.commandLine = true;
                 studio.layout.hidden = false;
                 line.focus();
               }});
  const auto go = [&](const char* id, const char* name, const char* keys, const char* tip,
                      const char* where) {
    actions.add({id, name, keys, tip,
                 [&studio, &cues, where] {
                   try {
                     studio.messages.info(cues.go(studio, where));
                   } catch (const InputError& error) {
                     studio.messages.warn(error.what());
                   }
                 },
                 [&studio] {
                   const Document& document = studio.document();
                   return studio.set() && !(document.looks.empty() && document.cues.empty());
                 }});
  };
  go("cues.go", "Go: the next cue", "Ctrl+Enter",
     "Fade to the next cue in its time; without cues to the next look of the gallery, in the time that was "
     "typed last: go 2 in 5.",
     "next");
  go("cues.back", "Back: the cue before", "Ctrl+Backspace",
     "Fade to the cue before in its time; without cues to the look before in the gallery.", "back");
  actions.add(
      {"cues.record", "Record a cue", "Shift+R",
       "Keep all there is now (lights, light edits, view, camera look) as a version, and add it to the "
       "cue list.",
       [&studio, &cues] {
         try {
           cues.stand(recordCueLine(studio, ""));
           studio.layout.cues = true;
         } catch (const InputError& error) {
           studio.messages.warn(error.what());
         }
       },
       [&studio] { return studio.hasLights(); }});
}

}  // namespace swaplight
