#include "core/base/json.h"
#include "core/capture/capture.h"
#include "core/set/solved_file.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

// The header of a solved set, and its pixels where there are few. (isSolvedSet does what readSolvedHeader
// begins with.)
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto file = fuzz::fileOf(data, size);
  fuzz::load([&] {
    const SolvedHeader header = readSolvedHeader(file);
    static_cast<void>(jsonFromCapture(header.capture).dump(-1, ' ', false, Json::error_handler_t::replace));
    if (header.spec.pixelCount() < 4096) static_cast<void>(readSolvedSet(file));
  });
  return 0;
}
