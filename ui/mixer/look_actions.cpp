#include "ui/mixer/mixer_actions.h"

#include "ui/control/look_edit.h"

namespace swaplight {

void addLookActions(ActionTable& actions, LightsContext& studio) {
  actions.add({"looks.keep", "Save lighting as a look", "Shift+K",
               "Adds the current lighting to the gallery.",
               [&studio] {
                 keepLook(studio);
                 studio.layout.gallery = true;
               },
               [&studio] { return studio.hasLights(); }});
  actions.add({"looks.keep_version", "Save all as a version", "Shift+V",
               "Adds a version to the gallery: lighting, light edits, view and camera look.",
               [&studio] {
                 keepVersion(studio);
                 studio.layout.gallery = true;
               },
               [&studio] { return studio.hasLights(); }});
}

}  // namespace swaplight
