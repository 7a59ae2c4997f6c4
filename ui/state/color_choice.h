#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/ocio/color_config.h"
#include "ui/jobs/messages.h"

namespace swaplight {

/// Which colour configuration the studio works with. One that cannot be used never stops it: the built-in one
/// takes its place, a message says so once and trouble() as long as it lasts. A job takes config() along when
/// it begins, and so is not touched by what is chosen while it runs.
class ColorChoice {
 public:
  ColorChoice();

  /// The one in use; never null.
  [[nodiscard]] const std::shared_ptr<const ColorConfig>& config() const { return m_config; }
  /// The one that a session's documents would be seen with, which asks for this file (empty: none); the
  /// built-in one where it cannot be used. What is in use stays.
  [[nodiscard]] std::shared_ptr<const ColorConfig> configFor(const std::filesystem::path& wanted);
  /// Takes what a session asks for; empty: nothing. $OCIO goes before it.
  void follow(const std::filesystem::path& wanted, Messages& messages);
  /// True where $OCIO decides.
  [[nodiscard]] bool fromEnvironment() const { return m_environment != nullptr; }
  /// Why the configuration is not the one asked for, in a line; empty where it is.
  [[nodiscard]] const std::string& trouble() const;

 private:
  struct Found {
    std::shared_ptr<const ColorConfig> config;
    std::string trouble;
  };
  Found find(const std::filesystem::path& wanted);

  std::shared_ptr<const ColorConfig> m_builtin;
  std::shared_ptr<const ColorConfig> m_environment;  ///< null where $OCIO names none that can be used
  /// Those that sessions have asked for, by their file: they are few, and going back to one is at once.
  std::map<std::filesystem::path, std::shared_ptr<const ColorConfig>> m_used;
  std::shared_ptr<const ColorConfig> m_config;
  std::string m_environmentTrouble;
  std::string m_sessionTrouble;
  std::filesystem::path m_wanted;
  bool m_said = false;
};

}  // namespace swaplight
