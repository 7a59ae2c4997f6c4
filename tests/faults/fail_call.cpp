// Preloaded into the program (LD_PRELOAD): makes the k-th call of one kind fail, once, as a bad disk or a
// full memory would. What to do stands in the environment:
//   FAIL_CALL   open, pread, write, fsync, rename, close, malloc
//   FAIL_AT     which one, from 1
//   FAIL_ERRNO  what errno is then
//   FAIL_PATH   only files whose path holds this (not for malloc)
//   FAIL_SIZE   only allocations of at least so many bytes
//   FAIL_MARK   this file is made when the call has failed, so that a caller knows that there was a k-th one;
//   with
//               FAIL_AT=0 nothing fails, and the file holds how many such calls there were
// Calls count from main() on: what libraries do before it is nobody's to catch.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

std::atomic<long> g_calls{0};
std::atomic<bool> g_begun{false};
int (*g_main)(int, char**, char**) = nullptr;

const char* setting(const char* name) {
  const char* text = std::getenv(name);
  return text ? text : "";
}

// Says so without calling anything that is replaced here.
bool failsNow() {
  static const long at = std::atol(setting("FAIL_AT"));
  if (!g_begun || ++g_calls != at) return false;
  const long mark = ::syscall(SYS_openat, AT_FDCWD, setting("FAIL_MARK"), O_CREAT | O_WRONLY, 0600);
  if (mark >= 0) ::syscall(SYS_close, mark);
  static const int error = std::atoi(setting("FAIL_ERRNO"));
  errno = error;
  return true;
}

bool isKind(const char* kind) {
  static const char* wanted = setting("FAIL_CALL");
  return std::strcmp(wanted, kind) == 0;
}

bool pathFails(const char* kind, const char* path) {
  return isKind(kind) && path && std::strstr(path, setting("FAIL_PATH")) && failsNow();
}

bool fileFails(const char* kind, int file) {
  if (!isKind(kind)) return false;
  char link[64];
  char path[PATH_MAX];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = ::readlink(link, path, sizeof path - 1);
  if (length <= 0) return false;
  path[length] = 0;
  return std::strstr(path, setting("FAIL_PATH")) && failsNow();
}

int countedMain(int argc, char** argv, char** environment) {
  g_begun = true;
  return g_main(argc, argv, environment);
}

__attribute__((destructor)) void sayCount() {
  if (std::atol(setting("FAIL_AT")) != 0) return;
  g_begun = false;
  if (FILE* file = std::fopen(setting("FAIL_MARK"), "w")) {
    std::fprintf(file, "%ld", g_calls.load());
    std::fclose(file);
  }
}

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

using Main = int (*)(int, char**, char**);
int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(), void (*loader)(),
                      void* stack) {
  using Start = int(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  g_main = main;
  return next<Start>("__libc_start_main")(countedMain, argc, argv, init, fini, loader, stack);
}

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(more, mode_t) : 0;
  va_end(more);
  if ((flags & O_ACCMODE) != O_RDONLY && pathFails("open", path)) return -1;
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}
int open64(const char* path, int flags, ...) __attribute__((alias("open")));

FILE* fopen(const char* path, const char* mode) {
  static auto* real = next<FILE*(const char*, const char*)>("fopen");
  return mode[0] != 'r' && pathFails("open", path) ? nullptr : real(path, mode);
}
FILE* fopen64(const char* path, const char* mode) __attribute__((alias("fopen")));

ssize_t write(int file, const void* bytes, size_t count) {
  return fileFails("write", file) ? -1 : ::syscall(SYS_write, file, bytes, count);
}
ssize_t pwrite(int file, const void* bytes, size_t count, off_t offset) {
  return fileFails("write", file) ? -1 : ::syscall(SYS_pwrite64, file, bytes, count, offset);
}
ssize_t pwrite64(int file, const void* bytes, size_t count, off_t offset) __attribute__((alias("pwrite")));

ssize_t pread(int file, void* bytes, size_t count, off_t offset) {
  return fileFails("pread", file) ? -1 : ::syscall(SYS_pread64, file, bytes, count, offset);
}
ssize_t pread64(int file, void* bytes, size_t count, off_t offset) __attribute__((alias("pread")));

size_t fwrite(const void* bytes, size_t size, size_t count, FILE* stream) {
  static auto* real = next<size_t(const void*, size_t, size_t, FILE*)>("fwrite");
  return fileFails("write", ::fileno(stream)) ? 0 : real(bytes, size, count, stream);
}
int fclose(FILE* stream) {
  static auto* real = next<int(FILE*)>("fclose");
  if (!fileFails("close", ::fileno(stream))) return real(stream);
  const int error = errno;
  real(stream);
  errno = error;
  return EOF;
}

int fsync(int file) {
  return fileFails("fsync", file) ? -1 : static_cast<int>(::syscall(SYS_fsync, file));
}
int rename(const char* from, const char* to) {
  return pathFails("rename", to) ? -1 : static_cast<int>(::syscall(SYS_rename, from, to));
}

void* __libc_malloc(size_t size);
void* malloc(size_t size) {
  static const size_t least = std::strtoul(setting("FAIL_SIZE"), nullptr, 10);
  if (size >= least && least > 0 && isKind("malloc") && failsNow()) return nullptr;
  return __libc_malloc(size);
}

}  // extern "C"
