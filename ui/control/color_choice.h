#pragma once

#include <filesystem>
#include <string>

#include "ui/jobs/messages.h"

namespace swaplight {

/// Which colour configuration the studio works with. One that cannot be used never stops it: the built-in one
/// takes its place, a message says so once and trouble() as long as it lasts.
class ColorChoice {
 public:
  ColorChoice();

  /// Takes what a session asks for; empty: nothing. $OCIO goes before it.
  void follow(const std::filesystem::path& wanted, Messages& messages);
  /// Why the configuration is not the one asked for, in a line; empty where it is.
  [[nodiscard]] const std::string& trouble() const;

 private:
  std::string m_environmentTrouble;
  std::string m_sessionTrouble;
  std::filesystem::path m_wanted;
  bool m_said = false;
};

}  // namespace swaplight
