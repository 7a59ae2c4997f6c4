#pragma once

#include <string>
#include <vector>

#include "ui/control/lights_context.h"
#include "ui/desk/cue_player.h"

struct ImGuiInputTextCallbackData;

namespace swaplight {

/// A line for commands in words below the picture, as at a lighting desk: with what can follow, and with the
/// lines before it.
class CommandLine {
 public:
  static constexpr float kHeight = 46;  ///< at scale 1

  /// The keyboard goes to the line in the next frame.
  void focus() { m_focus = true; }
  void draw(const LightsContext& studio, CuePlayer& cues);
  /// It has the keyboard, and nothing is written in it: keys with Ctrl may do what they do elsewhere.
  [[nodiscard]] bool isEmptyAndActive() const { return m_emptyAndActive; }

 private:
  struct Asked;
  static int onKey(ImGuiInputTextCallbackData* data);
  static void complete(const LightsContext& studio, ImGuiInputTextCallbackData& data);
  void recall(ImGuiInputTextCallbackData& data);
  void run(const LightsContext& studio, CuePlayer& cues);
  [[nodiscard]] bool answers() const;
  void drawAnswer(const LightsContext& studio) const;

  std::string m_text;
  std::vector<std::string> m_lines;  ///< those that were run, the oldest first
  size_t m_line = 0;                 ///< of them, the one that is shown again; their count: none
  std::string m_answer;
  bool m_wrong = false;
  bool m_focus = false;
  bool m_emptyAndActive = false;
};

}  // namespace swaplight
