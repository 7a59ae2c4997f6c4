#pragma once

#include <string>

#include "app/program.h"
#include "core/solve/solved_set.h"

namespace swaplight {

/// The option that edits a set before it is used.
struct EditArguments {
  std::string file;

  void addTo(CLI::App& verb);
  /// The set with the edits; as it is without any. Throws InputError.
  [[nodiscard]] SolvedSet applyTo(SolvedSet set) const;
};

}  // namespace swaplight
