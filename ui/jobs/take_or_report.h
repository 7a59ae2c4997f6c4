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
/// what there may be too little memory for, as "this export". A job that has done its work takes back what it
/// said when it last failed.
template <typename Result, typename OnValue>
Taken takeOrReport(Job<Result>& job, Messages& messages, const std::string& purpose, const OnValue& onValue) {
  try {
    auto value = job.take();
    if (!value) return Taken::Nothing;
    onValue(std::move(*value));
    messages.succeeded(&job);
    return Taken::Value;
  } catch (const Stopped&) {
    return Taken::Stopped;
  } catch (const std::bad_alloc&) {
    messages.failed(&job, "There is not enough memory for " + purpose + ".");
  } catch (const std::exception& error) {
    messages.failed(&job, error.what());
  }
  return Taken::Failed;
}

}  // namespace swaplight
