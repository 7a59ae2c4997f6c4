#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace swaplight {

/// The photographs that a verb does without.
inline void addLeaveOut(CLI::App& verb, std::vector<std::string>& files) {
  verb.add_option("--leave-out", files,
                  "Do without these photographs; they are noted as left out; may be repeated")
      ->type_name("FILE,FILE")
      ->delimiter(',')
      ->allow_extra_args(false);
}

}  // namespace swaplight
