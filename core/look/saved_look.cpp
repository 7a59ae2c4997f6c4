#include "core/look/saved_look.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/look/look.h"

namespace swaplight {

const SavedLook* findSavedLook(const std::vector<SavedLook>& looks, const std::string& name) {
  const auto found = std::find_if(looks.begin(), looks.end(),
                                  [&](const SavedLook& look) { return sameLookName(look.name, name); });
  return found == looks.end() ? nullptr : &*found;
}

std::string freeLookName(const std::vector<SavedLook>& looks, const std::string& kind) {
  for (size_t number = 1;; ++number) {
    std::string name = fmt::format("{} {}", kind, number);
    if (!findSavedLook(looks, name)) return name;
  }
}

void addLook(std::vector<SavedLook>& looks, SavedLook look) {
  if (looks.size() >= kMostLooks)
    throw InputError("The gallery has {} looks, and takes no more. Remove one first.", looks.size());
  looks.push_back(std::move(look));
}

Json jsonFromSavedLooks(const std::vector<SavedLook>& looks) {
  Json json = Json::array();
  for (const SavedLook& look : looks) {
    Json entry{{"name", look.name}, {"rig", jsonFromRig(look.rig)}};
    if (!look.note.empty()) entry["note"] = look.note;
    json.push_back(std::move(entry));
  }
  return json;
}

std::vector<SavedLook> savedLooksFromJson(const Json& json, const std::string& where) {
  if (!json.is_array()) throw InputError("{}: must be a list of looks", where);
  if (json.size() > kMostLooks)
    throw InputError("{}s: are {}, expected at most {}", where, json.size(), kMostLooks);
  std::vector<SavedLook> looks;
  for (const Json& entry : json) {
    const std::string which = fmt::format("{} {}", where, looks.size() + 1);
    JsonFields fields(entry, which);
    SavedLook look{fields.text("name").value_or(""), fields.text("note").value_or(""), {}, {}};
    if (look.name.empty()) look.name = freeLookName(looks);
    const Json* rig = fields.find("rig");
    if (!rig) throw InputError("{} ({}): \"rig\" is missing", which, look.name);
    look.rig = rigFromJson(*rig, fmt::format("{} ({})", which, look.name));
    looks.push_back(std::move(look));
  }
  return looks;
}

}  // namespace swaplight
