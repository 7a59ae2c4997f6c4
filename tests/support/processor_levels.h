#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/simd/simd.h"

namespace swaplight::test {

/// The code of another class of processor runs while this lives.
class AtLevel {
 public:
  explicit AtLevel(int level) : m_before(processorLevel()) { setProcessorLevel(level); }
  ~AtLevel() { setProcessorLevel(m_before); }
  AtLevel(const AtLevel&) = delete;
  AtLevel& operator=(const AtLevel&) = delete;

 private:
  int m_before;
};

/// The classes whose code this machine can run, the plainest first.
inline std::vector<int> levelsHere() {
  std::vector<int> levels;
  for (const int level : {1, 3, 4})
    if (level <= machineLevel()) levels.push_back(level);
  return levels;
}

/// Calls work() with the code of each class that this machine can run.
template <typename Work>
void atEveryLevel(const Work& work) {
  for (const int level : levelsHere()) {
    SCOPED_TRACE("x86-64-v" + std::to_string(level));
    const AtLevel forced(level);
    work();
  }
}

}  // namespace swaplight::test
