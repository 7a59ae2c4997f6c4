#include "ui/grade/grade_actions.h"

#include "core/base/error.h"
#include "core/ocio/grade_file.h"
#include "ui/grade/grade_edit.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

void loadGrade(ViewerContext& studio, const fs::path& file) try {
  setGrade(studio.editor, "Grade: " + file.filename().string(), readGrade(fs::absolute(file)), false);
  studio.layout.grade = true;
} catch (const InputError& error) {
  studio.messages.error(error.what());
}

void saveGrade(ViewerContext& studio, const fs::path& file) try {
  writeGrade(gradeOf(studio.document()), file,
             "Swaplight: the finished frame, in " + studio.colors.config()->gradingSpace());
  studio.messages.info("Saved " + file.string());
} catch (const std::exception& error) {
  studio.messages.error(error.what());
}

}  // namespace

bool takeDroppedGrade(ViewerContext& studio, const fs::path& file) {
  if (!studio.set() || !isGradeFile(file)) return false;
  loadGrade(studio, file);
  return true;
}

void addGradeActions(ActionTable& actions, ViewerContext& studio, FileChooser& chooser) {
  const auto open = [&studio] { return studio.set() != nullptr; };
  const auto has = [&studio, open] { return open() && gradeOf(studio.document()) != ColorGrade{}; };
  actions.add({"grade.switch", "Grade on", "Shift+G",
               "See the picture with its grade, or without. Exports follow.",
               [&studio] {
                 ColorGrade grade = gradeOf(studio.document());
                 grade.on = !grade.on;
                 setGrade(studio.editor, grade.on ? "Grade on" : "Grade off", grade, false);
               },
               has, [&studio] { return gradeOf(studio.document()).on; }});
  actions.add({"grade.reset", "Reset the grade", "", "Lift, gamma, gain and saturation that change nothing.",
               [&studio] { setGrade(studio.editor, "Reset the grade", {}, false); }, has});
  actions.add({"grade.load", "Load a grade \u2026", "",
               "Take the grade of an ASC CDL: .cc, .ccc (its first) or .cdl.",
               [&studio, &chooser] {
                 chooser.ask({"A colour correction (ASC CDL)",
                              "Load",
                              {".cc", ".ccc", ".cdl"},
                              false,
                              "",
                              {},
                              [&studio](const fs::path& file) { loadGrade(studio, file); }});
               },
               open});
  actions.add({"grade.save", "Save the grade \u2026", "",
               "Write the grade as an ASC CDL for other programs: .cc, .ccc or .cdl.",
               [&studio, &chooser] {
                 chooser.ask({"Save the grade (ASC CDL)",
                              "Save",
                              {".cc", ".ccc", ".cdl"},
                              true,
                              "grade.cc",
                              {},
                              [&studio](const fs::path& file) { saveGrade(studio, file); }});
               },
               has});
}

}  // namespace swaplight
