#include "ui/state/export_choices.h"

#include <algorithm>
#include <exception>

#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/file/json_file.h"
#include "ui/state/enum_names.h"

namespace swaplight {
namespace {

constexpr std::array<const char*, 7> kKindNames = {"frame",  "layers",   "beta", "look",
                                                   "report", "sequence", "sheet"};

/// The value where it is one of the list, else what there was.
void take(std::string& value, const std::string& found, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), found) != known.end()) value = found;
}

}  // namespace

const std::vector<std::string>& formatsOf(ExportKind kind) {
  static const std::array<std::vector<std::string>, 7> formats = {{{".exr", ".png", ".tif", ".jpg", ".hdr"},
                                                                   {".exr"},
                                                                   {".exr", ".png"},
                                                                   {".cube", ".ccc"},
                                                                   {".html"},
                                                                   {".exr", ".png", ".tif", ".jpg"},
                                                                   {".png", ".jpg", ".tif"}}};
  return formats.at(static_cast<size_t>(kind));
}

ExportRequest requestOf(const ExportChoices& choices, const std::filesystem::path& file) {
  ExportRequest request;
  request.kind = choices.kind;
  request.file = file;
  const std::string extension = lowerExtension(file);
  const bool picture = request.kind == ExportKind::Frame || request.kind == ExportKind::Sequence;
  const bool sceneLinear = picture && isSceneLinear(file);
  if (extension == ".exr" && choices.floatFrame) request.frame.write.pixelType = "float";
  if (extension == ".png" || extension == ".tif")
    request.frame.write.pixelType = choices.sixteenBits ? "uint16" : "uint8";
  if (sceneLinear) request.frame.colorSpace = choices.colorSpace;
  if (request.kind == ExportKind::Frame && !sceneLinear && !choices.tone.empty())
    request.frame.tone = stillToneFromText(choices.tone);
  request.layers.naming = choices.naming == "blender" ? LayerNaming::Blender : LayerNaming::Layers;
  request.layers.multipart = choices.naming == "multi";
  request.layers.compression = choices.compression;
  request.layers.pictures = choices.floatLayers ? PixelType::Float : PixelType::Half;
  request.layers.colorSpace = choices.colorSpace;
  request.layers.beta = choices.beta;
  request.layers.highlights = choices.highlights;
  request.layers.quality = choices.quality;
  request.seesLook = choices.cameraLook;
  request.seesGrade = choices.grade;
  request.timing.framesPerSecond = static_cast<double>(choices.framesPerSecond);
  request.timing.holdSeconds = static_cast<double>(choices.holdSeconds);
  return request;
}

ExportChoices readExportChoices(const std::filesystem::path& file) {
  ExportChoices choices;
  try {
    if (!std::filesystem::exists(file)) return choices;
    const Json json = readJson(file);
    choices.kind = enumOfName(kKindNames, json.value("kind", ""), choices.kind);
    const Json formats = json.value("formats", Json::object());
    for (size_t i = 0; i < kKindNames.size(); ++i)
      take(choices.formats.at(i), formats.value(kKindNames.at(i), ""), formatsOf(static_cast<ExportKind>(i)));
    choices.floatFrame = json.value("float_frame", choices.floatFrame);
    choices.sixteenBits = json.value("sixteen_bits", choices.sixteenBits);
    take(choices.colorSpace, json.value("color_space", ""), {"", "lin_rec709", "acescg", "aces2065_1"});
    take(choices.tone, json.value("tone", ""), {"", "drago", "mantiuk", "reinhard"});
    take(choices.naming, json.value("naming", ""), {"one", "multi", "blender"});
    choices.floatLayers = json.value("float_layers", choices.floatLayers);
    take(choices.compression, json.value("compression", ""), {"none", "zip", "zips", "piz", "dwaa", "dwab"});
    choices.beta = json.value("beta", choices.beta);
    choices.highlights = json.value("highlights", choices.highlights);
    choices.quality = json.value("quality", choices.quality);
    choices.cameraLook = json.value("camera_look", choices.cameraLook);
    choices.grade = json.value("grade", choices.grade);
    choices.framesPerSecond = std::clamp(json.value("fps", choices.framesPerSecond), 1.F, kMostRate);
    choices.holdSeconds = std::clamp(json.value("hold", choices.holdSeconds), 0.F, kMostCueSeconds);
    choices.folder = json.value("folder", "");
  } catch (const std::exception&) {
    return {};
  }
  return choices;
}

void writeExportChoices(const ExportChoices& choices, const std::filesystem::path& file) {
  Json formats;
  for (size_t i = 0; i < kKindNames.size(); ++i) formats[kKindNames.at(i)] = choices.formats.at(i);
  try {
    std::filesystem::create_directories(file.parent_path());
    writeJson(Json{{"kind", nameOfEnum(kKindNames, choices.kind)},
                   {"formats", formats},
                   {"float_frame", choices.floatFrame},
                   {"sixteen_bits", choices.sixteenBits},
                   {"color_space", choices.colorSpace},
                   {"tone", choices.tone},
                   {"naming", choices.naming},
                   {"float_layers", choices.floatLayers},
                   {"compression", choices.compression},
                   {"beta", choices.beta},
                   {"highlights", choices.highlights},
                   {"quality", choices.quality},
                   {"camera_look", choices.cameraLook},
                   {"grade", choices.grade},
                   {"fps", choices.framesPerSecond},
                   {"hold", choices.holdSeconds},
                   {"folder", choices.folder.string()}},
              file);
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace swaplight
