#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/filter/filter_pipeline.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

// A camera look's file, which comes back from its own text; also read as a filter with its values
// ("halation,amount=0.3").
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = fuzz::textOf(data, size);
  fuzz::load([&] {
    const std::string written =
        jsonText(jsonFromPipeline(pipelineFromJson(parseJson(text, "a.swaplook"), "a.swaplook")));
    static_cast<void>(pipelineFromJson(parseJson(written, "what was written"), "a.swaplook"));
  });
  fuzz::load([&] { static_cast<void>(stageFromText(text)); });
  return 0;
}
