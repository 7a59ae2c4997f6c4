#include "core/file/json_fields.h"

#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/json.h"

namespace swaplight {

std::string describeJson(const Json& value) {
  if (value.is_null()) return "null";
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_number()) return fmt::format("the number {}", value.dump());
  if (value.is_string()) return fmt::format("the text \"{}\"", value.get<std::string>().substr(0, 60));
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  return "an object";
}

JsonFields::JsonFields(const Json& object, std::string where) : m_object(object), m_where(std::move(where)) {
  if (!object.is_object())
    throw InputError("{}: is {}, expected an object {{...}}.", m_where, describeJson(object));
}

const Json* JsonFields::find(const std::string& key) {
  m_known.insert(key);
  const auto found = m_object.find(key);
  return found == m_object.end() ? nullptr : &*found;
}

const Json& JsonFields::list(const std::string& key, const std::string& what) {
  const Json* value = find(key);
  if (!value) throw InputError("{}: \"{}\" is missing, expected {}.", m_where, key, what);
  if (!value->is_array())
    throw InputError("{}: \"{}\" is {}, expected {}.", m_where, key, describeJson(*value), what);
  return *value;
}

const Json& JsonFields::list(const std::string& key, const std::string& what, size_t most) {
  const Json& value = list(key, what);
  if (value.size() > most)
    throw InputError("{}: \"{}\" is a list of {}, expected at most {}.", m_where, key, value.size(), most);
  return value;
}

std::optional<std::string> JsonFields::text(const std::string& key) {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_string())
    throw InputError("{}: \"{}\" is {}, expected a text.", m_where, key, describeJson(*value));
  return value->get<std::string>();
}

std::optional<double> JsonFields::number(const std::string& key, double low, double high) {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  const double number = value->is_number() ? value->get<double>() : std::nan("");
  if (!(number >= low && number <= high))
    throw InputError("{}: \"{}\" is {}, expected a number from {} to {}.", m_where, key, describeJson(*value),
                     low, high);
  return number;
}

std::optional<bool> JsonFields::boolean(const std::string& key) {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_boolean())
    throw InputError("{}: \"{}\" is {}, expected true or false.", m_where, key, describeJson(*value));
  return value->get<bool>();
}

Json JsonFields::unknown() const {
  Json rest = Json::object();
  for (const auto& [key, value] : m_object.items())
    if (!m_known.contains(key)) rest[key] = value;
  return rest;
}

void JsonFields::takeIn(const JsonFields& part) {
  part.warnOfUnknown(m_ofParts);
}

void JsonFields::warnOfUnknown(std::vector<std::string>& warnings) const {
  const Json strangers = unknown();
  for (const auto& [key, value] : strangers.items())
    warnings.push_back(fmt::format("{}: the unknown key \"{}\" is not used", m_where, key));
  warnings.insert(warnings.end(), m_ofParts.begin(), m_ofParts.end());
}

}  // namespace swaplight
