#include "core/chart/camera_file.h"

#include <cmath>
#include <cstdint>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/json_integer.h"
#include "core/chart/chart_shot.h"
#include "core/color/chromaticities.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

constexpr const char* kCameraFormat = "swaplight-camera";
constexpr int kCameraVersion = 1;
constexpr const char* kMatrixTo = "lin_rec709";
constexpr double kWhiteKept = 1e-3;  // a row's sum: of numbers written by hand with three decimals

bool isMatrixRow(const Json& row) {
  if (!row.is_array() || row.size() != 3) return false;
  double sum = 0;
  for (const Json& number : row) {
    if (!number.is_number()) return false;
    sum += number.get<double>();
  }
  return std::abs(sum - 1) < kWhiteKept;
}

CameraMatrix matrixFromJson(const Json& rows) {
  bool good = rows.is_array() && rows.size() == 3;
  for (size_t i = 0; good && i < 3; ++i) good = isMatrixRow(rows[i]);
  if (!good)
    throw InputError(
        "camera_matrix must be three rows of three numbers, each row of sum 1, so that white stays white");
  CameraMatrix matrix{};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) matrix[i][j] = rows[i][j].get<double>();
  return matrix;
}

}  // namespace

void CameraFile::apply(Image& picture, const Rgb& white, const Rgb& to) const {
  const size_t count = picture.pixelCount();
  float *red = picture.plane(0), *green = picture.plane(1), *blue = picture.plane(2);
  for (size_t p = 0; p < count; ++p) {
    const Rgb out = to * throughCamera(matrix, Rgb(red[p], green[p], blue[p]) / white);
    red[p] = out.r, green[p] = out.g, blue[p] = out.b;
  }
  picture.setColorSpace(kMatrixTo);
}

Json jsonFromCamera(const ChartShot& shot) {
  return {{"format", kCameraFormat},
          {"version", kCameraVersion},
          {"camera_matrix", *shot.fit.matrix},
          {"from", shot.colorSpace},
          {"to", kMatrixTo},
          {"photograph", shot.file.filename().string()},
          {"light", {shot.fit.light.r, shot.fit.light.g, shot.fit.light.b}},
          {"delta_e", {{"mean", shot.fit.meanDeltaE}, {"most", shot.fit.mostDeltaE}}}};
}

CameraFile cameraFromJson(const Json& json) {
  if (!json.is_object() || json.value("format", Json()) != kCameraFormat)
    throw InputError("is no camera matrix: make one with swaplight chart PHOTO -o FILE.json");
  const Json version = json.value("version", Json());
  const int number = integerOf(version).value_or(0);
  if (number < 1 || number > kCameraVersion)
    throw InputError("has version {}, and this program reads versions up to {}", version.dump(),
                     kCameraVersion);
  CameraFile camera;
  camera.matrix = matrixFromJson(json.value("camera_matrix", Json()));
  const Json from = json.value("from", Json()), to = json.value("to", Json());
  if (!from.is_string() || !chromaticitiesOf(from.get<std::string>()) || to != kMatrixTo)
    throw InputError("\"from\" and \"to\" must be linear light of primaries that are known, and {}",
                     kMatrixTo);
  camera.from = from.get<std::string>();
  return camera;
}

CameraFile readCamera(const std::filesystem::path& file) {
  const Json json = readJson(file);
  try {
    return cameraFromJson(json);
  } catch (const InputError& error) {
    throw InputError("{}: {}", file.string(), error.what());
  }
}

}  // namespace swaplight
