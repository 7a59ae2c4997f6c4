#include "app/edit_arguments.h"
#include "app/solve_arguments.h"
#include "app/verbs.h"
#include "core/error.h"
#include "core/export/frame_export.h"
#include "core/file/atomic_file.h"
#include "core/look/look.h"
#include "core/look/rig_blend.h"
#include "core/relight/setting.h"
#include "core/session/open_source.h"
#include "core/session/session_file.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string source;
  std::vector<std::string> lights;
  std::string rig;
  std::string session;
  std::string look;
  std::optional<float> ambient;
  std::string frame;
  FrameOptions output;
  EditArguments edits;
  SolveArguments solve;
};

/// Runs `work`; what it throws begins with `where`.
template <typename Work>
void saying(const std::string& where, const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    throw InputError("{}: {}", where, error.what());
  }
}

/// The rig under a look: one of the session's, else a preset, in part or whole. Without a solved set only
/// what can be wrong is found out.
Rig withLook(const Rig& rig, const std::string& text, const std::optional<Session>& session,
             const SolvedSet* set) {
  const LookRequest request = lookRequestFromText(text);
  const SavedLook* saved = session ? findSavedLook(session->document.looks, request.name) : nullptr;
  const Rig lit =
      saved ? saved->rig : applyLook(rig, findLook(request.name), set ? LightRatios(*set) : LightRatios());
  return blendRigs(rig, lit, request.amount);
}

/// The session's rig, the rig file's, the look, and what the command line says, one over the other.
Rig rigOf(const Arguments& arguments, const std::optional<Session>& session, const Capture& capture,
          const SolvedSet* set = nullptr) {
  Rig rig = defaultRig(capture);
  if (session) saying("session", [&] { rig = rigFor(capture, session->document.rig); });
  if (!arguments.rig.empty()) saying(arguments.rig, [&] { rig = rigFor(capture, readRig(arguments.rig)); });
  if (!arguments.look.empty()) saying("--look", [&] { rig = withLook(rig, arguments.look, session, set); });
  for (const std::string& text : arguments.lights) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw InputError("--light {}: write NAME=SETTING, as key=3200K,+1st", text);
    saying("--light " + text,
           [&] { applySetting(findLight(rig, text.substr(0, equals)), text.substr(equals + 1)); });
  }
  if (arguments.ambient) rig.ambient = *arguments.ambient;
  return rig;
}

std::optional<Session> sessionOf(const Arguments& arguments) {
  if (!arguments.session.empty()) return readSession(arguments.session);
  if (isSessionFile(arguments.source)) return readSession(arguments.source);
  return std::nullopt;
}

fs::path sourceOf(const Arguments& arguments, const std::optional<Session>& session) {
  if (!arguments.source.empty() && !isSessionFile(arguments.source)) return arguments.source;
  if (session && !session->document.source.empty()) return session->document.source;
  throw InputError("say what to relight: a solved set, a capture, or a session that names one");
}

int run(const Arguments& arguments, Terminal& terminal) {
  const std::optional<Session> session = sessionOf(arguments);
  if (session)
    for (const std::string& warning : session->warnings) terminal.say("warning: {}", warning);
  const fs::path source = sourceOf(arguments, session);
  const FrameOptions output =
      session ? frameOptionsFor(session->document.display, arguments.frame, arguments.output)
              : arguments.output;

  // Say what is wrong before the work, not after it.
  checkFrame(arguments.frame, output);
  checkWritable(arguments.frame);
  if (sourceKind(source) == SourceKind::Capture && arguments.edits.file.empty())
    static_cast<void>(rigOf(arguments, session, readCapture(sourceFile(source))));

  const Progress progress = terminal.progress();
  const SolveOptions options =
      session && !arguments.solve.given() ? session->document.solve : arguments.solve.resolve();
  const SolvedSet set = arguments.edits.applyTo(openSource(source, options, progress.part(0, 0.8f)));
  const Rig rig = rigOf(arguments, session, set.capture, &set);
  exportFrame(set, rig, arguments.frame, output, progress.part(0.8f, 1));
  const Json json{{"frame", arguments.frame}, {"source", source.string()},       {"width", set.width()},
                  {"height", set.height()},   {"color_space", set.colorSpace()}, {"rig", jsonFromRig(rig)}};
  for (const LightSetting& light : rig.lights)
    terminal.detail("  {:<12} {}", light.light, settingText(light));
  terminal.say("wrote {}, {} x {} pixels", arguments.frame, set.width(), set.height());
  terminal.result("", json);
  return 0;
}

}  // namespace

void addRelightVerb(Program& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App& verb = program.addVerb("relight", "Make a frame of a set under new lights",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("SOURCE", a->source, "A solved set, a capture (it is solved first) or a session");
  verb.add_option("-o,--output", a->frame, "The frame: EXR, HDR, PNG, TIFF or JPEG")
      ->required()
      ->type_name("FRAME");
  verb.add_option(
          "--light", a->lights,
          std::string("A light's part, more than once if need be. SETTING is a comma-joined list of ") +
              kSettingGrammar + ". A light that is not named stays unit white")
      ->type_name("NAME=SETTING")
      ->allow_extra_args(false);
  verb.add_option("--rig", a->rig, "A rig of lights (JSON)")->type_name("FILE");
  verb.add_option("--session", a->session, "Take the rig, the view and, without SOURCE, the set of a session")
      ->type_name("FILE");
  verb.add_option("--look", a->look,
                  "A look: one that the session holds, or high-key, low-key, rembrandt, silhouette, "
                  "day-for-night, cool-morning, golden-hour, moonlight, candle, neon; with an amount from 0 "
                  "to 1 after a colon. Lights that --light names are set after it")
      ->type_name("NAME[:AMOUNT]");
  a->edits.addTo(verb);
  verb.add_option("--ambient", a->ambient, "Factor on what no light explains (default: 1)")
      ->check(CLI::Range(0.0, 1e9).description(""))
      ->type_name("X");
  verb.add_option("--view", a->output.view, "A view of the colour configuration")->type_name("NAME");
  verb.add_option("--display", a->output.display, "A display of the colour configuration")->type_name("NAME");
  verb.add_flag("--linear", a->output.linear, "Scene-linear pixels, whatever the format");
  verb.add_option("--type", a->output.write.pixelType,
                  "half, float, uint8 or uint16 (default: as the format has it)")
      ->type_name("TYPE");
  a->solve.addTo(verb);
}

}  // namespace swaplight
