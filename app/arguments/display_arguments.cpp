#include "app/arguments/display_arguments.h"

namespace swaplight {

void addDisplayOptions(CLI::App& verb, DisplayChoice& choice) {
  verb.add_option("--view", choice.view,
                  "A view of the colour configuration, as AgX or \"ACES SDR\"; without it a session's own")
      ->type_name("NAME");
  verb.add_option("--display", choice.display, "A display of the colour configuration")->type_name("NAME");
  verb.add_option_function<std::string>(
          "--view-look", [&choice](const std::string& text) { choice.look = lookFromText(text); },
          "Looks of the colour configuration in place of the view's own: none, a name, or several as "
          "=+warm,-bleach")
      ->type_name("LOOK");
}

DisplayChoice displayOver(const std::optional<Session>& session, const DisplayChoice& asked) {
  return asked.over(session ? session->document.display : DisplayChoice{});
}

}  // namespace swaplight
