#include "core/image/images_in_files.h"

#include <fcntl.h>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <new>
#include <string>
#include <system_error>

#include "core/base/machine_error.h"

namespace swaplight {
namespace {

constexpr size_t kHugePage = size_t{2} << 20;
constexpr std::chrono::milliseconds kLookEvery{5};
constexpr size_t kSmall = size_t{1} << 20;  // bytes: images that are not worth a file

/// What of files is in this program's memory, beyond what was when it began: its own code and libraries.
class HeldOfFiles {
 public:
  HeldOfFiles() : m_file(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC)), m_first(bytes()) {}
  HeldOfFiles(const HeldOfFiles&) = delete;
  HeldOfFiles& operator=(const HeldOfFiles&) = delete;
  ~HeldOfFiles() {
    if (m_file >= 0) ::close(m_file);
  }
  /// Also where it cannot be known.
  [[nodiscard]] bool isMoreThan(size_t most) const {
    const long now = bytes();
    return now < 0 || m_first < 0 || now - m_first > long(most);
  }

 private:
  [[nodiscard]] long bytes() const {
    std::array<char, 128> text{};
    long all = 0, resident = 0, ofFiles = 0;
    if (::pread(m_file, text.data(), text.size() - 1, 0) <= 0 ||
        std::sscanf(text.data(), "%ld %ld %ld", &all, &resident, &ofFiles) != 3)
      return -1;
    return ofFiles * ::sysconf(_SC_PAGESIZE);
  }
  int m_file;
  long m_first;
};

/// Where images go, and which lie in files.
struct Files {
  std::mutex mutex;
  std::filesystem::path folder;
  std::map<float*, size_t> mapped;  ///< bytes of each
};

Files& files() {
  static Files theOnes;
  return theOnes;
}

std::atomic<size_t> largestInMemory = ImageMemory::kAny, allInMemory = ImageMemory::kAny;
std::atomic<size_t> inMemory = 0;  // bytes of images
std::atomic<size_t> mappedCount = 0;

bool goesToAFile(size_t bytes) {
  return bytes > largestInMemory || (bytes > kSmall && bytes + inMemory > allInMemory);
}

[[noreturn]] void fail(const std::filesystem::path& folder, int error) {
  throw MachineError("{}: no temporary file for a large picture: {}. {}.", folder.string(),
                     std::generic_category().message(error),
                     isFull(error) ? "Free some space, or write to another disk" : "Write to another folder");
}

/// Never has a name where the file system can do that, so that nothing stays whenever the program ends.
int openNameless(const std::filesystem::path& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != ENOENT)) return file;
  std::string name = (folder / ".swaplight-picture-XXXXXX").string();
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

/// A signal ends it on some file systems, without any room made.
int makeRoom(int file, size_t bytes) {
  int error = EINTR;
  while (error == EINTR) error = ::posix_fallocate(file, 0, static_cast<off_t>(bytes));
  return error;
}

/// A file without a name, with room for all its bytes: a mapped one that grows on a full disk would end the
/// program.
int namelessFile(const std::filesystem::path& folder, size_t bytes) {
  const int file = openNameless(folder);
  if (file < 0) fail(folder, errno);
  const int error = makeRoom(file, bytes);
  if (error == 0) return file;
  ::close(file);
  fail(folder, error);
}

float* mapFile(size_t bytes) {
  const std::lock_guard lock(files().mutex);
  const int file = namelessFile(files().folder, bytes);
  void* p = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  if (p == MAP_FAILED) throw std::bad_alloc();
  auto* pixels = static_cast<float*>(p);
  files().mapped[pixels] = bytes;
  mappedCount = files().mapped.size();
  return pixels;
}

/// The pages stay in the file, and in the system's cache as long as there is room.
void handBack() {
  const std::lock_guard lock(files().mutex);
  for (const auto& [pixels, bytes] : files().mapped) ::madvise(pixels, bytes, MADV_DONTNEED);
}

}  // namespace

ImagesInFiles::ImagesInFiles(const std::filesystem::path& folder, const ImageMemory& memory) {
  m_handingBack = std::jthread([ofFiles = memory.ofFiles](const std::stop_token& end) {
    std::mutex mutex;
    std::condition_variable_any wait;
    std::unique_lock lock(mutex);
    const HeldOfFiles held;
    while (!wait.wait_for(lock, end, kLookEvery, [&] { return end.stop_requested(); }))
      if (held.isMoreThan(ofFiles)) handBack();
  });
  const std::lock_guard lock(files().mutex);
  files().folder = folder.empty() ? std::filesystem::path(".") : folder;
  largestInMemory = memory.largest;  // last: what throws before leaves images where they were
  allInMemory = memory.all;
}

ImagesInFiles::~ImagesInFiles() {
  largestInMemory = allInMemory = ImageMemory::kAny;
}

size_t ImagesInFiles::count() {
  return mappedCount;
}

bool ImagesInFiles::areBounded() {
  return allInMemory != ImageMemory::kAny;
}

float* allocateImage(size_t floats) {
  const size_t bytes = floats * sizeof(float);
  if (goesToAFile(bytes)) return mapFile(bytes);
  const size_t align = bytes >= 2 * kHugePage ? kHugePage : 64;
  const size_t rounded = (bytes + align - 1) / align * align;
  void* p = std::aligned_alloc(align, rounded);
  if (!p) throw std::bad_alloc();
  // First touch of 4K pages runs at a tenth of memory speed; huge pages at a third.
  if (align == kHugePage) madvise(p, rounded, MADV_HUGEPAGE);
  inMemory += ::malloc_usable_size(p);
  return static_cast<float*>(p);
}

namespace {

void freeInMemory(float* pixels) {
  inMemory -= ::malloc_usable_size(pixels);
  std::free(pixels);
}

}  // namespace

void freeImage(float* pixels) {
  if (mappedCount == 0) {
    freeInMemory(pixels);
    return;
  }
  const std::lock_guard lock(files().mutex);
  const auto found = files().mapped.find(pixels);
  if (found == files().mapped.end()) {
    freeInMemory(pixels);
    return;
  }
  ::munmap(pixels, found->second);
  files().mapped.erase(found);
  mappedCount = files().mapped.size();
}

}  // namespace swaplight
