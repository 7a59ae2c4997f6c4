#include "core/base/kept_json.h"

#include "core/base/json.h"

namespace swaplight {

KeptJson::KeptJson(const Json& object) : KeptJson(Json(object)) {}

KeptJson::KeptJson(Json&& object) {
  if (object.is_object() && !object.empty()) m_object = std::make_shared<const Json>(std::move(object));
}

const Json& KeptJson::json() const {
  static const Json kNone = Json::object();
  return m_object ? *m_object : kNone;
}

bool KeptJson::operator==(const KeptJson& other) const {
  return json() == other.json();
}

}  // namespace swaplight
