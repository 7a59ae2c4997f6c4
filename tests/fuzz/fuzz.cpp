#include "tests/fuzz/fuzz.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <new>

#include "core/base/error.h"
#include "core/base/out_of_memory.h"
#include "core/base/parallel.h"

namespace swaplight::fuzz {

void load(const std::function<void()>& loader) {
  static const bool once = (setThreads(1), true);
  static_cast<void>(once);
  try {
    loader();
  } catch (const InputError&) {
  } catch (const ResourceError&) {
  } catch (const std::exception& error) {
    if (isOutOfMemory(error)) return;
    std::fprintf(stderr, "not an InputError: %s\n", error.what());
    std::abort();
  }
}

std::filesystem::path fileOf(const uint8_t* data, size_t size) {
  static const int memory = ::memfd_create("fuzz", 0);
  if (::ftruncate(memory, 0) != 0 || ::pwrite(memory, data, size, 0) != static_cast<ssize_t>(size))
    std::abort();
  return "/proc/self/fd/" + std::to_string(memory);
}

}  // namespace swaplight::fuzz
