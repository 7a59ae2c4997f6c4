#include "tests/fuzz/fuzz.h"
#include "ui/actions/key_file.h"
#include "ui/actions/script_line.h"

using namespace swaplight;

// The file of keys, and the studio's script: both are lines of words.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = fuzz::textOf(data, size);
  fuzz::load([&] {
    ActionTable actions;
    actions.add({"file.open", "Open", "Ctrl+O", "Opens a file.", [] {}});
    applyKeyText(actions, text);
    static_cast<void>(keyText(actions));
  });
  for (const ScriptLine& line : scriptLines(text)) {
    fuzz::load([&] { static_cast<void>(scriptCount(line)); });
    fuzz::load([&] { static_cast<void>(scriptSeconds(line)); });
    fuzz::load([&] { static_cast<void>(scriptPlaces(line)); });
  }
  return 0;
}
