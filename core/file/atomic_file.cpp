#include "core/file/atomic_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <vector>

#include "core/base/error.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

/// Closes a POSIX file descriptor at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : m_fd(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (m_fd >= 0) ::close(m_fd);
  }
  [[nodiscard]] int get() const { return m_fd; }
  [[nodiscard]] explicit operator bool() const { return m_fd >= 0; }

 private:
  int m_fd;
};

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// The file that a chain of symbolic links names, even where it does not exist yet.
fs::path resolveLinks(const fs::path& file) {
  std::error_code error;
  fs::path at = file;
  for (int i = 0; i < 40 && fs::is_symlink(at, error); ++i) {
    const fs::path next = fs::read_symlink(at, error);
    if (error) break;
    at = next.is_absolute() ? next : folderOf(at) / next;
  }
  return at;
}

bool diskIsFull(const fs::path& folder) {
  constexpr uintmax_t kFull = 64 << 10;  // writers give up with some blocks left
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  return !error && space.available < kFull;
}

bool isFull(int error) {
  return error == ENOSPC || error == EDQUOT;
}

[[noreturn]] void throwFull(const fs::path& target) {
  throw InputError("{}: the disk is full. Free some space, or write to another disk.", target.string());
}

/// What the names of a target's temporary files begin with on this machine.
std::string temporaryBegin(const fs::path& target) {
  std::array<char, 65> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
  return fmt::format(".{}.{}-", target.stem().string().substr(0, 100), host.data());
}

/// The temporary files that were in a folder when this process first wrote there: a folder may hold many
/// frames, and is looked through once.
const std::vector<std::string>& temporariesIn(const fs::path& folder) {
  static std::mutex mutex;
  static std::map<fs::path, std::vector<std::string>> known;
  const std::lock_guard lock(mutex);
  const auto [found, isNew] = known.try_emplace(folder);
  std::error_code error;
  if (isNew)
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
      std::string name = entry->path().filename().string();
      if (name.starts_with('.') && name.find(".tmp") != std::string::npos) found->second.push_back(name);
    }
  return found->second;
}

/// Removes what a process of this machine that is no longer there has left of the same target.
void removeStale(const fs::path& folder, const std::string& begin, const std::string& extension) {
  const std::string end = ".tmp" + extension;
  for (const std::string& name : temporariesIn(folder)) {
    if (!name.starts_with(begin) || !name.ends_with(end)) continue;
    const int process = std::atoi(name.c_str() + begin.size());  // NOLINT(cert-err34-c)
    if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) ::unlink((folder / name).c_str());
  }
}

std::string reason(int error) {
  return std::strerror(error);  // NOLINT(concurrency-mt-unsafe)
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& target) : m_target(target), m_resolved(resolveLinks(target)) {
  std::error_code error;
  if (!m_resolved.has_filename()) throw InputError("{}: names a folder, expected a file.", target.string());
  const fs::file_status status = fs::status(m_resolved, error);
  if (fs::is_directory(status)) throw InputError("{}: is a folder. Name a file to write.", target.string());
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw InputError("{}: is no regular file. Name a file to write.", target.string());
  const fs::path folder = folderOf(m_resolved);
  if (!fs::is_directory(folder, error))
    throw InputError("{}: the folder {} does not exist. Create it, or write somewhere else.", target.string(),
                     folder.string());

  static std::atomic<unsigned> counter = 0;
  const std::string begin = temporaryBegin(m_resolved);
  removeStale(folder, begin, m_resolved.extension().string());
  m_temporary = folder / fmt::format("{}{}-{}.tmp{}", begin, ::getpid(), counter.fetch_add(1),
                                     m_resolved.extension().string());
  const Descriptor file(::open(m_temporary.c_str(), O_CREAT | O_WRONLY | O_TRUNC | O_CLOEXEC, 0666));
  if (!file) {
    const int why = errno;
    m_temporary.clear();
    if (isFull(why)) throwFull(target);
    throw InputError("{}: cannot be written ({}). Check the folder's permissions, or write somewhere else.",
                     target.string(), reason(why));
  }
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!m_committed && !m_temporary.empty()) fs::remove(m_temporary, ignored);
}

void AtomicFile::commit() {
  {
    const Descriptor file(::open(m_temporary.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file || ::fsync(file.get()) != 0) fail(errno);
  }
  if (std::rename(m_temporary.c_str(), m_resolved.c_str()) != 0) fail(errno);
  m_committed = true;
}

void AtomicFile::fail(std::string_view detail) const {
  if (diskIsFull(folderOf(m_resolved))) throwFull(m_target);
  throw InputError("{}: cannot be written: {}", m_target.string(), detail);
}

void checkWritable(const std::filesystem::path& target) {
  const AtomicFile probe(target);
}

void AtomicFile::fail(int error) const {
  if (isFull(error)) throwFull(m_target);
  fail(reason(error));
}

void writeFile(const fs::path& target, std::string_view bytes) {
  AtomicFile file(target);
  {
    const Descriptor out(::open(file.temporary().c_str(), O_WRONLY | O_CLOEXEC));
    if (!out) file.fail(errno);
    while (!bytes.empty()) {
      const ssize_t written = ::write(out.get(), bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) file.fail(errno);
      bytes.remove_prefix(static_cast<size_t>(written));
    }
  }
  file.commit();
}

std::string readFile(const fs::path& path, size_t limit) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file && errno == ENOENT) throw InputError("{}: no such file.", path.string());
  if (!file) throw InputError("{}: cannot be read ({}).", path.string(), reason(errno));
  std::string bytes;
  std::string block(size_t{1} << 16, '\0');
  while (true) {
    const ssize_t got = ::read(file.get(), block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EISDIR) throw InputError("{}: is a folder, expected a file.", path.string());
    if (got < 0) throw InputError("{}: cannot be read ({}).", path.string(), reason(errno));
    if (got == 0) return bytes;
    bytes.append(block, 0, static_cast<size_t>(got));
    if (bytes.size() > limit)
      throw InputError("{}: is larger than {} MiB, which this kind of file never is.", path.string(),
                       limit >> 20);
  }
}

}  // namespace swaplight
