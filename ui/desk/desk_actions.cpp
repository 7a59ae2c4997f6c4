#include "ui/desk/desk_actions.h"

#include "core/base/error.h"

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
                 [&studio] { return studio.set() && !studio.document().looks.empty(); }});
  };
  go("cues.go", "Go to the next look", "Ctrl+Enter",
     "Fade to the next look of the gallery, in the fade time that was typed last: go 2 in 5.", "next");
  go("cues.back", "Go back to the look before", "Ctrl+Backspace",
     "Fade to the look before in the gallery, in the fade time that was typed last.", "back");
}

}  // namespace swaplight
