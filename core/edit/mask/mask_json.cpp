#include <fmt/format.h>

#include <optional>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/fields/field_json.h"
#include "core/edit/mask/mask.h"

namespace swaplight {
namespace {

constexpr const char* kCombineNames[] = {"add", "subtract", "intersect"};

Json jsonFromShape(const MaskShape& shape) {
  Json json = Json::object();
  std::visit(
      [&](const auto& s) {
        json["shape"] = s.info.name;
        writeFields(s, json);
        if constexpr (requires { s.writeMore(json); }) s.writeMore(json);
      },
      shape.shape);
  if (shape.invert) json["invert"] = true;
  return json;
}

MaskShape shapeFromFields(JsonFields& fields, int width, int height) {
  const std::string name = fields.text("shape").value_or("");
  std::optional<MaskShape> found;
  std::vector<std::string> names;
  forEachShape([&]<typename T>(T shape) {
    names.emplace_back(T::info.name);
    if (name != T::info.name) return;
    readFields(fields, shape);
    if constexpr (requires { shape.readMore(fields, width, height); }) shape.readMore(fields, width, height);
    if constexpr (requires { shape.check(name); }) shape.check(fields.where());
    found = MaskShape{std::move(shape)};
  });
  if (!found)
    throw InputError("{}: \"{}\" is no shape, expected one of {}.", fields.where(), name,
                     fmt::join(names, ", "));
  found->invert = fields.boolean("invert").value_or(false);
  return *found;
}

SelectionPart partFromJson(const Json& json, int width, int height, JsonFields& selection, size_t number) {
  const std::string where = fmt::format("{}: part {}", selection.where(), number);
  JsonFields fields(json, where);
  SelectionPart part{shapeFromFields(fields, width, height), {}};
  if (std::holds_alternative<PaintShape>(part.shape.shape) ||
      std::holds_alternative<ImageShape>(part.shape.shape))
    throw InputError("{}: painted shapes and gobo images cannot be parts of a selection.", where);
  part.how = static_cast<SelectionPart::Combine>(choiceFromJson(fields, "combine", kCombineNames));
  selection.takeIn(fields);
  return part;
}

}  // namespace

void SelectionShape::writeMore(Json& json) const {
  Json& list = json["parts"] = Json::array();
  for (const SelectionPart& part : *parts)
    list.emplace_back(jsonFromShape(part.shape))["combine"] = kCombineNames[static_cast<size_t>(part.how)];
}

void SelectionShape::readMore(JsonFields& fields, int width, int height) {
  std::vector<SelectionPart> read;
  for (const Json& part : fields.list("parts", "a list of shapes"))
    read.push_back(partFromJson(part, width, height, fields, read.size() + 1));
  parts = std::make_shared<const std::vector<SelectionPart>>(std::move(read));
}

Json jsonFromMask(const Mask& mask) {
  Json json = Json::array();
  for (const MaskShape& shape : mask) json.push_back(jsonFromShape(shape));
  return json;
}

Mask maskFromJson(const Json& json, int width, int height, const std::string& where,
                  std::vector<std::string>* warnings) {
  if (!json.is_array()) throw InputError("{}: is {}, expected a list of shapes.", where, describeJson(json));
  Mask mask;
  for (const Json& item : json) {
    JsonFields fields(item, where + ": shape " + std::to_string(mask.size() + 1));
    mask.push_back(shapeFromFields(fields, width, height));
    if (warnings) fields.warnOfUnknown(*warnings);
  }
  return mask;
}

}  // namespace swaplight
