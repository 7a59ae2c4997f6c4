#include "app/arguments/sequence_arguments.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/export/cue_frames.h"
#include "core/export/frame_sequence.h"
#include "core/export/provenance.h"
#include "core/export/timecode.h"
#include "core/file/frame_range.h"
#include "core/file/json_file.h"
#include "core/session/version.h"

namespace swaplight {
namespace {

using State = FrameOutcome::State;

std::optional<int> environmentNumber(const char* name) {
  const char* text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  if (!text || *text == '\0') return std::nullopt;
  return std::atoi(text);  // NOLINT(cert-err34-c)
}

/// The part of an array job that this task is: its index and the count of tasks.
std::optional<std::pair<int, int>> slurmTask() {
  const auto id = environmentNumber("SLURM_ARRAY_TASK_ID");
  const auto count = environmentNumber("SLURM_ARRAY_TASK_COUNT");
  if (!id || !count) return std::nullopt;
  const int first = environmentNumber("SLURM_ARRAY_TASK_MIN").value_or(0);
  const int step = std::max(1, environmentNumber("SLURM_ARRAY_TASK_STEP").value_or(1));
  return std::pair((*id - first) / step, *count);
}

double peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Opens what each frame is made of: one set for all, or a set a frame.
class Inputs {
 public:
  /// `firstFrame`: the one that the photographs' time code belongs to.
  Inputs(const ColorConfig& config, const LightingArguments& lighting, const std::optional<Session>& session,
         int firstFrame, bool withText, const Progress& progress)
      : m_config(config),
        m_lighting(lighting),
        m_session(session),
        m_firstFrame(firstFrame),
        m_animation(lighting.animation(session)),
        m_withText(withText) {
    const std::filesystem::path source = lighting.source(session);
    m_pattern = source.string();
    lighting.checkSolving(hasFrameNumber(m_pattern) ? std::filesystem::path(frameName(m_pattern, firstFrame))
                                                    : source);
    if (!hasFrameNumber(m_pattern)) m_shared = open(source, progress);
    if (m_shared)
      for (const auto& [light, keys] : m_animation.lights)  // say now what is wrong in a key
        for (const RigAnimation::Key& key : keys)
          static_cast<void>(rigAt(m_shared->rig, m_animation, key.frame));
  }

  [[nodiscard]] FrameInput at(int frame, const Progress& progress) const {
    FrameInput input = m_shared ? *m_shared : *open(frameName(m_pattern, frame), progress);
    input = animatedInput(std::move(input), m_animation, frame, m_firstFrame);
    if (!m_shared) input.carried = nullptr;  // each set has its own time code
    return input;
  }

  /// What is said of the set that all frames share.
  [[nodiscard]] std::vector<std::string> warnings() const {
    return m_shared ? m_shared->set->capture.warnings : std::vector<std::string>();
  }

 private:
  [[nodiscard]] std::optional<FrameInput> open(const std::filesystem::path& source,
                                               const Progress& progress) const {
    FrameInput input;
    input.set = std::make_shared<const SolvedSet>(m_lighting.openFile(m_config, source, m_session, progress));
    input.rig = m_lighting.rig(m_session, input.set->capture, input.set.get());
    if (m_withText) input.text = provenanceOf(*input.set, input.rig, source);
    return input;
  }

  const ColorConfig& m_config;
  const LightingArguments& m_lighting;
  const std::optional<Session>& m_session;
  int m_firstFrame;
  RigAnimation m_animation;
  bool m_withText;
  std::string m_pattern;
  std::optional<FrameInput> m_shared;
};

Json jsonFromSummary(const SequenceSummary& summary) {
  Json frames = Json::array();
  for (const FrameOutcome& outcome : summary.outcomes) {
    const char* state = outcome.state == State::Written   ? "written"
                        : outcome.state == State::Skipped ? "skipped"
                                                          : "failed";
    frames.push_back({{"frame", outcome.frame}, {"file", outcome.file.string()}, {"state", state}});
    if (!outcome.error.empty()) frames.back()["error"] = outcome.error;
  }
  const int written = summary.count(State::Written);
  return {{"frames", frames},
          {"written", written},
          {"skipped", summary.count(State::Skipped)},
          {"failed", summary.count(State::Failed)},
          {"seconds", summary.seconds},
          {"frames_per_second", summary.seconds > 0 ? written / summary.seconds : 0},
          {"input_share", summary.inputShare},
          {"write_share", summary.writeShare},
          {"peak_megabytes", peakMegabytes()}};
}

void sayFrame(const FrameOutcome& outcome, Terminal& terminal) {
  if (outcome.state == State::Written)
    terminal.say("Frame {} done: {}", outcome.frame, outcome.file.string());
  if (outcome.state == State::Skipped)
    terminal.say("Frame {} is there: {}", outcome.frame, outcome.file.string());
  if (outcome.state == State::Failed) terminal.complain("Frame {} failed: {}", outcome.frame, outcome.error);
}

int exitCodeOf(const SequenceSummary& summary) {
  constexpr int kSomeFailed = 1, kBadInput = 2, kMachineCouldNot = 3;
  const int failed = summary.count(State::Failed);
  if (failed == 0) return 0;
  if (failed < static_cast<int>(summary.outcomes.size())) return kSomeFailed;
  const bool machine = std::any_of(summary.outcomes.begin(), summary.outcomes.end(),
                                   [](const FrameOutcome& outcome) { return outcome.machine; });
  return machine ? kMachineCouldNot : kBadInput;
}

/// No frame may replace what any of them is made of.
void checkInputsKept(const std::vector<int>& frames, const std::string& output,
                     const LightingArguments& lighting, const std::optional<Session>& session) {
  std::vector<std::filesystem::path> inputs = lighting.inputs(session);
  const std::string source = lighting.source(session).string();
  for (const int frame : frames)
    if (hasFrameNumber(source)) inputs.emplace_back(frameName(source, frame));
  checkFrameFiles(output, frames, inputs);
}

}  // namespace

void addTimingOptions(CLI::App& verb, CueTiming& timing) {
  constexpr const char* kGroup = "Sequences";
  verb.add_option("--cue-fps", timing.framesPerSecond, "Frames a second of a cue list")
      ->type_name("N")
      ->capture_default_str()
      ->group(kGroup);
  verb.add_option("--hold", timing.holdSeconds, "How long a cue stands that no other follows by itself")
      ->type_name("SECONDS")
      ->capture_default_str()
      ->group(kGroup);
}

void SequenceArguments::addTo(CLI::App& verb) {
  constexpr const char* kGroup = "Sequences";
  verb.add_option_function<std::string>(
          "-F,--frames",
          [this](const std::string& range) {
            m_frames = range;
            m_framesGiven = true;
          },
          "Frames: 7, 1-100, 1-100x5, 1,5,10-20. FRAME, and SOURCE where each frame has a set of its own, "
          "hold the number's place: name.%04d.exr, name.####.exr")
      ->type_name("RANGE")
      ->group(kGroup);
  verb.add_flag("--cues", m_cues,
                "Play the session's cue list: SOURCE is the session; -F, where given, chooses frames of it")
      ->group(kGroup);
  addTimingOptions(verb, m_timing);
  m_timingOptions = {verb.get_option("--cue-fps"), verb.get_option("--hold")};
  const auto ofFrames = [&](CLI::Option* option) {
    m_frameOptions.push_back(option->group(kGroup));
    return option;
  };
  ofFrames(verb.add_flag("--cont", m_goOn, "Continue after a frame that fails"));
  ofFrames(verb.add_flag("--skip-existing", m_skipExisting, "Skip frames whose file already exists"));
  ofFrames(verb.add_option("--workers", m_workers, "Frames rendered in parallel"))
      ->check(CLI::Range(1, 64).description(""))
      ->type_name("N")
      ->capture_default_str();
  ofFrames(verb.add_option("--frame-index", m_index,
                           "Render only this part of the frames, counted from 0 (default: the Slurm task)"))
      ->type_name("I");
  ofFrames(verb.add_option("--frame-count", m_count, "Number of parts that the frames are split into"))
      ->type_name("N");
  ofFrames(verb.add_option("--timecode-frame", m_timecodeFrame,
                           "The frame that has the photographs' time code (default: the lowest of -F, or the "
                           "first of --cues): for farms that cut the range themselves"))
      ->type_name("N");
}

void SequenceArguments::check() const {
  for (const CLI::Option* option : m_frameOptions)
    if (option->count() > 0 && !given())
      throw InputError("{}: is of a sequence's frames: give -F 1-24 or --cues, or leave it out",
                       option->get_name());
  for (const CLI::Option* timing : m_timingOptions)
    if (timing->count() > 0 && !m_cues)
      throw InputError("{}: is of a cue list: give --cues, or leave it out", timing->get_name());
}

std::vector<int> SequenceArguments::share(const std::vector<int>& all) const {
  if (m_index.has_value() != m_count.has_value())
    throw InputError("--frame-index and --frame-count belong together: give both");
  if (m_index) return shareOfFrames(all, *m_index, *m_count);
  if (const auto task = slurmTask()) return shareOfFrames(all, task->first, task->second);
  return all;
}

FrameInput SequenceArguments::timed(FrameInput input, int frame) const {
  if (m_timecodeFrame) input.carried = withTimecode(input.set->carried, frame - *m_timecodeFrame);
  return input;
}

int SequenceArguments::run(const ColorConfig& config, const LightingArguments& lighting,
                           const std::optional<Session>& session, const std::string& output,
                           const FrameOptions& frame, Terminal& terminal) const {
  if (!hasFrameNumber(output))
    throw InputError("{}: has no place for the frame's number; write name.%04d.exr or name.####.exr", output);
  if (m_cues) return runCues(config, lighting, session, output, frame, terminal);
  if (m_timecodeFrame && hasFrameNumber(lighting.source(session).string()))
    throw InputError("--timecode-frame: every frame has a set with a time code of its own: leave it out");
  const std::vector<int> all = framesFromRange(m_frames);  // of all tasks of an array job
  checkInputsKept(share(all), output, lighting, session);
  Progress quiet;  // a line a frame is enough
  quiet.stop = terminal.progress().stop;
  const int first = *std::min_element(all.begin(), all.end());
  const Inputs inputs(config, lighting, session, first, isSceneLinear(output), terminal.progress());
  sayWarnings(inputs.warnings(), terminal);
  return runFrames(
      config, all, [&](int number) { return timed(inputs.at(number, quiet), number); }, output, frame,
      terminal);
}

int SequenceArguments::runCues(const ColorConfig& config, const LightingArguments& lighting,
                               const std::optional<Session>& session, const std::string& output,
                               const FrameOptions& frame, Terminal& terminal) const {
  lighting.takeAllFromSession("--cues");
  if (hasFrameNumber(lighting.source(session).string()))
    throw InputError("--cues: the session is of a set a frame: cues are played on one set");
  lighting.checkSolving(lighting.source(session));
  Document document = session->document;
  document.source = lighting.source(session);
  // Say what is wrong with the cues before the work.
  const CueTimeline planned(document.cues, document.looks, stageOfDocument(document), m_timing);
  std::vector<int> all;
  for (int number = planned.firstFrame(); number <= planned.lastFrame(); ++number) all.push_back(number);
  if (m_framesGiven) all = framesFromRange(m_frames);
  checkInputsKept(share(all), output, lighting, session);
  const Progress progress = terminal.progress();
  auto set = std::make_shared<const SolvedSet>(lighting.openUnedited(config, session, progress));
  sayWarnings(set->capture.warnings, terminal);
  const CueFrames frames(std::move(set), document, m_timing, isSceneLinear(output));
  for (const CueTimeline::Place& place : frames.timeline().places())
    terminal.say("Cue {} {}: stands from frame {} to {}", cueNumberText(place.cue.number), place.cue.look,
                 place.stands, place.ends);
  return runFrames(
      config, all, [&](int number) { return timed(frames.at(number), number); }, output, frame, terminal);
}

int SequenceArguments::runFrames(const ColorConfig& config, const std::vector<int>& all,
                                 const std::function<FrameInput(int)>& input, const std::string& output,
                                 const FrameOptions& frame, Terminal& terminal) const {
  const SequenceOptions options{share(all), output, frame, m_workers, m_skipExisting, m_goOn};
  Progress quiet;
  quiet.stop = terminal.progress().stop;
  const SequenceSummary summary = exportSequence(
      config, options, input, [&](const FrameOutcome& outcome) { sayFrame(outcome, terminal); }, quiet);

  const int failed = summary.count(State::Failed);
  const std::string contents = frameContents(config, output, frame);
  Json json = jsonFromSummary(summary);
  json["contents"] = contents;
  terminal.say(
      "{} of {} frames written, {} there before, {} failed; {:.2f} s, {:.2f} frames/s, {:.0f} % of the "
      "work in writing, {:.0f} MB; {}",
      summary.count(State::Written), options.frames.size(), summary.count(State::Skipped), failed,
      summary.seconds, json["frames_per_second"].get<double>(), 100 * summary.writeShare,
      json["peak_megabytes"].get<double>(), contents);
  terminal.result("", json);
  return exitCodeOf(summary);
}

}  // namespace swaplight
