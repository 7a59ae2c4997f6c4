#include "core/image/io/image_io.h"
#include "core/image/io/picture_message.h"
#include "tests/fuzz/fuzz.h"

using namespace swaplight;

// What a picture's process says, which the picture may have taken over: refused or read, never trusted.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string message = fuzz::textOf(data, size);
  try {
    const PictureAnswer answer = pictureAnswerOf(message, "picture.exr");
    static_cast<void>(messageOf(answer));
    static_cast<void>(bandAnswerOf(message, answer));
  } catch (const std::exception&) {
  }
  return 0;
}
