#include "core/file/temporary_names.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <utility>

namespace swaplight {
namespace {

enum State { kFree, kTaken, kNamed };

/// Fixed in place: a signal handler may neither allocate nor lock.
struct Slot {
  std::atomic<int> state{kFree};
  std::array<char, PATH_MAX> name{};
};

constexpr int kSlots = 64;  // files that are written at a time; those beyond are removed by the next writer

std::array<Slot, kSlots>& slots() {
  static std::array<Slot, kSlots> all;
  return all;
}

// Made before main(), not by whoever comes first: that could be the handler.
const auto& g_slots = slots();

}  // namespace

TemporaryName::TemporaryName(const std::filesystem::path& file) {
  // Absolute: the process may have gone to another folder by then.
  std::error_code error;
  const std::string name = std::filesystem::absolute(file, error).string();
  if (error || name.size() >= PATH_MAX) return;
  for (int i = 0; i < kSlots && m_slot < 0; ++i) {
    Slot& slot = slots()[static_cast<size_t>(i)];
    int free = kFree;
    if (!slot.state.compare_exchange_strong(free, kTaken)) continue;
    std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
    slot.state = kNamed;
    m_slot = i;
  }
}

TemporaryName::TemporaryName(TemporaryName&& other) noexcept : m_slot(std::exchange(other.m_slot, -1)) {}

TemporaryName& TemporaryName::operator=(TemporaryName&& other) noexcept {
  forget();
  m_slot = std::exchange(other.m_slot, -1);
  return *this;
}

void TemporaryName::forget() {
  if (m_slot >= 0) slots()[static_cast<size_t>(std::exchange(m_slot, -1))].state = kFree;
}

void removeTemporaryFiles() noexcept {
  for (const Slot& slot : g_slots)
    if (slot.state == kNamed) ::unlink(slot.name.data());
}

}  // namespace swaplight
