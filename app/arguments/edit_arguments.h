#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/program/program.h"
#include "core/edit/stack/edit.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// The option that edits a set before it is used.
struct EditArguments {
  std::string file;

  void addTo(CLI::App& verb);
  /// The file and those that its edits read: nothing may be written over them. Throws InputError as readEdits
  /// does.
  [[nodiscard]] std::vector<std::filesystem::path> inputs() const;
  /// The set with a session's edits, if it has any, and the file's after them. Throws InputError that begins
  /// with the file, or the session's.
  [[nodiscard]] SolvedSet applyTo(SolvedSet set, const EditStack& session = {},
                                  const std::string& sessionFile = {}) const;
  /// The same of a set that is used otherwise, too; without edits it is that set.
  [[nodiscard]] std::shared_ptr<const SolvedSet> applyTo(const std::shared_ptr<const SolvedSet>& set,
                                                         const EditStack& session,
                                                         const std::string& sessionFile) const;

 private:
  [[nodiscard]] bool leavesAlone(const EditStack& session) const {
    return file.empty() && session == EditStack{};
  }
  [[nodiscard]] SolvedSet edited(const std::shared_ptr<const SolvedSet>& set, const EditStack& session,
                                 const std::string& sessionFile) const;
};

}  // namespace swaplight
