#include <cmath>
#include <cstdlib>

#include "core/base/json.h"
#include "core/chart/camera_file.h"
#include "core/file/json_file.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fuzz::load([&] {
    const CameraFile camera = cameraFromJson(parseJson(fuzz::textOf(data, size), "camera.json"));
    for (const auto& row : camera.matrix)
      if (!(std::abs(row[0] + row[1] + row[2] - 1) < .01)) std::abort();
  });
  return 0;
}
