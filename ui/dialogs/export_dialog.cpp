#include "ui/dialogs/export_dialog.h"

#include <fmt/ranges.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/cue/cue_timeline.h"
#include "core/export/document_export.h"
#include "core/file/frame_range.h"
#include "core/ocio/color_config.h"
#include "core/session/version.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/manners.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr const char* kExportTitle = "Export";
constexpr float kLabel = 130;
constexpr float kField = 250;
constexpr float kSecondsField = 90;

struct KindWords {
  const char* name;
  const char* mark;
  const char* words;
  const char* ending;  ///< of the suggested name
};
constexpr std::array<KindWords, 7> kKinds = {
    {{"Frame", "frame", "The relit picture.", ""},
     {"Lights as layers", "layers",
      "Every light at its current setting as a layer, for Nuke, Resolve or Blender. The layers add up to the "
      "frame.",
      "_lights"},
     {"Beta maps", "beta", "Each light's share of every pixel, for an image editor.", "_beta"},
     {"Look", "look",
      "The part of the look that is the same for every pixel: one gain per channel, and the view. What a "
      "single light does cannot be stored in a LUT.",
      "_look"},
     {"Report", "report", "A printable page about the set and its lighting.", "_report"},
     {"Cues", "sequence",
      "The cue list as numbered frames: lights and light edits fade as they are played. View and camera look "
      "are those of now.",
      ".####"},
     {"Versions", "sheet",
      "A contact sheet of the gallery: every look and version as a picture, with its name and note.",
      "_versions"}}};

struct Choice {
  const char* value;
  const char* words;
};

void label(const char* words) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words);
  ImGui::SameLine(px(kLabel));
}

/// A list with a label; the chosen one's value is kept.
template <size_t N>
void list(const char* words, const char* mark, const std::array<Choice, N>& choices, std::string& value,
          const char* tip) {
  label(words);
  const auto chosen =
      std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return value == c.value; });
  ImGui::SetNextItemWidth(px(kField));
  const std::string id = std::string("##") + mark;
  const bool open = ImGui::BeginCombo(id.c_str(), chosen == choices.end() ? value.c_str() : chosen->words);
  markItem({"export.", mark});
  if (!open) {
    tooltip(tip);
    return;
  }
  for (const Choice& choice : choices) {
    if (ImGui::Selectable(choice.words, value == choice.value)) value = choice.value;
    markItem({"export.", mark, ".", choice.value});
  }
  ImGui::EndCombo();
}

void check(const char* words, const char* mark, bool* value, const char* tip) {
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SameLine(px(kLabel));
  ImGui::Checkbox(words, value);
  markItem({"export.", mark});
  tooltip(tip);
}

}  // namespace

ExportDialog::ExportDialog(fs::path memory)
    : m_memory(std::move(memory)), m_choices(readExportChoices(m_memory)) {}

void ExportDialog::open(const std::string& name, const fs::path& folder, std::optional<ExportKind> kind,
                        std::vector<fs::path> inputs) {
  m_inputs = std::move(inputs);
  m_open = true;
  m_focus = true;
  m_name = name;
  if (kind) m_choices.kind = *kind;
  std::error_code error;
  if (m_choices.folder.empty() || !fs::is_directory(m_choices.folder, error)) m_choices.folder = folder;
  suggest();
}

void ExportDialog::setFile(const fs::path& file) {
  take(file.string());
  m_focus = true;
}

void ExportDialog::suggest() {
  const KindWords& kind = kKinds.at(static_cast<size_t>(m_choices.kind));
  const auto named = [&](const std::string& ending) {
    return (m_choices.folder / (m_name + ending + m_choices.format())).string();
  };
  m_file = named(kind.ending);
  if (isInput(m_file)) m_file = named(std::string("_frame") + kind.ending);
}

bool ExportDialog::isInput(const fs::path& file) const {
  return std::any_of(m_inputs.begin(), m_inputs.end(), [&](const fs::path& input) {
    std::error_code error;  // what is not there is no other file
    return fs::equivalent(file, input, error) && !error;
  });
}

/// A file's name as typed; its extension chooses the format.
void ExportDialog::take(const std::string& file) {
  m_file = file;
  const std::vector<std::string>& known = formatsOf(m_choices.kind);
  const std::string extension = lowerExtension(file);
  if (std::find(known.begin(), known.end(), extension) != known.end()) m_choices.format() = extension;
}

std::string ExportDialog::mistake() const {
  const fs::path file = m_file;
  std::error_code error;
  if (!file.has_filename()) return "Enter a file name.";
  if (!fs::is_directory(file.has_parent_path() ? file.parent_path() : fs::path("."), error))
    return "There is no folder " + file.parent_path().string();
  if (m_choices.kind == ExportKind::Sheet && m_galleryEmpty)
    return "The gallery is empty: keep looks (Shift+K) or versions (Shift+V) first.";
  if (m_choices.kind == ExportKind::Sequence && !m_cueMistake.empty()) return m_cueMistake;
  if (m_choices.kind == ExportKind::Sequence && !hasFrameNumber(m_file))
    return "The name needs a place for the frame's number: name.####.exr";
  const std::vector<std::string>& known = formatsOf(m_choices.kind);
  if (std::find(known.begin(), known.end(), lowerExtension(file)) == known.end())
    return "The name must end in " + fmt::format("{}", fmt::join(known, ", ")) + ".";
  if (std::any_of(m_written.begin(), m_written.end(), [&](const fs::path& f) { return isInput(f); }))
    return "This file is part of the set and would be lost. Enter another name.";
  return {};
}

void ExportDialog::drawKinds() {
  for (size_t i = 0; i < kKinds.size(); ++i) {
    const auto kind = static_cast<ExportKind>(i);
    const bool chosen = m_choices.kind == kind;
    if (i > 0) ImGui::SameLine(0, px(4));
    pushChosen(chosen);
    const bool clicked = ImGui::Button(kKinds.at(i).name);
    popChosen();
    markItem({"export.kind.", kKinds.at(i).mark});
    tooltip(kKinds.at(i).words);
    if (clicked && !chosen) {
      m_choices.kind = kind;
      suggest();
    }
  }
  ImGui::PushTextWrapPos(0);
  hint(kKinds.at(static_cast<size_t>(m_choices.kind)).words);
  ImGui::PopTextWrapPos();
  ImGui::Dummy(ImVec2(0, px(6)));
}

void ExportDialog::drawFormats() {
  const std::vector<std::string>& formats = formatsOf(m_choices.kind);
  if (formats.size() < 2) return;
  label("Format");
  for (const std::string& format : formats) {
    if (&format != formats.data()) ImGui::SameLine(0, px(12));
    if (ImGui::RadioButton(format.substr(1).c_str(), m_choices.format() == format)) {
      m_choices.format() = format;
      m_file = fs::path(m_file).replace_extension(format).string();
    }
    markItem({"export.format", format});
    tooltip("The file's format; its name ends so.");
  }
}

void ExportDialog::drawColorSpaces() {
  static constexpr std::array<Choice, 4> kSpaces = {{{"", "Same as the set"},
                                                     {"lin_rec709", "linear Rec.709"},
                                                     {"acescg", "ACEScg"},
                                                     {"aces2065_1", "ACES2065-1"}}};
  list("Colour space", "space", kSpaces, m_choices.colorSpace,
       "Scene-linear, in these primaries; white stays white (Bradford adaptation).");
}

void ExportDialog::drawFrame(const ColorConfig& config, const Document& document) {
  drawFormats();
  const std::string& format = m_choices.format();
  const bool sequence = m_choices.kind == ExportKind::Sequence;
  if (sequence) drawTiming(document);
  if (format == ".exr")
    check("32-bit float", "float", &m_choices.floatFrame,
          "Instead of half float, which holds values up to 65504.");
  if (format == ".png" || format == ".tif")
    check("16 bits", "sixteen", &m_choices.sixteenBits, "Instead of 8 bits per channel.");
  if (isSceneLinear("frame" + format)) {
    drawColorSpaces();
    return;
  }
  static constexpr std::array<Choice, 4> kTones = {{{"", "the view"},
                                                    {"drago", "Drago: adaptive logarithm"},
                                                    {"mantiuk", "Mantiuk: contrast"},
                                                    {"reinhard", "Reinhard: as the eye adapts"}}};
  if (sequence)
    label("View");
  else
    list("View", "tone", kTones, m_choices.tone,
         "The viewer's display and view, or a tone mapping of the whole picture (plain sRGB).");
  if (m_choices.tone.empty() || sequence) {
    const DisplayChoice seen = namedDisplay(config, displayWithin(config, document.display));
    if (!sequence) ImGui::Dummy(ImVec2(0, 0));
    if (!sequence) ImGui::SameLine(px(kLabel));
    hint(displayWords(seen));
  }
}

void ExportDialog::drawTiming(const Document& document) {
  label("Frames per s");
  ImGui::SetNextItemWidth(px(kSecondsField));
  if (ImGui::InputFloat("##fps", &m_choices.framesPerSecond, 0, 0, "%g"))
    m_choices.framesPerSecond = std::clamp(m_choices.framesPerSecond, 1.F, kMostRate);
  markItem("export.fps");
  tooltip("How many frames make a second of the cues' times.");
  label("Hold");
  ImGui::SetNextItemWidth(px(kSecondsField));
  if (ImGui::InputFloat("##hold", &m_choices.holdSeconds, 0, 0, "%g s"))
    m_choices.holdSeconds = std::clamp(m_choices.holdSeconds, 0.F, kMostCueSeconds);
  markItem("export.hold");
  tooltip("How long a cue stands that waits for GO. Cues with a follow time stand that long.");
  try {
    const CueTiming timing = requestOf(m_choices, m_file).timing;
    const CueTimeline timeline(document.cues, document.looks, stageOfDocument(document), timing);
    ImGui::SameLine(0, px(12));
    hint(fmt::format("{} cues, {} frames", document.cues.size(), timeline.lastFrame()));
    m_cueMistake.clear();
  } catch (const InputError& error) {
    m_cueMistake = error.what();
  }
}

void ExportDialog::drawLayers() {
  static constexpr std::array<Choice, 3> kNaming = {{{"one", "Single part"},
                                                     {"multi", "Multi-part, one per light"},
                                                     {"blender", "Blender's light groups"}}};
  static constexpr std::array<Choice, 6> kCompressions = {{{"zip", "ZIP"},
                                                           {"zips", "ZIPS (one line)"},
                                                           {"piz", "PIZ"},
                                                           {"dwaa", "DWAA (lossy)"},
                                                           {"dwab", "DWAB (lossy)"},
                                                           {"none", "none"}}};
  list("Written as", "naming", kNaming, m_choices.naming,
       "Every program reads a single part; multi-part is faster when only one light is read.");
  list("Compression", "compression", kCompressions, m_choices.compression, "ZIP is lossless.");
  drawColorSpaces();
  check("32-bit float", "float_layers", &m_choices.floatLayers,
        "Layers then add up to the frame exactly; in half float, to within rounding.");
  check("Include beta maps", "beta", &m_choices.beta, "Each light's share of the pixel, as 32-bit float.");
  check("Include highlights", "highlights", &m_choices.highlights,
        "What of each light is highlight, as a layer LIGHT.spec, where the set knows it.");
  check("Include quality", "quality", &m_choices.quality, "The solver's residual, standard error and flags.");
}

void ExportDialog::drawCameraLook(const Document& document) {
  const FilterPipeline& look = document.cameraLook;
  if (!hasPictures(m_choices.kind) || look.stages.empty()) return;
  const bool layers = m_choices.kind == ExportKind::Layers;
  check(((layers ? "Layer of the camera look: " : "Camera look: ") + look.name).c_str(), "camera_look",
        &m_choices.cameraLook,
        layers ? "Adds the picture under the camera look as a layer of its own; it is no part of the sum."
               : "With the camera look, as the viewer shows it; off: the plain picture.");
}

void ExportDialog::drawGrade(const Document& document) {
  const bool frames = m_choices.kind == ExportKind::Frame || m_choices.kind == ExportKind::Sequence;
  if (!document.display.actingGrade()) return;
  if (m_choices.kind == ExportKind::Layers)
    hint("The layers are before the grade: they add up to the frame exported without it.");
  if (!frames) return;
  check("Grade", "grade", &m_choices.grade,
        "With the grade, as the viewer shows it, scene-linear files too; off: ungraded, for the .cc beside "
        "it.");
}

void ExportDialog::drawFile(const Answers& answers) {
  ImGui::Dummy(ImVec2(0, px(4)));
  label("File");
  const float more = px(34);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - more - ImGui::GetStyle().ItemSpacing.x);
  if (m_focus) ImGui::SetKeyboardFocusHere();
  m_focus = false;
  std::string typed = m_file;
  ImGui::InputText("##file", &typed, ImGuiInputTextFlags_AutoSelectAll);
  markItem("export.file");
  tooltip("Folder and name. The ending sets the format.");
  if (typed != m_file) take(typed);
  ImGui::SameLine();
  if (ImGui::Button("\u2026", ImVec2(more, 0))) answers.choose();
  markItem("export.choose");
  tooltip("Choose folder and name.");
}

void ExportDialog::drawFooter(const Document& document, const Answers& answers) {
  m_written = exportedFiles(document, m_choices.kind, m_file);
  const std::string wrong = mistake();
  const bool exists =
      wrong.empty() && std::any_of(m_written.begin(), m_written.end(), [](const fs::path& file) {
        std::error_code error;  // what cannot be looked at is said when it is written
        return fs::exists(file, error);
      });
  ImGui::Dummy(ImVec2(0, px(4)));
  ImGui::AlignTextToFramePadding();
  const char* replaces = m_choices.kind == ExportKind::Sequence ? "Frames exist and will be replaced."
                         : m_written.size() > 1                 ? "Files exist and will be replaced."
                                                                : "The file exists and will be replaced.";
  const float button = px(110);
  const float buttons = ImGui::GetContentRegionMax().x - 2 * button - ImGui::GetStyle().ItemSpacing.x;
  ImGui::PushTextWrapPos(buttons - px(8));
  hint(!wrong.empty() ? wrong : exists ? replaces : "");
  ImGui::PopTextWrapPos();
  ImGui::SameLine(buttons);
  const bool go = defaultButton(exists ? "Replace" : "Export", button, wrong.empty());
  markItem("export.accept");
  ImGui::SameLine();
  const bool cancelled = cancelButton("Cancel", button);
  markItem("export.cancel");
  if (go) accept(answers);
  if (cancelled) m_open = false;
  if (!wrong.empty() && dialogAccepted()) m_focus = true;  // the name has to be typed again
}

void ExportDialog::accept(const Answers& answers) {
  m_open = false;
  m_choices.folder = fs::absolute(m_file).parent_path();
  writeExportChoices(m_choices, m_memory);
  answers.accept(requestOf(m_choices, m_file));
}

void ExportDialog::draw(const ColorConfig& config, const Document& document, const Answers& answers) {
  if (!m_open) return;
  if (!ImGui::IsPopupOpen(kExportTitle)) ImGui::OpenPopup(kExportTitle);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  // By its upper edge: the kinds differ in height, and their tabs stay below the pointer.
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y * 0.2F), ImGuiCond_Always, ImVec2(0.5F, 0));
  ImGui::SetNextWindowSize(ImVec2(std::min(px(640), screen.x - px(40)), 0));
  if (!ImGui::BeginPopupModal(
          kExportTitle, nullptr,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return;
  m_galleryEmpty = document.looks.empty();
  beginTabStops();
  drawKinds();
  if (m_choices.kind == ExportKind::Frame || m_choices.kind == ExportKind::Sequence)
    drawFrame(config, document);
  else if (m_choices.kind == ExportKind::Layers)
    drawLayers();
  else
    drawFormats();
  drawCameraLook(document);
  drawGrade(document);
  drawFile(answers);
  drawFooter(document, answers);
  if (!m_open) ImGui::CloseCurrentPopup();
  endTabStops();
  ImGui::EndPopup();
}

}  // namespace swaplight
