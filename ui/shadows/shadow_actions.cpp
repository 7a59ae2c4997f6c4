#include "ui/shadows/shadow_actions.h"

#include "ui/control/shadow_edit.h"

namespace swaplight {

void addShadowActions(ActionTable& actions, EditingContext& studio) {
  actions.add({"view.shadows", "Shadows and \u03b2", "F3",
               "Each light's shadows: where they begin, their outlines, and what to do about them.",
               [&studio] {
                 studio.layout.shadows = !shadowsShown(studio);
                 if (!studio.layout.shadows) return;
                 studio.layout.edits = true;
                 studio.tool = Tool::Look;
               },
               [&studio] { return studio.set() && !studio.document().rig.lights.empty(); },
               [&studio] { return shadowsShown(studio); }});
  actions.add({"shadows.outlines", "Outlines of shadows", "Shift+F3",
               "Draw the borders of the chosen light's shadows over the picture.",
               [&studio] { studio.editing.shadow.outlines = !studio.editing.shadow.outlines; },
               [&studio] { return shadowsShown(studio); },
               [&studio] { return studio.editing.shadow.outlines; }});
  actions.add({"shadows.choose_all", "All shadows of the light", "Escape",
               "What is done to shadows is done to all of the light's, not to the one that was clicked.",
               [&studio] { studio.shadows.chooseAll(); },
               [&studio] {
                 return shadowsShown(studio) && studio.editing.shadow.chosen && studio.tool == Tool::Look;
               }});
}

}  // namespace swaplight
