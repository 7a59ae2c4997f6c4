#include "core/session/recovery.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <system_error>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_file.h"

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
  m_handle = open(m_lock.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  if (m_handle < 0 || flock(m_handle, LOCK_EX | LOCK_NB) != 0)
    throw InputError(
        "{}: cannot be written, so that nothing could be recovered after a crash. Check the "
        "folder's permissions.",
        folder.string());
}

RecoverySlot::~RecoverySlot() {
  std::error_code ignored;
  fs::remove(m_session, ignored);
  fs::remove(m_lock, ignored);
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

std::vector<Recovered> findRecovered(const fs::path& folder) {
  std::vector<Recovered> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".lock") continue;
    const int handle = open(entry.path().c_str(), O_RDONLY | O_CLOEXEC);
    if (handle < 0) continue;
    const bool dead = flock(handle, LOCK_EX | LOCK_NB) == 0;
    Recovered recovered{entry.path(), {}, {}, dead ? readLock(handle) : ""};
    close(handle);
    if (!dead) continue;
    const fs::path session = fs::path(entry.path()).replace_extension(".swaplight");
    try {
      if (fs::exists(session)) {
        recovered.savedAs = readJson(session).value(kOfKey, "");
        recovered.session = session;
      }
    } catch (const std::exception&) {
      recovered.session.clear();
    }
    if (recovered.session.empty() && recovered.opening.empty())
      discardRecovered(recovered);
    else
      found.push_back(std::move(recovered));
  }
  std::sort(found.begin(), found.end(),
            [](const Recovered& a, const Recovered& b) { return a.lock > b.lock; });
  return found;
}

void discardRecovered(const Recovered& recovered) {
  std::error_code ignored;
  fs::remove(fs::path(recovered.lock).replace_extension(".swaplight"), ignored);
  fs::remove(recovered.lock, ignored);
}

}  // namespace swaplight
