#include "app/program/program.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>

#include "app/program/interrupt.h"
#include "app/program/printable.h"
#include "app/program/standard_streams.h"
#include "core/base/machine_error.h"
#include "core/base/out_of_memory.h"
#include "core/base/parallel.h"
#include "core/base/version.h"
#include "core/diagnosis/crash_report.h"
#include "core/diagnosis/machine_facts.h"
#include "core/file/user_folders.h"
#include "core/image/io/picture_process.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kBadInput = 2;
constexpr int kOutOfResources = 3;
constexpr int kMostThreads = 1024;
constexpr const char* kTrustPictures = "--trust-pictures";
constexpr const char* kNoMemory = "out of memory; close other programs, or work at a smaller size";

/// A message may quote a number of 100,000 digits, or 2,000 names: its beginning and its end say enough.
std::string shortened(const std::string& message) {
  constexpr size_t kLongest = 2000, kEnd = 500;
  if (message.size() <= kLongest) return message;
  return fmt::format("{} ... ({} characters left out) ... {}", message.substr(0, kLongest - kEnd),
                     message.size() - kLongest, message.substr(message.size() - kEnd));
}

int fail(int code, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  sayOnStandardError("swaplight: " + printable(shortened(message)) + "\n");
  return code;
}

/// A signal cuts short whatever waits for another process: that it failed is no news then.
int failUnlessStopped(int code, const std::string& message) {
  return interrupted() ? fail(interruptExitCode(), "stopped") : fail(code, message);
}

}  // namespace

Program::Program() : m_app("Relight a set that has already been photographed.", "swaplight") {
  m_app.set_version_flag("--version", std::string("swaplight ") + version());
  m_app.require_subcommand(0, 1);
  m_app.footer("`swaplight VERB --help` shows a verb's options.");
}

CLI::App& Program::addVerb(const std::string& name, const std::string& description, Run run) {
  CLI::App* app = m_app.add_subcommand(name, description);
  app->footer("");
  Verb& verb = m_verbs.emplace_back(Verb{app, {}, std::move(run)});
  app->add_flag("--json", verb.options.json, "Print one JSON object on standard output")->group("Common");
  app->add_flag("-q,--quiet", verb.options.quiet, "Only errors on standard error")->group("Common");
  app->add_flag("-v,--verbose", verb.options.verbose, "Print details")->group("Common");
  app->add_option("--threads", verb.options.threads, "Number of threads (default: one per core)")
      ->check(CLI::Range(0, kMostThreads).description(""))
      ->type_name("N")
      ->group("Common");
  app->add_flag(kTrustPictures)
      ->description(
          "Decode pictures in this process: for farms that see only their own ($SWAPLIGHT_TRUST_PICTURES)")
      ->envname("SWAPLIGHT_TRUST_PICTURES")
      ->group("Common");
  return *app;
}

std::string Program::verbNames() const {
  std::string names;
  for (const Verb& verb : m_verbs) names += (names.empty() ? "" : ", ") + verb.app->get_name();
  return names;
}

int Program::run(int argc, const char* const* argv) {
  const auto isNamed = [&](const Verb& verb) { return verb.app->get_name() == argv[1]; };
  if (argc > 1 && argv[1][0] != '-' && std::none_of(m_verbs.begin(), m_verbs.end(), isNamed))
    return fail(kBadInput, fmt::format("there is no verb '{}'; the verbs are {}", argv[1], verbNames()));
  try {
    m_app.parse(argc, argv);
  } catch (const CLI::Success& helpOrVersion) {
    return m_app.exit(helpOrVersion);
  } catch (const CLI::ParseError& error) {
    const auto chosen = m_app.get_subcommands();
    const std::string verb = chosen.empty() ? "" : chosen.front()->get_name() + " ";
    return fail(kBadInput, fmt::format("{} (see swaplight {}--help)", error.what(), verb));
  }
  for (Verb& verb : m_verbs)
    if (verb.app->parsed()) return runVerb(verb);
  return fail(kBadInput, fmt::format("no verb given; choose one of {} (see swaplight --help)", verbNames()));
}

int Program::runVerb(Verb& verb) {
  catchInterrupts();
  try {
    // A level of processor that there is not is reported for what it is, not by the first who computes.
    static_cast<void>(processorLevel());
    std::optional<PictureProcesses> apart;  // before there are threads
    if (verb.app->count(kTrustPictures) == 0) apart.emplace();
    setThreads(verb.options.threads);
    // A studio's graphics drivers have much to say that its users are asked for.
    if (!verb.options.verbose && verb.app->get_name() != "studio") silenceLibraries();
    setCrashFact("verb", verb.app->get_name());
    setCrashFact("system", systemWords());
    setCrashFact("processor", processorWords());
    setCrashFact("pictures", pictureProcessWords());
    reportCrashes(stateFolder() / "crash", standardError());
    Terminal terminal(verb.options);
    return verb.run(terminal);
  } catch (const Stopped&) {
    return fail(interruptExitCode(), "stopped");
  } catch (const MachineError& error) {
    return failUnlessStopped(kOutOfResources, error.what());
  } catch (const InputError& error) {
    return failUnlessStopped(kBadInput, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kOutOfResources, kNoMemory);
  } catch (const ResourceError& error) {
    return fail(kOutOfResources, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return failUnlessStopped(kBadInput,
                             fmt::format("{}: {}", error.path1().string(), error.code().message()));
  } catch (const std::system_error& error) {
    return fail(kOutOfResources, fmt::format("the system refuses (threads, memory): {}", error.what()));
  } catch (const std::exception& error) {
    if (isOutOfMemory(error)) return fail(kOutOfResources, kNoMemory);
    return fail(kOutOfResources, fmt::format("something failed that should not: {}", error.what()));
  }
}

}  // namespace swaplight
