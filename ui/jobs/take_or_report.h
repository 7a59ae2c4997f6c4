#pragma once

#include <new>
#include <string>

#include "core/base/error.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"

namespace swaplight {

/// What became of a job.
enum class Taken {
  Nothing,  ///< it goes on, or there is none
  Value,
  Stopped,  ///< cancelled
  Failed,   ///< a message says why
};

/// Hands a job's result on, once. What went wrong, in the work or in `onValue`, becomes a message. `purpose`:
/// what there may be too little memory for, as "this export".
template <typename Result, typename OnValue>
Taken takeOrReport(Job<Result>& job, Messages& messages, const std::string& purpose, const OnValue& onValue) {
  try {
    auto value = job.take();
    if (!value) return Taken::Nothing;
    onValue(std::move(*value));
    return Taken::Value;
  } catch (const Stopped&) {
    return Taken::Stopped;
  } catch (const std::bad_alloc&) {
    messages.error("There is not enough memory for " + purpose + ".");
  } catch (const std::exception& error) {
    messages.error(error.what());
  }
  return Taken::Failed;
}

}  // namespace swaplight
