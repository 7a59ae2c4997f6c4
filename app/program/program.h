#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <list>
#include <string>

#include "app/program/terminal.h"

namespace swaplight {

/// The program: its verbs, and the one place where an error becomes a line and an exit code.
class Program {
 public:
  Program();

  /// What a verb does; its result is the exit code.
  using Run = std::function<int(Terminal& terminal)>;

  /// Adds a verb with the options that every verb has. The caller adds the verb's own to what is returned.
  CLI::App& addVerb(const std::string& name, const std::string& description, Run run);

  /// Exit codes: 0 done, 1 done but not all of it, 2 bad input, 3 out of resources, 130 interrupted.
  int run(int argc, const char* const* argv);

 private:
  struct Verb {
    CLI::App* app;
    CommonOptions options;
    Run run;
  };
  int runVerb(Verb& verb);
  [[nodiscard]] std::string verbNames() const;

  CLI::App m_app;
  std::list<Verb> m_verbs;  // CLI11 keeps pointers to the options
};

}  // namespace swaplight
