#include "core/session/unknown_keys.h"

#include <algorithm>
#include <iterator>
#include "core/base/json.h"
namespace swaplight {
namespace {

const char* const kIdentities[] = {"name", "light", "id"};

bool sameIdentity(const Json& a, const Json& b) {
  if (!a.is_object() || !b.is_object()) return false;
  for (const char* key : kIdentities)
    if (a.contains(key)) return b.contains(key) && a[key] == b[key];
  return false;
}

bool hasIdentity(const Json& item) {
  return item.is_object() && std::any_of(std::begin(kIdentities), std::end(kIdentities),
                                         [&](const char* key) { return item.contains(key); });
}

// Both lists are in the same order, nearly always: the search goes on behind `last`, where the partner of the
// item before was found, and then from the beginning.
const Json* findPartner(const Json& array, const Json& item, size_t& last) {
  if (!hasIdentity(item)) return nullptr;
  const size_t count = array.size();
  for (size_t i = 0; i < count; ++i)
    if (const size_t at = (last + i) % count; sameIdentity(item, array[at])) {
      last = at + 1;
      return &array[at];
    }
  return nullptr;
}

// An element of an array is found again by its identity, which therefore travels with its unknown keys.
Json withIdentity(Json unknown, const Json& item) {
  for (const char* key : kIdentities)
    if (item.contains(key)) {
      unknown[key] = item[key];
      break;
    }
  return unknown;
}

}  // namespace

Json unknownKeys(const Json& read, const Json& understood) {
  if (read.is_object() && understood.is_object()) {
    Json unknown = Json::object();
    for (const auto& [key, value] : read.items()) {
      const auto known = understood.find(key);
      if (known == understood.end()) {
        unknown[key] = value;
        continue;
      }
      Json inner = unknownKeys(value, *known);
      if (!inner.empty()) unknown[key] = std::move(inner);
    }
    return unknown;
  }
  if (read.is_array() && understood.is_array()) {
    Json unknown = Json::array();
    size_t last = 0;
    for (const Json& item : read) {
      const Json* partner = findPartner(understood, item, last);
      if (!partner) continue;
      const Json inner = unknownKeys(item, *partner);
      if (!inner.empty()) unknown.push_back(withIdentity(inner, item));
    }
    return unknown;
  }
  return {};
}

void keepUnknownKeys(Json& written, const Json& unknown) {
  if (written.is_object() && unknown.is_object()) {
    for (const auto& [key, value] : unknown.items()) {
      const auto own = written.find(key);
      if (own == written.end())
        written[key] = value;
      else
        keepUnknownKeys(*own, value);
    }
  } else if (written.is_array() && unknown.is_array()) {
    size_t last = 0;
    for (Json& item : written)
      if (const Json* partner = findPartner(unknown, item, last)) keepUnknownKeys(item, *partner);
  }
}

}  // namespace swaplight
