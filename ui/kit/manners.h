#pragma once

namespace swaplight {

// The manners of dialogs, menus and lists, in one place. Escape closes what is on top, and nothing else.
// Enter takes the button that is marked; once Tab or an arrow has led to another one, that one. Tab goes
// round through all of a dialog, Space presses what it has come to, arrows go from line to line. A dialog
// that comes back has its field ready to be typed into.

/// How many dialogs, menus and lists are open over the panels, one on another.
[[nodiscard]] int openPopups();
[[nodiscard]] inline bool popupOpen() {
  return openPopups() > 0;
}
/// Closes the menu or list on top, if there is one; dialogs close themselves, as they have a Cancel.
bool closeTopList();

/// To be called before every frame: lets the keyboard move through what is on top.
void mannersBeforeFrame();
/// To be called at the beginning of every frame, once Dear ImGui's is open.
void mannersFrame();

/// After a dialog was begun, and before it is ended: all of it can be reached by Tab.
void beginTabStops();
void endTabStops();
/// A dialog shows other things from here on: Tab begins at the first of them.
void restartTabRound();
/// What is drawn between them is left out by Tab: it can be had otherwise.
void beginNoTabStops();
void endNoTabStops();
/// What lies in the part of a dialog that scrolls and is drawn now belongs to the same round as the rest of
/// it. To be called before the first item in it.
void joinTabRound();
/// The keyboard is at the item that was drawn last.
[[nodiscard]] bool keyboardIsHere();
/// Enter has pressed what Tab or an arrow had led to.
[[nodiscard]] bool pressedByEnter();

/// Whether the dialog that is drawn now is on top and hears this key for the first time.
[[nodiscard]] bool dialogAccepted();   ///< Enter, for the marked button
[[nodiscard]] bool dialogCancelled();  ///< Escape

/// The button that Enter presses, marked by its colour. It is not pressed while `enabled` is false.
bool defaultButton(const char* label, float width, bool enabled = true, const char* tip = "Enter");
/// The button that Escape presses.
bool cancelButton(const char* label, float width, const char* tip = "Escape");

}  // namespace swaplight
