#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments/edit_arguments.h"
#include "app/arguments/solve_arguments.h"
#include "app/program/program.h"
#include "core/base/json_fwd.h"
#include "core/ocio/color_config.h"
#include "core/relight/rig.h"
#include "core/relight/rig_animation.h"
#include "core/session/session_file.h"

namespace swaplight {

/// A set and the light that is put on it, as every verb that makes pictures of a set takes them: a solved
/// set, a capture or a session, and over it the rig of a session, of a file, and what the command line says.
class LightingArguments {
 public:
  void addTo(CLI::App& verb);

  /// The session that is named, or is the source itself; with the version that --look names. Throws
  /// InputError.
  [[nodiscard]] std::optional<Session> session() const;
  /// The colour configuration of $OCIO, else that of the session, else the built-in one. Throws InputError.
  [[nodiscard]] static std::shared_ptr<const ColorConfig> colors(const std::optional<Session>& session);
  /// The set's file. Throws InputError where nothing names one.
  [[nodiscard]] std::filesystem::path source(const std::optional<Session>& session) const;
  /// The rig of the session, that of the rig file, the look, and the command line's lights, one over the
  /// other. Without a solved set only what can be wrong is found out. Throws InputError that begins with
  /// where the mistake is.
  [[nodiscard]] Rig rig(const std::optional<Session>& session, const Capture& capture,
                        const SolvedSet* set = nullptr) const;
  /// The primaries to work in: as the command line says, else as the session does.
  [[nodiscard]] std::string workingSpace(const std::optional<Session>& session) const;
  /// Throws InputError where the command line says how to solve a file that is solved.
  void checkSolving(const std::filesystem::path& file) const;
  /// How a capture is solved: as the command line says, else as the session does.
  [[nodiscard]] SolveOptions solveOptions(const std::optional<Session>& session) const;
  /// Says what is wrong with the rig or the working space of one frame before a capture is solved, where that
  /// can be known; and that keyframes are for sequences.
  void check(const ColorConfig& config, const std::optional<Session>& session) const;
  /// How lights change over the frames of a sequence: of the session, the rig file, and the command line's
  /// keys, one over the other. Throws InputError.
  [[nodiscard]] RigAnimation animation(const std::optional<Session>& session) const;
  /// Every file that is read: none of them may be an output (core/file/same_file.h).
  [[nodiscard]] std::vector<std::filesystem::path> inputs(const std::optional<Session>& session) const;
  /// The set in the working space, edited.
  [[nodiscard]] SolvedSet open(const ColorConfig& config, const std::optional<Session>& session,
                               const Progress& progress) const;
  /// The same without edits: a cue list has its own.
  [[nodiscard]] SolvedSet openUnedited(const ColorConfig& config, const std::optional<Session>& session,
                                       const Progress& progress) const;
  /// What openUnedited() gave, with the edits of the session and the command line.
  [[nodiscard]] std::shared_ptr<const SolvedSet> edited(const std::shared_ptr<const SolvedSet>& set,
                                                        const std::optional<Session>& session) const;
  /// Throws InputError where the command line sets lights or edits, or names no session: `option` takes them
  /// from there.
  void takeAllFromSession(const std::string& option) const;
  /// Throws InputError where --ambient was given: `what` has no ambient light.
  void refuseAmbient(const char* what) const;
  /// The same from another file: a frame of a sequence.
  [[nodiscard]] SolvedSet openFile(const ColorConfig& config, const std::filesystem::path& file,
                                   const std::optional<Session>& session, const Progress& progress) const;

 private:
  [[nodiscard]] const std::string& sessionFile() const;
  /// The session of another set, for the lights of this one.
  [[nodiscard]] Session sessionOfOtherSet() const;
  /// What the rig's file holds: read once, since a shell's `<(...)` gives it once only.
  [[nodiscard]] const Json& rigFile() const;
  /// Adds to the set's warnings what the rig's file says that nothing is made of.
  void warnOfRigFile(SolvedSet& set) const;

  std::string m_source;
  std::vector<std::string> m_lights;
  std::vector<std::string> m_commands;
  std::string m_rig;
  mutable std::shared_ptr<const Json> m_rigFile;
  std::string m_session;
  std::string m_from;
  std::string m_look;
  std::string m_workingSpace;
  std::vector<std::string> m_keys;
  std::string m_between;
  std::optional<float> m_ambient;
  EditArguments m_edits;
  SolveArguments m_solve;
};

}  // namespace swaplight
