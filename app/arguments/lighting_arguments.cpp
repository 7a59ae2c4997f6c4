#include "app/arguments/lighting_arguments.h"

#include <algorithm>

#include "app/program/number_range.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/look/look.h"
#include "core/look/rig_blend.h"
#include "core/ocio/chosen_config.h"
#include "core/relight/light_command.h"
#include "core/relight/setting.h"
#include "core/session/open_source.h"
#include "core/session/version.h"
#include "core/set/set_color_space.h"
#include "core/setups/other_set.h"

namespace swaplight {
namespace {

/// Runs `work`; what it throws begins with `where`.
template <typename Work>
void saying(const std::string& where, const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    throw InputError("{}: {}", where, error.what());
  }
}

/// A look of the session that is more than a lighting; nullptr where it is none.
const SavedLook* savedVersion(const Session& session, const std::string& name) {
  const SavedLook* saved = findSavedLook(session.document.looks, name);
  return saved && saved->scene ? saved : nullptr;
}

/// The rig under a look: one of the session's, else a preset, in part or whole.
Rig withLook(const Rig& rig, const std::string& text, const std::optional<Session>& session,
             const SolvedSet* set) {
  const LookRequest request = lookRequestFromText(text);
  if (session && savedVersion(*session, request.name)) return rig;  // the session has it already
  const std::vector<SavedLook> looks = session ? session->document.looks : std::vector<SavedLook>();
  const SavedLook* saved = findSavedLook(looks, request.name);
  const Rig lit =
      saved ? saved->rig
            : applyLook(rig, findLook(request.name, looks), set ? LightRatios(*set) : LightRatios());
  return blendRigs(rig, lit, request.amount);
}

constexpr const char* kAnimation = "animation";

struct RigKey {
  std::string light;
  RigAnimation::Key key;
};

RigKey keyFromText(const std::string& text) {
  const size_t at = text.find('@');
  const size_t equals = text.find('=');
  int frame = 0;
  if (at == std::string::npos || equals == std::string::npos || equals < at ||
      !CLI::detail::lexical_cast(text.substr(at + 1, equals - at - 1), frame))
    throw InputError("--key {}: write NAME@FRAME=SETTING, as key@24=3200K,+1st", text);
  return {text.substr(0, at), {frame, text.substr(equals + 1)}};
}

}  // namespace

void LightingArguments::addTo(CLI::App& verb) {
  verb.add_option("SOURCE", m_source, "A solved set, a capture (it is solved first) or a session");
  verb.add_option("--light", m_lights,
                  std::string("A light's setting; may be repeated. SETTING is a comma-separated list of ") +
                      kSettingGrammar + ". A light that is not named stays unit white")
      ->type_name("NAME=SETTING")
      ->allow_extra_args(false);
  verb.add_option("--command", m_commands,
                  std::string("A line as at a lighting desk, after the settings above; may be repeated: ") +
                      kLightCommandExamples)
      ->type_name("LINE")
      ->allow_extra_args(false);
  verb.add_option("--rig", m_rig, "A rig of lights (JSON)")->type_name("FILE");
  verb.add_option("--session", m_session, "Use a session's edits, rig and view and, without SOURCE, its set")
      ->type_name("FILE");
  verb.add_option("--from", m_from,
                  "Use a session of another set of the same lights, with --look one of its versions: its "
                  "lights by their names, and the edits that have no place in its picture")
      ->type_name("FILE");
  verb.add_option("--working-space", m_workingSpace,
                  "Working space in which lights are mixed: lin_rec709, acescg or aces2065_1 (default: the "
                  "session's, else the set's)")
      ->type_name("NAME");
  verb.add_option("--look", m_look,
                  "A look: one of the session's, or high-key, low-key, rembrandt, silhouette, day-for-night, "
                  "cool-morning, golden-hour, moonlight, candle, neon; a colon and a strength from 0 to 1 "
                  "may follow. --light overrides it")
      ->type_name("NAME[:AMOUNT]");
  verb.add_option("--key", m_keys, "A light's keyframe in a sequence; may be repeated: key@1=-2st")
      ->type_name("NAME@FRAME=SETTING")
      ->allow_extra_args(false);
  verb.add_option("--between", m_between, "Interpolation between keyframes: linear (default) or smooth")
      ->type_name("HOW");
  m_edits.addTo(verb);
  verb.add_option("--ambient", m_ambient, "Level of the ambient light (default: 1)")
      ->check(NumberRange(0.0, 1e9))
      ->type_name("X");
  m_solve.addTo(verb);
}

const std::string& LightingArguments::sessionFile() const {
  if (!m_from.empty()) return m_from;
  return m_session.empty() && isSessionFile(m_source) ? m_source : m_session;
}

Session LightingArguments::sessionOfOtherSet() const {
  if (m_source.empty() || isSessionFile(m_source) || !m_session.empty())
    throw InputError("--from {}: give the other set as SOURCE, and no --session", m_from);
  Session session = readSession(m_from);
  const std::shared_ptr<const ColorConfig> config = colors(session);
  OtherSetDocument other = documentForSet(session.document, m_source, captureOfSource(*config, m_source));
  session.document = std::move(other.document);
  for (const std::string& note : other.notes) session.warnings.push_back(m_from + ": " + note);
  return session;
}

std::optional<Session> LightingArguments::session() const {
  const std::string& file = sessionFile();
  if (file.empty()) return std::nullopt;
  Session session = m_from.empty() ? readSession(file) : sessionOfOtherSet();
  if (m_look.empty()) return session;
  const LookRequest request = lookRequestFromText(m_look);
  if (const SavedLook* look = savedVersion(session, request.name))
    session.document = recalled(session.document, *look, request.amount);
  return session;
}

std::shared_ptr<const ColorConfig> LightingArguments::colors(const std::optional<Session>& session) {
  return programConfig(session ? session->document.colorConfig : std::filesystem::path());
}

std::filesystem::path LightingArguments::source(const std::optional<Session>& session) const {
  if (!m_source.empty() && !isSessionFile(m_source)) return m_source;
  if (session && !session->document.source.empty()) return session->document.source;
  throw InputError("say what to relight: a solved set, a capture, or a session that names one");
}

const Json& LightingArguments::rigFile() const {
  if (!m_rigFile) m_rigFile = std::make_shared<const Json>(readJson(m_rig));
  return *m_rigFile;
}

void LightingArguments::warnOfRigFile(SolvedSet& set) const {
  if (!m_rig.empty()) static_cast<void>(rigFromJson(rigFile(), m_rig, &set.capture.warnings));
}

Rig LightingArguments::rig(const std::optional<Session>& session, const Capture& capture,
                           const SolvedSet* set) const {
  Rig rig = defaultRig(capture);
  if (session) saying(sessionFile(), [&] { rig = rigFor(capture, session->document.rig); });
  if (!m_rig.empty()) {
    const Rig read = rigFromJson(rigFile(), m_rig);  // names the file itself
    saying(m_rig, [&] { rig = rigFor(capture, read); });
  }
  if (!m_look.empty()) saying("--look", [&] { rig = withLook(rig, m_look, session, set); });
  for (const std::string& text : m_lights) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw InputError("--light {}: write NAME=SETTING, as key=3200K,+1st", text);
    saying("--light " + text,
           [&] { applySetting(findLight(rig, text.substr(0, equals)), text.substr(equals + 1)); });
  }
  for (const std::string& line : m_commands)
    saying("--command " + line, [&] { rig = lightCommand(rig, line).rig; });
  if (m_ambient) rig.ambient = *m_ambient;
  return rig;
}

void LightingArguments::checkSolving(const std::filesystem::path& file) const {
  m_solve.check(file);
}

SolveOptions LightingArguments::solveOptions(const std::optional<Session>& session) const {
  return session ? m_solve.resolveOver(session->document.solve) : m_solve.resolve();
}

std::string LightingArguments::workingSpace(const std::optional<Session>& session) const {
  return session && m_workingSpace.empty() ? session->document.workingSpace : m_workingSpace;
}

void LightingArguments::check(const ColorConfig& config, const std::optional<Session>& session) const {
  if (!m_keys.empty() || !m_between.empty())
    throw InputError("{}: lights change over the frames of a sequence: give relight -F 1-24, or leave it out",
                     m_keys.empty() ? "--between" : "--key " + m_keys.front());
  checkSetColorSpace(workingSpace(session));
  const std::filesystem::path set = source(session);
  checkSolving(set);
  const bool moreLights = !m_edits.file.empty() || (session && !session->document.edits.newLights.empty());
  if (sourceKind(set) == SourceKind::Capture && !moreLights)
    static_cast<void>(rig(session, readCapture(config, sourceFile(set))));
}

std::vector<std::filesystem::path> LightingArguments::inputs(const std::optional<Session>& session) const {
  std::vector<std::filesystem::path> files = filesOfSource(source(session));
  for (const std::string& file : {m_source, m_session, m_from, m_rig}) files.emplace_back(file);
  const std::vector<std::filesystem::path> edits = m_edits.inputs();
  files.insert(files.end(), edits.begin(), edits.end());
  if (session) {
    const std::vector<std::filesystem::path> read = filesOfDocument(session->document);
    files.insert(files.end(), read.begin(), read.end());
  }
  return files;
}

SolvedSet LightingArguments::open(const ColorConfig& config, const std::optional<Session>& session,
                                  const Progress& progress) const {
  return openFile(config, source(session), session, progress);
}

SolvedSet LightingArguments::openUnedited(const ColorConfig& config, const std::optional<Session>& session,
                                          const Progress& progress) const {
  SolvedSet set = openSource(config, source(session), solveOptions(session), progress);
  warnOfRigFile(set);
  return inColorSpace(config, std::move(set), workingSpace(session));
}

std::shared_ptr<const SolvedSet> LightingArguments::edited(const std::shared_ptr<const SolvedSet>& set,
                                                           const std::optional<Session>& session) const {
  return m_edits.applyTo(set, session ? session->document.edits : EditStack{}, sessionFile());
}

void LightingArguments::refuseAmbient(const char* what) const {
  if (m_ambient) throw InputError("--ambient: {} has no ambient light; leave it out", what);
}

void LightingArguments::takeAllFromSession(const std::string& option) const {
  if (sessionFile().empty())
    throw InputError("{}: cues stand in a session: give one (NAME.swaplight) as SOURCE", option);
  const bool more = !m_lights.empty() || !m_commands.empty() || !m_rig.empty() || !m_look.empty() ||
                    !m_keys.empty() || !m_between.empty() || m_ambient || !m_edits.file.empty();
  if (more)
    throw InputError(
        "{}: the session's cues set lights and edits: leave out --light, --command, --rig, --look, --key, "
        "--between, --ambient and --edits",
        option);
}

SolvedSet LightingArguments::openFile(const ColorConfig& config, const std::filesystem::path& file,
                                      const std::optional<Session>& session, const Progress& progress) const {
  SolvedSet set = openSource(config, file, solveOptions(session), progress);
  warnOfRigFile(set);
  return m_edits.applyTo(inColorSpace(config, std::move(set), workingSpace(session)),
                         session ? session->document.edits : EditStack{}, sessionFile());
}

RigAnimation LightingArguments::animation(const std::optional<Session>& session) const {
  RigAnimation animation;
  if (session && session->unknown.json().contains(kAnimation))
    animation = animationFromJson(session->unknown.json()[kAnimation], sessionFile() + ": animation");
  if (session && !m_from.empty())  // the other set's lamps
    std::erase_if(animation.lights, [&](const auto& keys) {
      const auto& lights = session->document.rig.lights;
      return keys.first != kAmbientName &&
             std::none_of(lights.begin(), lights.end(),
                          [&](const LightSetting& light) { return light.light == keys.first; });
    });
  if (!m_rig.empty()) {
    const Json& json = rigFile();
    if (json.contains(kAnimation)) animation = animationFromJson(json[kAnimation], m_rig + ": animation");
  }
  for (const std::string& text : m_keys) {
    const RigKey key = keyFromText(text);
    animation.add(key.light, key.key);
  }
  if (!m_between.empty()) saying("--between", [&] { animation.between = betweenFromName(m_between); });
  return animation;
}

}  // namespace swaplight
