#include "core/base/json.h"
#include "core/file/json_file.h"
#include "core/session/session_file.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fuzz::load([&] {
    const Session session =
        sessionFromJson(parseJson(fuzz::textOf(data, size), "s"), "/sets", "any.swaplight");
    const std::string written = jsonText(jsonFromSession(session, "/sets"));
    static_cast<void>(sessionFromJson(parseJson(written, "what was written"), "/sets", "any.swaplight"));
  });
  return 0;
}
