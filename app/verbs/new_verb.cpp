#include <algorithm>
#include <sstream>

#include "app/arguments/flat_arguments.h"
#include "app/arguments/leave_out_argument.h"
#include "app/arguments/place_text.h"
#include "app/arguments/told_charts.h"
#include "app/program/description.h"
#include "app/verbs/verbs.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/left_out.h"
#include "core/capture/no_such_light.h"
#include "core/capture/response_curve.h"
#include "core/image/cropped_image.h"
#include "core/intake/capture_draft.h"
#include "core/intake/rotation_guess.h"
#include "core/ocio/chosen_config.h"
#include "core/solve/causes/linearity.h"
#include "core/solve/model/crossed_shots.h"

namespace swaplight {
namespace {

struct NewCommand {
  std::string folder;
  std::string lights;
  std::string gels;
  std::string colors;
  std::string files;
  std::vector<std::string> leftOut;
  std::vector<std::string> shots;
  std::vector<std::string> cards;
  std::string rotation = "guess";
  std::string exposures;
  std::string crossed;
  bool oneAtATime = false;
  std::string colorSpace;
  std::string response;
  FlatArguments flats;
  std::string crop;
  double scale = 1;
  bool force = false;
};

std::vector<std::string> partsOf(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

/// NAME=REST; `option` and `form` are for the message.
std::pair<std::string, std::string> pairOf(const std::string& text, const char* option, const char* form) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos) throw InputError("{} {}: write {}", option, text, form);
  return {text.substr(0, equals), text.substr(equals + 1)};
}

/// The colours that the lights had in the first shot, one a light.
std::vector<ShotColor> ringOf(const NewCommand& arguments) {
  std::vector<ShotColor> ring = shotColorsFromText(arguments.gels);
  for (ShotColor& color : shotColorsFromText(arguments.colors)) ring.push_back(std::move(color));
  return namedUnknowns(std::move(ring));
}

/// Of each lighting: how many of its kind, crossed or not, came before. The same lightings are photographed
/// through both filters, in the same order.
std::vector<size_t> turnsOf(const CaptureDraft& draft) {
  std::vector<size_t> turns;
  size_t counts[2] = {0, 0};
  for (size_t k = 0; k < draft.lightings(); ++k) {
    const std::string& file = draft.folder.shots[k * static_cast<size_t>(draft.brackets.length)].file;
    turns.push_back(counts[draft.crossed.contains(file)]++);
  }
  return turns;
}

/// Every colour the same step on in every lighting.
std::vector<int> steadySteps(const CaptureDraft& draft, int step) {
  std::vector<int> steps;
  const auto count = static_cast<int>(draft.lights.size());
  for (const size_t turn : turnsOf(draft)) steps.push_back(static_cast<int>(turn) * (step + count) % count);
  return steps;
}

/// As the crossed photographs tell, which have no highlights; all, where none is crossed.
RotationGuess guessOf(const CaptureDraft& draft, const CapturePixels& pixels,
                      const std::vector<ShotColor>& ring) {
  if (draft.crossed.empty()) return guessRotation(draft, pixels, ring);
  CaptureDraft crossed = draft;
  std::erase_if(crossed.folder.shots,
                [&](const FoundShot& shot) { return !draft.crossed.contains(shot.file); });
  crossed.colors.resize(crossed.folder.shots.size());
  RotationGuess guess = guessRotation(crossed, copiedShots(captureOf(draft), true, pixels), ring);
  std::vector<int> steps;
  for (const size_t turn : turnsOf(draft)) {
    if (turn >= guess.steps.size())
      throw InputError(
          "--crossed: there are more of the other photographs: how the colours moved cannot be guessed. Say "
          "it "
          "with --rotation or --shot");
    steps.push_back(guess.steps[turn]);
  }
  guess.steps = std::move(steps);
  return guess;
}

/// Fills in the ring's colours; returns how it was decided which light had which, in words.
std::string placeRing(const NewCommand& arguments, const std::vector<ShotColor>& ring,
                      const CapturePixels& pixels, CaptureDraft& draft) {
  const bool known =
      std::all_of(ring.begin(), ring.end(), [](const ShotColor& c) { return c.color.has_value(); });
  if (ring.size() != draft.lights.size())
    throw InputError("--gels, --colors: {} colours for {} lights: give one a light, as in the first shot",
                     ring.size(), draft.lights.size());
  if (arguments.rotation == "guess" && known) {
    const RotationGuess guess = guessOf(draft, pixels, ring);
    draft = withRotation(draft, ring, guess.steps);
    return guess.words;
  }
  if (arguments.rotation != "guess" && arguments.rotation != "forward" && arguments.rotation != "back")
    throw InputError("--rotation: '{}' is not known; known are guess, forward, back", arguments.rotation);
  const bool back = arguments.rotation == "back";
  draft = withRotation(draft, ring, steadySteps(draft, back ? -1 : 1));
  if (arguments.rotation == "guess")
    return "assumed, because a colour is unknown: from shot to shot a light takes the colour of the next one";
  return back ? "as told: from shot to shot a light takes the colour of the one before"
              : "as told: from shot to shot a light takes the colour of the next one";
}

void placeCrossed(const NewCommand& arguments, CaptureDraft& draft) {
  if (!arguments.crossed.empty()) draft.crossed.clear();
  if (arguments.crossed == "none") return;
  for (const std::string& file : partsOf(arguments.crossed)) {
    const auto& shots = draft.folder.shots;
    if (std::none_of(shots.begin(), shots.end(), [&](const FoundShot& shot) { return shot.file == file; }))
      throw InputError("--crossed {}: there is no such shot in the folder", file);
    draft.crossed.insert(file);
  }
}

/// The same lighting through another filter is no other exposure.
Brackets bracketsOf(const NewCommand& arguments, const CaptureDraft& draft, const CapturePixels& pixels) {
  if (!arguments.exposures.empty()) return toldBrackets(draft.folder, arguments.exposures);
  return draft.crossed.empty() ? findBrackets(draft.folder, pixels) : Brackets{};
}

void placeOneAtATime(CaptureDraft& draft) {
  const std::vector<size_t> turns = turnsOf(draft);
  const size_t most = turns.empty() ? 0 : *std::max_element(turns.begin(), turns.end()) + 1;
  if (draft.lights.size() != most)
    throw InputError("--one-at-a-time: {} lights and {} {}: there must be one a light", draft.lights.size(),
                     most, draft.brackets.length > 1 ? "brackets" : "shots");
  for (size_t k = 0; k < draft.lightings(); ++k) {
    std::vector<ShotColor> colors;
    for (size_t i = 0; i < draft.lights.size(); ++i)
      colors.push_back(i == turns[k] ? ShotColor{"on", Rgb(1)} : ShotColor{"off", Rgb(0)});
    setLighting(draft, k, std::move(colors));
  }
}

void placeShots(const NewCommand& arguments, CaptureDraft& draft) {
  for (const std::string& text : arguments.shots) {
    const auto [file, colors] = pairOf(text, "--shot", "FILE=COLOUR,COLOUR, one colour a light");
    const auto& shots = draft.folder.shots;
    const auto found = std::find_if(shots.begin(), shots.end(),
                                    [&, name = file](const FoundShot& shot) { return shot.file == name; });
    if (found == shots.end()) throw InputError("--shot {}: there is no such shot in the folder", file);
    const std::vector<ShotColor> said = shotColorsFromText(colors);
    if (said.size() != draft.lights.size())
      throw InputError("--shot {}: {} colours for {} lights", text, said.size(), draft.lights.size());
    setLighting(draft, draft.brackets.lightingOf(static_cast<size_t>(found - shots.begin())), said);
  }
}

void placeCards(const NewCommand& arguments, const CapturePixels& pixels, CaptureDraft& draft) {
  for (const std::string& text : arguments.cards) {
    const LightPlace card = lightPlaceFromText(text, "--card");
    const size_t light = placeOfLight(draft.lights, card.light, "--card " + text);
    for (size_t k = 0; k < draft.lightings(); ++k) {
      std::vector<ShotColor> colors = draft.colors[k * static_cast<size_t>(draft.brackets.length)];
      colors[light] = colorOfCard(draft, pixels, k, card.x, card.y);
      setLighting(draft, k, std::move(colors));
    }
  }
}

/// Places given by --card are of the whole photographs: cropping comes last.
void placeFrame(const NewCommand& arguments, const CapturePixels& pixels, CaptureDraft& draft) {
  draft.frame.scale = checkedScale(arguments.scale);
  if (arguments.crop.empty()) return;
  draft.frame.crop = cropFromText(arguments.crop);
  static_cast<void>(croppedImage(pixels.shots.front(), *draft.frame.crop, draft.folder.shots.front().file));
}

Description describe(const CaptureDraft& draft, const std::filesystem::path& file, const std::string& how,
                     const std::vector<std::string>& warnings) {
  std::vector<std::vector<std::string>> rows{{"shot", "file"}};
  for (const std::string& light : draft.lights) rows.front().push_back(light);
  Json shots = Json::array();
  for (size_t k = 0; k < draft.folder.shots.size(); ++k) {
    rows.push_back({fmt::format("{}", k + 1), draft.folder.shots[k].file});
    Json colors = Json::array();
    for (const ShotColor& color : draft.colors[k]) {
      rows.back().push_back(color.text);
      colors.push_back(color.text);
    }
    shots.push_back({{"image", draft.folder.shots[k].file}, {"colors", colors}});
    if (draft.crossed.contains(draft.folder.shots[k].file)) {
      rows.back()[1] += " (crossed)";
      shots.back()["polarisation"] = "cross";
    }
  }
  Description d{tableText(rows) + "\n", Json::object()};
  if (!draft.leftOut.empty()) d.line("left out", leftOutWords(draft.leftOut));
  d.line("order", draft.folder.timed ? "of capture time" : "of file name");
  if (!draft.brackets.words.empty()) d.line("exposures", draft.brackets.words);
  if (!how.empty()) d.line("colours", how);
  for (const std::string& warning : warnings) d.line("warning", warning);
  d.json = {{"capture", file.string()},
            {"lights", draft.lights},
            {"shots", shots},
            {"left_out", imagesOf(draft.leftOut)},
            {"order", draft.folder.timed ? "time" : "name"},
            {"bracket", draft.brackets.length},
            {"exposures", draft.brackets.words},
            {"colors", how},
            {"color_space", draft.colorSpace},
            {"crop", draft.frame.crop ? Json{draft.frame.crop->x, draft.frame.crop->y,
                                             draft.frame.crop->width, draft.frame.crop->height}
                                      : Json()},
            {"scale", draft.frame.scale},
            {"warnings", warnings}};
  return d;
}

/// What the files hold, where it is told.
void placeCoding(const NewCommand& arguments, CaptureDraft& draft) {
  if (!arguments.colorSpace.empty()) draft.colorSpace = arguments.colorSpace;
  if (arguments.response.empty()) return;
  checkResponseFile(arguments.response, "--response");
  if (!arguments.colorSpace.empty())
    throw InputError("--response, --color-space: give one of them: a response is a colour space");
  draft.colorSpace = pathInManifest(draft.folder.folder, arguments.response);
}

/// With the lights of charts in place of the photographs that show them; what is to be said of those.
std::vector<std::string> readCharts(const ColorConfig& config, const CaptureDraft& draft,
                                    NewCommand& arguments, const Progress& progress) {
  std::vector<std::string> texts = arguments.shots;
  texts.insert(texts.end(), {arguments.gels, arguments.colors});
  const ToldCharts charts(config, draft.folder, draft.colorSpace, texts, progress);
  for (std::string* text : {&arguments.gels, &arguments.colors}) *text = charts.in(*text);
  for (std::string& shot : arguments.shots) shot = charts.in(shot);
  return charts.warnings();
}

int run(NewCommand arguments, Terminal& terminal) {
  const std::shared_ptr<const ColorConfig> config = programConfig();
  const Progress progress = terminal.progress();
  ShotFolder folder = scanShotFolder(*config, arguments.folder);
  if (!arguments.files.empty()) folder = withShots(*config, std::move(folder), partsOf(arguments.files));
  folder = withShotsLeftOut(std::move(folder), arguments.leftOut, "--leave-out");
  CaptureDraft draft = draftOf(folder, partsOf(arguments.lights));
  placeCoding(arguments, draft);
  placeCrossed(arguments, draft);
  for (const auto& [light, name] : arguments.flats.lamps(folder.folder)) draft.flats[light] = name;
  if (const std::string lens = arguments.flats.lens(folder.folder); !lens.empty()) draft.vignetting = lens;
  const std::vector<std::string> ofCharts = readCharts(*config, draft, arguments, progress.part(0, .3F));
  const std::vector<ShotColor> ring = ringOf(arguments);
  if (ring.empty() && !arguments.oneAtATime && arguments.shots.empty() && arguments.cards.empty())
    throw InputError(
        "say which colours the lights had: --gels L106,L119 or --colors as in the first shot, --shot "
        "FILE=COLOUR,COLOUR, --card LIGHT=X,Y, or --one-at-a-time");

  const CapturePixels pixels = loadCapturePixels(*config, captureOf(draft), progress.part(.3F, .7F));
  setBrackets(draft, bracketsOf(arguments, draft, pixels));
  std::string how;
  if (!ring.empty()) how = placeRing(arguments, ring, pixels, draft);
  if (arguments.oneAtATime) placeOneAtATime(draft);
  placeCards(arguments, pixels, draft);
  placeShots(arguments, draft);

  std::vector<std::string> warnings = folder.notes;
  for (auto&& more : {ofCharts, pictureWarnings(draft, pixels), colorWarnings(draft)})
    warnings.insert(warnings.end(), more.begin(), more.end());
  const LinearityEvidence linearity = linearityOf(captureOf(draft), pixels, progress.part(.7F, 1));
  if (linearity.answer == LinearityEvidence::Answer::Curved)
    warnings.push_back("do the photographs hold light? " + linearity.words);
  placeFrame(arguments, pixels, draft);
  const std::filesystem::path file = writeDraft(draft, arguments.force);
  Description d = describe(draft, file, how, warnings);
  d.json["linearity"] = jsonFromLinearity(linearity);
  terminal.say("wrote {}", file.string());
  terminal.result(d.text, d.json);
  return 0;
}

}  // namespace

void addNewVerb(Program& program) {
  const auto a = std::make_shared<NewCommand>();
  CLI::App& verb = program.addVerb("new", "Describe a folder of photographs: writes capture.json",
                                   [a](Terminal& terminal) { return run(*a, terminal); });
  verb.add_option("FOLDER", a->folder, "The folder with the photographs, and nothing else")->required();
  verb.add_option("--lights", a->lights, "Light names, separated by commas")
      ->required()
      ->type_name("key,fill");
  verb.add_option("--gels", a->gels,
                  "The gel of each light in the first photograph; how the gels moved is guessed")
      ->type_name("L106,L119");
  verb.add_option(
          "--colors", a->colors,
          "The same as colours: linear r/g/b, #rrggbb, 3200K, gel number, off, chart:FILE (a photograph of a "
          "Macbeth chart under it); ? or ?a: unknown")
      ->type_name("LIST");
  verb.add_option("--rotation", a->rotation,
                  "How they moved: guess (from the pictures), forward (a light takes the colour of the next "
                  "one), back")
      ->type_name("HOW")
      ->capture_default_str();
  verb.add_option(
          "--exposures", a->exposures,
          "Stops of each photograph of a bracket, over its first one; 0: no brackets (default: found)")
      ->type_name("0,-3,+2");
  verb.add_option(
          "--crossed", a->crossed,
          "Photographs through a polariser across those of the lamps, or none (default: as an existing "
          "capture.json says); the others show the highlights")
      ->type_name("FILE,FILE");
  verb.add_flag("--one-at-a-time", a->oneAtATime,
                "One light per photograph: the first light in the first one, and so on");
  verb.add_option("--shot", a->shots, "Colours of one photograph, one per light; may be repeated")
      ->type_name("FILE=COLOUR,COLOUR")
      ->allow_extra_args(false);
  verb.add_option("--card", a->cards,
                  "Pixel of a white card lit by this light only; its colours are read from it")
      ->type_name("LIGHT=X,Y")
      ->allow_extra_args(false);
  verb.add_option("--shots", a->files, "Use these files in this order, instead of all by capture time")
      ->type_name("FILE,FILE");
  addLeaveOut(verb, a->leftOut);
  verb.add_option("--color-space", a->colorSpace, "Colour space of the photographs (default: from the files)")
      ->type_name("NAME");
  verb.add_option("--response", a->response,
                  "Instead of a colour space: the camera's response, as swaplight response writes it")
      ->type_name("CURVE.csv");
  a->flats.addTo(verb);
  verb.add_option("--crop", a->crop, "Crop the photographs, in their own pixels")
      ->type_name("X,Y,WIDTH,HEIGHT");
  verb.add_option("--scale", a->scale, "Scale the photographs: 0.5 is half the width and height")
      ->type_name("X")
      ->capture_default_str();
  verb.add_flag(
      "--force", a->force,
      "Replace an existing capture.json; what it says beyond this (noise, notes of other programs) is kept");
}

}  // namespace swaplight
