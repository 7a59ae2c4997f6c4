#include "core/file/atomic_file.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <random>
#include <vector>

#include "core/base/machine_error.h"

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

/// Nothing that another name or another folder would mend.
bool isOfTheMachine(int error) {
  return isFull(error) || error == EIO || error == EMFILE || error == ENFILE || error == ENOMEM ||
         error == EFBIG || error == EINTR;
}

[[noreturn]] void throwFull(const fs::path& target) {
  throw MachineError("{}: the disk is full. Free some space, or write to another disk.", target.string());
}

std::string reason(int error) {
  return std::strerror(error);  // NOLINT(concurrency-mt-unsafe)
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

/// Read-only means that it is not to be replaced, for the superuser as well.
void checkReplaceable(const fs::path& resolved, const fs::path& target) {
  struct stat status {};
  if (::stat(resolved.c_str(), &status) != 0) return;
  constexpr mode_t kAnyWrite = S_IWUSR | S_IWGRP | S_IWOTH;
  if ((status.st_mode & kAnyWrite) == 0 || ::access(resolved.c_str(), W_OK) != 0)
    throw InputError("{}: is read-only. Make it writable, or write another file.", target.string());
}

/// Owner, group and mode of the file that is replaced. What this user may not give away stays the user's.
void keepOwnership(int file, const fs::path& replaced) {
  struct stat old {};
  if (::stat(replaced.c_str(), &old) != 0) return;
  mode_t mode = old.st_mode & 07777;
  if (::fchown(file, old.st_uid, old.st_gid) != 0) {
    mode &= ~mode_t{S_ISUID | S_ISGID};
    // At least the group: a member may give a file to it.
    if (::fchown(file, static_cast<uid_t>(-1), old.st_gid) != 0)
      mode &= ~mode_t{S_IRWXG} | (mode & S_IRWXO) << 3;
  }
  if (::fchmod(file, mode) != 0) return;  // a file system without modes
}

/// The rename itself survives a power cut only when the folder is flushed. Not every file system can.
void flushFolder(const fs::path& folder) {
  const Descriptor handle(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (handle && ::fsync(handle.get()) != 0) return;
}

/// Letters that nobody can guess, so that no link can lie in wait under the name.
std::string unguessable() {
  static thread_local std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& target) : m_target(target), m_resolved(resolveLinks(target)) {
  std::error_code error;
  if (!m_resolved.has_filename()) throw InputError("{}: names a folder, expected a file.", target.string());
  if (m_resolved.filename().native().size() > NAME_MAX)
    throw InputError("{}: the name is longer than {} bytes. Take a shorter one.", target.string(), NAME_MAX);
  const fs::file_status status = fs::status(m_resolved, error);
  if (fs::is_directory(status)) throw InputError("{}: is a folder. Name a file to write.", target.string());
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw InputError("{}: is no regular file. Name a file to write.", target.string());
  const fs::path folder = folderOf(m_resolved);
  if (!fs::is_directory(folder, error))
    throw InputError("{}: the folder {} does not exist. Create it, or write somewhere else.", target.string(),
                     folder.string());

  checkReplaceable(m_resolved, target);

  const std::string begin = temporaryBegin(m_resolved);
  removeStale(folder, begin, m_resolved.extension().string());
  m_temporary = folder / fmt::format("{}{}-{}.tmp{}", begin, ::getpid(), unguessable(),
                                     m_resolved.extension().string());
  m_registered = TemporaryName(m_temporary);
  const Descriptor file(
      ::open(m_temporary.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, 0666));
  if (!file) {
    const int why = errno;
    m_temporary.clear();
    if (isFull(why)) throwFull(target);
    if (isOfTheMachine(why)) throw MachineError("{}: cannot be written: {}", target.string(), reason(why));
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
    const Descriptor file(::open(m_temporary.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC));
    if (!file || ::fsync(file.get()) != 0) fail(errno);
    keepOwnership(file.get(), m_resolved);
  }
  if (std::rename(m_temporary.c_str(), m_resolved.c_str()) != 0) fail(errno);
  m_committed = true;
  flushFolder(folderOf(m_resolved));
}

void AtomicFile::fail(std::string_view detail) const {
  if (diskIsFull(folderOf(m_resolved))) throwFull(m_target);
  throw MachineError("{}: cannot be written: {}", m_target.string(), detail);
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

namespace {

/// Opened without waiting for anybody: the writer of a pipe, a device.
Descriptor opened(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0 && errno == ENOENT) throw InputError("{}: no such file.", path.string());
  if (file < 0 && isOfTheMachine(errno))
    throw MachineError("{}: cannot be read ({}).", path.string(), reason(errno));
  if (file < 0) throw InputError("{}: cannot be read ({}).", path.string(), reason(errno));
  return Descriptor(file);
}

/// Waits until a pipe has something; throws where its writer says nothing for long.
void waitForWriter(int pipe, const fs::path& path) {
  constexpr int kPatience = 30'000;  // milliseconds
  pollfd wait{pipe, POLLIN, 0};
  if (::poll(&wait, 1, kPatience) == 0)
    throw InputError("{}: is a pipe whose writer has said nothing for {} s.", path.string(),
                     kPatience / 1000);
}

}  // namespace

std::string readFile(const fs::path& path, size_t limit) {
  const Descriptor file = opened(path);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0)
    throw InputError("{}: cannot be read ({}).", path.string(), reason(errno));
  if (S_ISDIR(status.st_mode)) throw InputError("{}: is a folder, expected a file.", path.string());
  const bool pipe = S_ISFIFO(status.st_mode);
  if (!pipe && !S_ISREG(status.st_mode)) throw InputError("{}: is no regular file.", path.string());
  std::string bytes;
  std::string block(size_t{1} << 16, '\0');
  while (true) {
    const ssize_t got = ::read(file.get(), block.data(), block.size());
    if (got < 0 && errno == EAGAIN) {
      waitForWriter(file.get(), path);
      continue;
    }
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EIO) throw MachineError("{}: cannot be read ({}).", path.string(), reason(EIO));
    if (got < 0) throw InputError("{}: cannot be read ({}).", path.string(), reason(errno));
    if (got == 0 && pipe && bytes.empty())
      throw InputError("{}: is a pipe that nobody writes to.", path.string());
    if (got == 0) return bytes;
    bytes.append(block, 0, static_cast<size_t>(got));
    if (bytes.size() > limit)
      throw InputError("{}: is larger than {} MiB, which this kind of file never is.", path.string(),
                       limit >> 20);
  }
}

}  // namespace swaplight
