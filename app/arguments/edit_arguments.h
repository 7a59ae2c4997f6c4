#pragma once

#include <memory>
#include <string>

#include "app/program/program.h"
#include "core/edit/stack/edit.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// The option that edits a set before it is used.
struct EditArguments {
  std::string file;

  void addTo(CLI::App& verb);
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
