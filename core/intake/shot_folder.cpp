#include "core/intake/shot_folder.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/lower_case.h"
#include "core/capture/left_out.h"
#include "core/image/io/image_io.h"
#include "core/set/solved_file.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kFlatPrefix = "flat_";
constexpr std::string_view kChartPrefix = "chart_";
constexpr const char* kResponse = "response.csv";

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Names in the order in which a person counts.
bool countsBefore(const std::string& a, const std::string& b) {
  size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    while (i < a.size() && a[i] == '0') ++i;
    while (j < b.size() && b[j] == '0') ++j;
    const size_t beginA = i, beginB = j;
    while (i < a.size() && isDigit(a[i])) ++i;
    while (j < b.size() && isDigit(b[j])) ++j;
    if (i - beginA != j - beginB) return i - beginA < j - beginB;
    if (const int order = a.compare(beginA, i - beginA, b, beginB, j - beginB); order != 0) return order < 0;
  }
  return a.size() - i < b.size() - j;
}

std::string takenAt(const ImageFileInfo& info) {
  for (const char* key : {"Exif:DateTimeOriginal", "Exif:DateTimeDigitized", "DateTime"})
    if (const auto found = info.text.find(key); found != info.text.end() && !found->second.empty()) {
      const auto part = info.text.find("Exif:SubsecTimeOriginal");
      return found->second + (part != info.text.end() ? "." + part->second : "");
    }
  return {};
}

/// A picture that this program has made of photographs, and no photograph. Linear ones may have been rendered
/// or registered to be photographs; of those, what it exports says more of itself than its name.
bool isExport(const ImageFileInfo& info) {
  const bool saysSo = std::any_of(info.text.begin(), info.text.end(),
                                  [](const auto& text) { return text.first.starts_with("swaplight/"); });
  const auto software = info.text.find("Software");
  const bool written = software != info.text.end() && software->second.starts_with("swaplight ");
  return saysSo || (written && !info.isFloat);
}

/// Colours that a file states, of no colour space that is known here: a sentence.
std::string unknownColors(const ImageFileInfo& info, const FoundShot& shot) {
  if (info.statedColors.empty() || info.statedColors == shot.colorSpace) return {};
  return fmt::format(
      "{} says that its colours are {}: they are taken as {}; name another colour space where that is wrong",
      shot.file, info.statedColors, shot.colorSpace);
}

FoundShot describe(const ColorConfig& config, const fs::path& file, ImageFileInfo& info) {
  const ImageSpec spec = readImageSpec(file, &info);
  const std::string byRule = config.colorSpaceOfFile(file);
  return {file.filename().string(),
          takenAt(info),
          byRule.empty() ? spec.colorSpace : byRule,
          info.format,
          spec.width,
          spec.height,
          statedExposure(info)};
}

bool looksLikePicture(const fs::path& file) {
  static const std::set<std::string> others = {".json", ".txt",        ".csv", ".xmp", ".swaplight",
                                               ".md",   ".swaplight~", ".thm", ".pp3", ".db"};
  const std::string name = file.filename().string();
  return fs::is_regular_file(file) && name.front() != '.' && others.count(lowerExtension(file)) == 0;
}

/// Of a raw file and the camera's own JPEG of it, the raw file.
void dropTwins(std::vector<FoundShot>& shots, std::vector<std::string>& notes) {
  std::set<std::string> raws;
  for (const FoundShot& shot : shots)
    if (shot.format == "raw") raws.insert(lowerCase(fs::path(shot.file).stem().string()));
  std::erase_if(shots, [&](const FoundShot& shot) {
    const bool twin = shot.format == "jpeg" && raws.count(lowerCase(fs::path(shot.file).stem().string())) > 0;
    if (twin) notes.push_back(shot.file + " is left out: its raw file is there");
    return twin;
  });
}

/// Pictures that are called so are of charts, unless all photographs are.
void placeCharts(std::vector<FoundShot> charts, ShotFolder& found) {
  dropTwins(charts, found.notes);
  if (found.shots.empty()) {
    found.shots = std::move(charts);
    return;
  }
  for (const FoundShot& chart : charts) {
    found.charts.push_back(chart.file);
    found.notes.push_back(chart.file + " shows a colour chart, by its name, and is no photograph of the set");
  }
}

/// A picture that lies there by chance seldom has the size of the photographs. Without a size that most have,
/// nobody knows which are meant.
void dropOtherSizes(ShotFolder& found) {
  std::map<std::pair<int, int>, size_t> sizes;
  for (const FoundShot& shot : found.shots) ++sizes[{shot.width, shot.height}];
  const auto most = std::max_element(sizes.begin(), sizes.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == sizes.end() || 2 * most->second <= found.shots.size()) return;
  const auto [width, height] = most->first;
  std::erase_if(found.shots, [&, width = width, height = height](const FoundShot& shot) {
    const bool other = shot.width != width || shot.height != height;
    if (other)
      found.notes.push_back(
          fmt::format("{} is left out: it is {} x {} pixels, the other photographs are {} x {}", shot.file,
                      shot.width, shot.height, width, height));
    return other;
  });
}

void putInOrder(ShotFolder& found) {
  std::stable_sort(found.shots.begin(), found.shots.end(),
                   [](const FoundShot& a, const FoundShot& b) { return countsBefore(a.file, b.file); });
  std::set<std::string> times;
  for (const FoundShot& shot : found.shots) times.insert(shot.taken);
  found.timed = found.shots.size() > 1 && times.size() == found.shots.size() && times.count("") == 0;
  if (!found.timed) return;
  std::stable_sort(found.shots.begin(), found.shots.end(),
                   [](const FoundShot& a, const FoundShot& b) { return a.taken < b.taken; });
}

}  // namespace

std::optional<double> statedExposure(const ImageFileInfo& info) {
  const auto number = [&](std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (const auto found = info.numbers.find(key); found != info.numbers.end() && found->second > 0)
        return found->second;
    return 0.0;
  };
  const double seconds = number({"ExposureTime"}), stop = number({"FNumber"}),
               iso = number({"Exif:ISOSpeedRatings", "Exif:PhotographicSensitivity"});
  if (!(seconds > 0 && stop > 0 && iso > 0)) return std::nullopt;
  return std::log2(seconds * iso / (stop * stop));
}

ShotFolder scanShotFolder(const ColorConfig& config, const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw InputError("{}: is no folder, expected one with the photographs of a set", folder.string());
  ShotFolder found;
  found.folder = fs::absolute(folder).lexically_normal();
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (looksLikePicture(entry.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<FoundShot> charts;
  for (const fs::path& file : files) {
    const std::string name = file.filename().string();
    try {
      ImageFileInfo info;
      FoundShot shot = describe(config, file, info);
      if (shot.format == "openexr" && isSolvedSet(file))
        found.notes.push_back(name + " is left out: it is a solved set");
      else if (isExport(info))
        found.notes.push_back(name + " is left out: Swaplight has made it");
      else if (lowerCase(name).starts_with("ambient"))
        found.ambient = name;
      else if (lowerCase(name).starts_with("dark"))
        found.dark = name;
      else if (lowerCase(name).starts_with("vignetting"))
        found.vignetting = name;
      else if (lowerCase(name).starts_with(kFlatPrefix))
        found.flats[file.stem().string().substr(kFlatPrefix.size())] = name;
      else if (lowerCase(name).starts_with(kChartPrefix))
        charts.push_back(std::move(shot));
      else {
        const std::string note = found.shots.empty() ? unknownColors(info, shot) : "";
        if (!note.empty()) found.notes.push_back(note);
        found.shots.push_back(std::move(shot));
      }
    } catch (const InputError&) {
      found.notes.push_back(name + " is left out: it is no picture that can be read");
    }
  }
  if (fs::is_regular_file(found.folder / kResponse)) found.response = kResponse;
  dropTwins(found.shots, found.notes);
  placeCharts(std::move(charts), found);
  dropOtherSizes(found);
  if (found.shots.empty())
    throw InputError("{}: has no photographs (EXR, PNG, TIFF, JPEG, HDR or camera raw)", folder.string());
  putInOrder(found);
  return found;
}

ShotFolder withShots(const ColorConfig& config, ShotFolder folder, const std::vector<std::string>& files) {
  std::vector<FoundShot> shots;
  for (const std::string& file : files) {
    if (!fs::exists(folder.folder / file))
      throw InputError("{}: there is no such picture in {}", file, folder.folder.string());
    ImageFileInfo info;
    shots.push_back(describe(config, folder.folder / file, info));
    shots.back().file = file;
  }
  folder.shots = std::move(shots);
  folder.timed = false;
  return folder;
}

ShotFolder withShotsLeftOut(ShotFolder folder, const std::vector<std::string>& files,
                            const std::string& where) {
  for (const std::string& file : files) {
    const auto found = std::find_if(folder.shots.begin(), folder.shots.end(),
                                    [&](const FoundShot& shot) { return shot.file == file; });
    if (found == folder.shots.end()) {
      std::vector<std::string> names;
      for (const FoundShot& shot : folder.shots) names.push_back(shot.file);
      throw noPhotographToLeaveOut(where, file, names);
    }
    folder.leftOut.push_back(file);
    folder.shots.erase(found);
    if (folder.shots.empty()) throw nothingIsLeft(where);
  }
  return folder;
}

std::string colorSpaceOf(const ShotFolder& folder) {
  const FoundShot& first = folder.shots.front();
  for (const FoundShot& shot : folder.shots)
    if (shot.colorSpace != first.colorSpace)
      throw InputError("{} is in {}, {} is in {}. Export all shots in one colour space.", shot.file,
                       shot.colorSpace, first.file, first.colorSpace);
  // Raw files are developed to linear camera colours, which the manifest calls by the default name.
  return first.colorSpace == "raw" ? "lin_rec709" : first.colorSpace;
}

}  // namespace swaplight
