#include "core/base/json.h"
#include "core/capture/capture.h"
#include "core/file/json_file.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fuzz::load([&] {
    const Capture capture = captureFromJson(parseJson(fuzz::textOf(data, size), "capture.json"), "/sets");
    const std::string written = jsonText(jsonFromCapture(capture));
    static_cast<void>(captureFromJson(parseJson(written, "what was written"), "/sets"));
  });
  return 0;
}
