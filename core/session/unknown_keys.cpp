#include "core/session/unknown_keys.h"

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

const Json* findPartner(const Json& array, const Json& item) {
  for (const Json& other : array)
    if (sameIdentity(item, other)) return &other;
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
    for (const Json& item : read) {
      const Json* partner = findPartner(understood, item);
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
    for (Json& item : written)
      if (const Json* partner = findPartner(unknown, item)) keepUnknownKeys(item, *partner);
  }
}

}  // namespace swaplight
