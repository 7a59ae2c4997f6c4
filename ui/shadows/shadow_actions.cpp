#include "ui/shadows/shadow_actions.h"

#include "ui/control/shadow_edit.h"

namespace swaplight {

void addShadowActions(ActionTable& actions, EditingContext& studio) {
  actions.add({"view.shadows", "Shadows", "F3",
               "Find each light's shadows, see their outlines and edit them.",
               [&studio] {
                 studio.layout.shadows = !shadowsShown(studio);
                 studio.tool = nullptr;
                 if (studio.layout.shadows) studio.layout.edits = true;
               },
               [&studio] { return studio.hasLights(); }, [&studio] { return shadowsShown(studio); }});
  actions.add({"shadows.outlines", "Shadow outlines", "Shift+F3",
               "Outline the selected light's shadows in the picture.",
               [&studio] { studio.editing.shadow.outlines = !studio.editing.shadow.outlines; },
               [&studio] { return shadowsShown(studio); },
               [&studio] { return studio.editing.shadow.outlines; }});
  actions.add({"shadows.choose_all", "All of the light's shadows", "Escape",
               "Edit all of the light's shadows instead of the one that was clicked.",
               [&studio] { studio.shadows.chooseAll(); },
               [&studio] { return shadowsShown(studio) && studio.editing.shadow.chosen && !studio.tool; }});
  actions.add({"shadows.clear_marks", "Clear the light's shadow labels", "",
               "Forget what was said to be shadow or lit of this light.",
               [&studio] { clearShadowMarks(studio, shownShadowLight(studio)); },
               [&studio] {
                 return shadowsShown(studio) &&
                        !shadowMarksOf(studio.document(), shownShadowLight(studio)).empty();
               }});
}

}  // namespace swaplight
