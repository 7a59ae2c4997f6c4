#include "core/chart/chart_shot.h"

#include <algorithm>
#include <cmath>

#include "core/balance/photograph.h"
#include "core/base/json.h"
#include "core/base/machine_error.h"
#include "core/capture/capture_pixels.h"
#include "core/chart/chart_finder.h"
#include "core/color/chromaticities.h"
#include "core/file/json_file.h"
#include "core/image/io/image_io.h"
#include "core/intake/shot_folder.h"

namespace swaplight {
namespace {

constexpr const char* kFormat = "swaplight-camera";
constexpr int kVersion = 1;
constexpr const char* kMatrixTo = "lin_rec709";
constexpr double kLeastAtPlace =
    .5;  // of a chart where it must be: under a gel that lets one channel through
constexpr double kWhiteKept = 1e-3;

/// What was read, where there is a chart.
struct Tried {
  ChartShot shot;
  int width = 0, height = 0;
  bool done = false;
};

CapturePixels load(const ColorConfig& config, const std::filesystem::path& file,
                   const ChartReadingOptions& options, const Progress& progress) {
  return loadPhotograph(config, file, options.colorSpaceOf ? options.colorSpaceOf(file) : "", progress);
}

ChartShot fitted(ChartShot shot, const CapturePixels& photograph) {
  shot.fit = fitChart(readChart(photograph.shots.front(), photograph.clipLevel.front(), shot.corners));
  return shot;
}

/// Looks for the chart, or at the corners told.
Tried tried(const ColorConfig& config, const std::filesystem::path& file, const ChartReadingOptions& options,
            const Progress& progress) {
  const CapturePixels photograph = load(config, file, options, progress.part(0, .4F));
  const Image& picture = photograph.shots.front();
  const float clip = photograph.clipLevel.front();
  Tried one{
      {file, picture.spec().colorSpace, {}, !options.corners, {}, {}, {}}, picture.width(), picture.height()};
  ImageFileInfo info;
  static_cast<void>(readImageSpec(file, &info));
  one.shot.exposureStops = statedExposure(info);
  const auto corners = options.corners ? orientedCorners(picture, clip, *options.corners)
                                       : findChart(picture, clip, progress.part(.4F, 1));
  if (!corners) return one;
  one.shot.corners = *corners;
  one.shot = fitted(std::move(one.shot), photograph);
  one.done = true;
  return one;
}

/// The chart of a photograph in which it is not found, where it is in another one.
ChartShot readAt(const ColorConfig& config, const Tried& missing, const std::vector<Tried>& all,
                 const ChartReadingOptions& options, const Progress& progress) {
  const auto other = std::find_if(all.begin(), all.end(), [&](const Tried& one) {
    return one.done && one.width == missing.width && one.height == missing.height;
  });
  const InputError none(
      "no chart found: all of a Macbeth chart of 24 patches must be seen, sharp, and its patches some 15 "
      "pixels "
      "wide; or tell its four corners (swaplight chart --corners X,Y,X,Y,X,Y,X,Y)");
  if (other == all.end()) throw none;
  const CapturePixels photograph = load(config, missing.shot.file, options, progress);
  ChartShot shot = missing.shot;
  shot.found = false;
  shot.corners = other->shot.corners;
  shot.asIn = other->shot.file;
  const ChartReading reading =
      readChart(photograph.shots.front(), photograph.clipLevel.front(), shot.corners);
  if (chartLikeness(reading) < kLeastAtPlace) throw none;
  shot = fitted(std::move(shot), photograph);
  shot.fit.warnings.push_back("no chart found: taken to be where it is in " + shot.asIn.filename().string());
  return shot;
}

/// Does the work of a file. What is wrong names it, and is thrown or left to `options`.
template <typename Work>
void naming(const std::filesystem::path& file, const ChartReadingOptions& options, const Work& work) {
  try {
    work();
  } catch (const MachineError&) {
    throw;
  } catch (const InputError& error) {
    const std::string what = error.what();
    const bool named = what.find(file.string()) != std::string::npos;
    const InputError wrong("{}", named ? what : file.string() + ": " + what);
    if (!options.leftOut) throw wrong;
    options.leftOut(wrong);
  }
}

}  // namespace

std::vector<ChartShot> readChartShots(const ColorConfig& config,
                                      const std::vector<std::filesystem::path>& files,
                                      const ChartReadingOptions& options, const Progress& progress) {
  std::vector<Tried> all;
  const auto each = 1 / float(files.size());
  for (size_t k = 0; k < files.size(); ++k) {
    const Progress part = progress.part(float(k) * each, float(k + 1) * each);
    naming(files[k], options, [&] { all.push_back(tried(config, files[k], options, part)); });
  }
  std::vector<ChartShot> shots;
  for (const Tried& one : all)
    naming(one.shot.file, options, [&] {
      shots.push_back(one.done ? one.shot : readAt(config, one, all, options, Progress{{}, progress.stop}));
    });
  return shots;
}

const ChartShot* bestChartShot(const std::vector<ChartShot>& shots) {
  const ChartShot* best = nullptr;
  for (const ChartShot& shot : shots)
    if (shot.fit.matrix && (best == nullptr || shot.fit.meanDeltaE < best->fit.meanDeltaE)) best = &shot;
  return best;
}

Json jsonFromCamera(const ChartShot& shot) {
  return {{"format", kFormat},
          {"version", kVersion},
          {"camera_matrix", *shot.fit.matrix},
          {"from", shot.colorSpace},
          {"to", kMatrixTo},
          {"photograph", shot.file.filename().string()},
          {"light", {shot.fit.light.r, shot.fit.light.g, shot.fit.light.b}},
          {"delta_e", {{"mean", shot.fit.meanDeltaE}, {"most", shot.fit.mostDeltaE}}}};
}

void CameraFile::apply(Image& picture, const Rgb& white, const Rgb& to) const {
  const size_t count = picture.pixelCount();
  float *red = picture.plane(0), *green = picture.plane(1), *blue = picture.plane(2);
  for (size_t p = 0; p < count; ++p) {
    const Rgb out = to * throughCamera(matrix, Rgb(red[p], green[p], blue[p]) / white);
    red[p] = out.r, green[p] = out.g, blue[p] = out.b;
  }
  picture.setColorSpace(kMatrixTo);
}

CameraFile readCamera(const std::filesystem::path& file) {
  const Json json = readJson(file);
  if (!json.is_object() || json.value("format", Json()) != kFormat)
    throw InputError("{}: is no camera matrix: make one with swaplight chart PHOTO -o FILE.json",
                     file.string());
  const Json version = json.value("version", Json());
  if (!version.is_number_integer() || version.get<int64_t>() < 1 || version.get<int64_t>() > kVersion)
    throw InputError("{}: has version {}, and this program reads versions up to {}", file.string(),
                     version.dump(), kVersion);
  const Json rows = json.value("camera_matrix", Json());
  CameraFile camera;
  bool good = rows.is_array() && rows.size() == 3;
  for (size_t i = 0; good && i < 3; ++i) {
    good = rows[i].is_array() && rows[i].size() == 3;
    double sum = 0;
    for (size_t j = 0; good && j < 3; ++j) {
      good = rows[i][j].is_number();
      if (good) sum += camera.matrix[i][j] = rows[i][j].get<double>();
    }
    good = good && std::abs(sum - 1) < kWhiteKept;
  }
  if (!good)
    throw InputError(
        "{}: camera_matrix must be three rows of three numbers, each row of sum 1, so that white stays white",
        file.string());
  const Json from = json.value("from", Json()), to = json.value("to", Json());
  if (!from.is_string() || !chromaticitiesOf(from.get<std::string>()) || to != kMatrixTo)
    throw InputError("{}: \"from\" and \"to\" must be linear light of primaries that are known, and {}",
                     file.string(), kMatrixTo);
  camera.from = from.get<std::string>();
  return camera;
}

}  // namespace swaplight
