#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/json_fwd.h"

namespace swaplight {

/// Reads the fields of a JSON object with checks, and remembers which were asked for: the others are unknown
/// and can be kept. Every method throws InputError that says where, what was found, what was expected.
class JsonFields {
 public:
  /// `where` begins the messages: "capture.json", "capture.json: shot 2". Throws where `object` is none.
  JsonFields(const Json& object, std::string where);

  /// A field, or nullptr where it is missing. (null is a value.)
  const Json* find(const std::string& key);
  /// A list; `what` says what belongs into it, for the message where it is missing.
  const Json& list(const std::string& key, const std::string& what);
  /// As many elements as this kind of list can have, with room; more would only take time. Throws InputError.
  const Json& list(const std::string& key, const std::string& what, size_t most);
  std::optional<std::string> text(const std::string& key);
  /// A finite number in [low, high].
  std::optional<double> number(const std::string& key, double low, double high);
  std::optional<bool> boolean(const std::string& key);

  /// The fields that nobody asked for.
  [[nodiscard]] Json unknown() const;
  /// Adds a sentence for each of them, and of the parts taken in: a key may be misspelt.
  void warnOfUnknown(std::vector<std::string>& warnings) const;
  /// Takes in an object within this one that has been read: its unknown fields are warned of with these.
  void takeIn(const JsonFields& part);
  [[nodiscard]] const std::string& where() const { return m_where; }
  /// Once more is known about the object.
  void setWhere(std::string where) { m_where = std::move(where); }

 private:
  const Json& m_object;
  std::string m_where;
  std::set<std::string> m_known;
  std::vector<std::string> m_ofParts;  ///< warnings
};

/// What a JSON value is, in words: "a text", "a list of 3", "null".
[[nodiscard]] std::string describeJson(const Json& value);

}  // namespace swaplight
