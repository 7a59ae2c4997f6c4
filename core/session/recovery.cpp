#include "core/session/recovery.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <optional>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"
#include "core/session/broken_recovery.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr const char* kOfKey = "recovery_of";

// The lock's own content is written in place: a new file under the same name would not carry the lock.
void writeLock(int handle, const fs::path& opening) {
  const std::string text = opening.string();
  if (ftruncate(handle, 0) != 0) return;
  if (pwrite(handle, text.data(), text.size(), 0) < 0) return;
}

std::string readLock(int handle) {
  std::string text(4096, '\0');
  const ssize_t length = pread(handle, text.data(), text.size(), 0);
  text.resize(length > 0 ? static_cast<size_t>(length) : 0);
  return text;
}

}  // namespace

RecoverySlot::RecoverySlot(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const std::string id =
      fmt::format("{}-{}", std::chrono::duration_cast<std::chrono::milliseconds>(now).count(), getpid());
  m_session = folder / (id + ".swaplight");
  m_lock = folder / (id + ".lock");
  // Locked before it has the name under which others look for it: an unlocked one would be taken for dead.
  const fs::path unseen = folder / (id + ".new");
  m_handle = open(unseen.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_RDWR | O_CLOEXEC, 0600);
  const bool locked = m_handle >= 0 && flock(m_handle, LOCK_EX | LOCK_NB) == 0;
  if (!locked || std::rename(unseen.c_str(), m_lock.c_str()) != 0) {
    if (m_handle >= 0) close(m_handle);
    fs::remove(unseen, error);
    throw InputError(
        "{}: cannot be written, so that nothing could be recovered after a crash. Check the "
        "folder's permissions.",
        folder.string());
  }
}

RecoverySlot::~RecoverySlot() {
  std::error_code ignored;
  if (!m_left) fs::remove(m_session, ignored);
  if (!m_left) fs::remove(m_lock, ignored);
  close(m_handle);
}

void RecoverySlot::save(const Session& session, const fs::path& savedAs) {
  Json json = jsonFromSession(session, {});
  json[kOfKey] = savedAs.string();
  writeJson(json, m_session);
}

void RecoverySlot::forget() {
  std::error_code ignored;
  fs::remove(m_session, ignored);
}

void RecoverySlot::opening(const fs::path& file) {
  writeLock(m_handle, fs::absolute(file));
}

void RecoverySlot::opened() {
  writeLock(m_handle, {});
}

namespace {

/// The locks of a folder, and those that ought to stand beside a session: it may have lost its own.
std::set<fs::path> locksIn(const fs::path& folder) {
  std::set<fs::path> locks;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const fs::path extension = entry.path().extension();
    const bool beingWritten = entry.path().filename().string().starts_with('.');  // see AtomicFile
    if (!beingWritten && (extension == ".lock" || extension == ".swaplight"))
      locks.insert(fs::path(entry.path()).replace_extension(".lock"));
  }
  return locks;
}

/// What the lock of a dead process says; nothing where the process lives, or nobody can tell.
std::optional<std::string> deadLock(const fs::path& lock) {
  const int handle = open(lock.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return errno == ENOENT ? std::optional<std::string>("") : std::nullopt;
  const bool dead = flock(handle, LOCK_EX | LOCK_NB) == 0;
  std::optional<std::string> opening;
  if (dead) opening = readLock(handle);
  close(handle);
  return opening;
}

}  // namespace

std::vector<Recovered> findRecovered(const fs::path& folder) {
  std::vector<Recovered> found;
  for (const fs::path& lock : locksIn(folder)) {
    const std::optional<std::string> opening = deadLock(lock);
    if (!opening) continue;
    Recovered recovered{lock, {}, {}, *opening};
    const fs::path session = fs::path(lock).replace_extension(".swaplight");
    std::error_code error;
    const bool work = fs::exists(session, error) || error;
    try {
      if (work) {
        const Json json = readJson(session);
        recovered.savedAs = JsonFields(json, session.string()).text(kOfKey).value_or("");
        static_cast<void>(sessionFromJson(json, folder, session.string()));  // what recovering it will do
        recovered.session = session;
      }
    } catch (const std::exception&) {
      recovered.session.clear();  // stays where it is: see broken_recovery.h
    }
    if (!recovered.session.empty() || !recovered.opening.empty())
      found.push_back(std::move(recovered));
    else if (!work)
      discardRecovered(recovered);
  }
  std::sort(found.begin(), found.end(),
            [](const Recovered& a, const Recovered& b) { return a.lock > b.lock; });
  return found;
}

void discardRecovered(const Recovered& recovered) {
  std::error_code ignored;
  if (!recovered.session.empty()) fs::remove(recovered.session, ignored);
  fs::remove(recovered.lock, ignored);
}

std::vector<std::string> setBrokenAside(const fs::path& folder) {
  std::vector<std::string> words;
  for (const fs::path& lock : locksIn(folder)) {
    const fs::path session = fs::path(lock).replace_extension(".swaplight");
    std::error_code error;
    if (!deadLock(lock) || !fs::exists(session, error)) continue;
    try {
      static_cast<void>(readSession(session));
    } catch (const std::exception& reason) {
      words.push_back(setAside(session, reason.what()));
    }
  }
  return words;
}

std::string setAside(const fs::path& session, const std::string& reason) {
  const fs::path kept = fs::path(session).replace_extension(".broken");
  std::error_code error;
  fs::rename(session, kept, error);
  return fmt::format("Work that was not saved cannot be read: {} It is kept as {}.", reason,
                     (error ? session : kept).string());
}

}  // namespace swaplight
