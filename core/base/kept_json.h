#pragma once

#include <memory>

#include "core/base/json_fwd.h"

namespace swaplight {

/// An object of JSON that is carried along unread, to be written again: the keys of a file that this program
/// does not know. A value; copies share what they hold, which does not change.
class KeptJson {
 public:
  /// No keys.
  KeptJson() = default;
  /// What is no object (null) counts as no keys.
  KeptJson(const Json& object);  // NOLINT(google-explicit-constructor): it is the object
  KeptJson(Json&& object);       // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool empty() const { return !m_object; }
  /// An object, empty where there are no keys.
  [[nodiscard]] const Json& json() const;
  bool operator==(const KeptJson& other) const;

 private:
  std::shared_ptr<const Json> m_object;  ///< null: no keys
};

}  // namespace swaplight
