#include <array>

#include "app/arguments/lighting_arguments.h"
#include "app/arguments/sequence_arguments.h"
#include "app/program/description.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/cue/cue_command.h"
#include "core/file/json_file.h"
#include "core/file/same_file.h"
#include "core/session/version.h"

namespace swaplight {
namespace {

struct CuesCommand {
  std::string session;
  std::vector<std::string> lines;
  std::string output;
  std::string keys;
  CueTiming timing;
};

Json jsonFromPlace(const CueTimeline::Place& place) {
  return {{"first_whole_frame", place.stands}, {"last_frame", place.ends}};
}

std::string seconds(float value) {
  return fmt::format("{:g} s", value);
}

/// What the keys cannot say.
void warnOfEdits(const CueTimeline& timeline, const std::string& file, Terminal& terminal) {
  if (timeline.editsChange())
    terminal.say(
        "warning: {}: light edits change from cue to cue, which keys of lights cannot say: make "
        "the frames with relight --cues",
        file);
}

void writeKeys(const CueTimeline& timeline, const std::string& file) {
  Json json = jsonFromRig(timeline.keyedRig());
  json["animation"] = jsonFromAnimation(timeline.animation());
  writeJson(json, file);
}

int run(const CuesCommand& arguments, Terminal& terminal) {
  Session session = readSession(arguments.session);
  sayWarnings(session.warnings, terminal);
  Document& document = session.document;
  for (const std::string& line : arguments.lines) {
    try {
      document.cues = cueCommand(document.cues, document.looks, line).cues;
    } catch (const InputError& error) {
      throw InputError("--cue {}: {}", line, error.what());
    }
  }
  const std::string& output = arguments.output.empty() ? arguments.session : arguments.output;
  const std::vector<std::filesystem::path> inputs = {arguments.session, document.source, output};
  if (!arguments.keys.empty()) checkOutput(arguments.keys, inputs);
  if (!arguments.output.empty())
    checkOutput(arguments.output, std::array{std::filesystem::path(document.source)});
  if (!arguments.lines.empty() || !arguments.output.empty()) {
    writeSession(session, output);
    terminal.say("wrote {}", output);
  }
  Json cues = jsonFromCues(document.cues);
  if (document.cues.empty() && arguments.keys.empty()) {
    terminal.result("The cue list is empty.\n", {{"cues", cues}});
    return 0;
  }
  const CueTimeline timeline(document.cues, document.looks, stageOfDocument(document), arguments.timing);
  std::vector<std::vector<std::string>> rows{{"cue", "look", "fade", "follow", "stands in frames"}};
  for (size_t i = 0; i < cues.size(); ++i) {
    const CueTimeline::Place& place = timeline.places()[i];
    const Cue& cue = place.cue;
    rows.push_back({cueNumberText(cue.number), cue.look, seconds(cue.fadeSeconds),
                    cue.followSeconds ? seconds(*cue.followSeconds) : "",
                    fmt::format("{}-{}", place.stands, place.ends)});
    cues[i].update(jsonFromPlace(place));
  }
  if (!arguments.keys.empty()) {
    warnOfEdits(timeline, arguments.keys, terminal);
    writeKeys(timeline, arguments.keys);
    terminal.say("wrote {}, for relight --rig {} -F {}-{}", arguments.keys, arguments.keys,
                 timeline.firstFrame(), timeline.lastFrame());
  }
  terminal.result(tableText(rows), {{"cues", cues},
                                    {"first_frame", timeline.firstFrame()},
                                    {"last_frame", timeline.lastFrame()},
                                    {"edits_change", timeline.editsChange()}});
  return 0;
}

}  // namespace

void addCuesVerb(Program& program) {
  const auto a = std::make_shared<CuesCommand>();
  CLI::App& verb = program.addVerb("cues", "List and change a session's cues; write them as keys of lights",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("SESSION", a->session, "A session (NAME.swaplight)")->required();
  verb.add_option("--cue", a->lines,
                  std::string("A line as at a desk, without the word cue; may be repeated: 3 time 4, ") +
                      "3 follow 2, 3 look Night, 3 number 2.5, 3 remove. Writes the session")
      ->type_name("LINE")
      ->allow_extra_args(false);
  verb.add_option("-o,--output", a->output, "Write the changed session here (default: in its place)")
      ->type_name("FILE");
  verb.add_option("--keys", a->keys, "Write the lights' keys as a rig file: relight --rig FILE -F 1-100")
      ->type_name("FILE.json");
  addTimingOptions(verb, a->timing);
}

}  // namespace swaplight
