#include "core/image/io/picture_message.h"

#include <algorithm>
#include <new>
#include <optional>

#include "core/base/json.h"
#include "core/base/json_integer.h"
#include "core/base/machine_error.h"
#include "core/base/out_of_memory.h"
#include "core/image/io/image_format.h"

namespace swaplight {
namespace {

int wholeNumber(const Json& json) {
  const std::optional<int> number = integerOf(json);
  if (!number) throw std::runtime_error("no whole number, or too large a one");
  return *number;
}

std::vector<int> integersOf(const Json& json) {
  std::vector<int> numbers;
  for (const Json& number : json) numbers.push_back(wholeNumber(number));
  return numbers;
}

std::array<int, 4> fourOf(const Json& json) {
  return {wholeNumber(json.at(0)), wholeNumber(json.at(1)), wholeNumber(json.at(2)), wholeNumber(json.at(3))};
}

std::string bytesOf(const Json& json) {
  std::string bytes;
  Json::to_cbor(json, bytes);
  return bytes;
}

Json jsonOf(const std::string& message) {
  return Json::from_cbor(message);
}

template <typename Enum>
Json numbersOf(const std::vector<Enum>& values) {
  Json list = Json::array();
  for (const Enum value : values) list.push_back(static_cast<int>(value));
  return list;
}

PixelType pixelTypeAt(int number) {
  if (number < 0 || number > static_cast<int>(PixelType::Float)) throw std::runtime_error("no type");
  return static_cast<PixelType>(number);
}

std::vector<PixelType> typesFrom(const Json& json) {
  std::vector<PixelType> types;
  for (const Json& number : json) types.push_back(pixelTypeAt(wholeNumber(number)));
  return types;
}

Json jsonFrom(const HeaderValues& values) {
  Json list = Json::array();
  for (const auto& [name, value] : values)
    list.push_back({name, static_cast<int>(value.kind), value.text, value.integers, value.floats});
  return list;
}

HeaderValues headerFrom(const Json& json) {
  using enum HeaderValue::Kind;
  HeaderValues values;
  for (const Json& one : json) {
    HeaderValue& value = values[one.at(0).get<std::string>()];
    value.kind =
        static_cast<HeaderValue::Kind>(std::clamp(wholeNumber(one.at(1)), 0, static_cast<int>(Keycode)));
    value.text = one.at(2).get<std::string>();
    value.integers = integersOf(one.at(3));
    value.floats = one.at(4).get<std::vector<float>>();
    const size_t integers = value.integers.size(), floats = value.floats.size();
    const bool suits = value.kind == Text       ? integers + floats == 0
                       : value.kind == Integers ? integers >= 1 && integers <= 3
                       : value.kind == Floats   ? floats >= 1 && floats <= 16
                       : value.kind == Keycode  ? integers == 7
                                                : integers == 2;
    if (!suits) throw std::runtime_error("no header");
  }
  return values;
}

Json jsonFrom(const ImageFileInfo& info) {
  Json json = {{"format", info.format},
               {"pixelType", info.pixelType},
               {"bits", info.bits},
               {"isFloat", info.isFloat},
               {"parts", info.parts},
               {"statedColors", info.statedColors},
               {"header", jsonFrom(info.header)},
               {"pixelAspect", info.pixelAspect},
               {"channelTypes", numbersOf(info.channelTypes)},
               {"text", Json::array()},
               {"numbers", Json::array()}};
  for (const auto& entry : info.text) json["text"].push_back({entry.first, entry.second});
  for (const auto& entry : info.numbers) json["numbers"].push_back({entry.first, entry.second});
  if (const auto& window = info.dataWindow)
    json["dataWindow"] = {window->x, window->y, window->width, window->height};
  return json;
}

ImageFileInfo infoFrom(const Json& json) {
  ImageFileInfo info;
  info.format = json.at("format").get<std::string>();
  info.pixelType = json.at("pixelType").get<std::string>();
  info.bits = wholeNumber(json.at("bits"));
  info.isFloat = json.at("isFloat").get<bool>();
  info.parts = wholeNumber(json.at("parts"));
  info.statedColors = json.at("statedColors").get<std::string>();
  info.header = headerFrom(json.at("header"));
  info.pixelAspect = json.at("pixelAspect").get<float>();
  info.channelTypes = typesFrom(json.at("channelTypes"));
  for (const Json& entry : json.at("text"))
    info.text[entry.at(0).get<std::string>()] = entry.at(1).get<std::string>();
  for (const Json& entry : json.at("numbers"))
    info.numbers[entry.at(0).get<std::string>()] = entry.at(1).get<double>();
  if (json.contains("dataWindow")) {
    const auto at = fourOf(json.at("dataWindow"));
    info.dataWindow = PixelRect{at[0], at[1], at[2], at[3]};
  }
  return info;
}

Json jsonFrom(const PicturePart& part) {
  return {{"at", {part.x, part.y, part.width, part.height}},
          {"types", numbersOf(part.types)},
          {"channels", part.channels},
          {"rowsByChannel", part.rowsByChannel}};
}

/// Throws where the part does not fit the picture.
PicturePart partFrom(const Json& json, const ImageSpec& spec, const std::string& file) {
  constexpr int kFar = 1 << 18;
  PicturePart part;
  const auto at = fourOf(json.at("at"));
  part.x = at[0], part.y = at[1], part.width = at[2], part.height = at[3];
  part.types = typesFrom(json.at("types"));
  part.channels = integersOf(json.at("channels"));
  part.rowsByChannel = json.at("rowsByChannel").get<bool>();
  checkImageFits(file, part.width, part.height, static_cast<int>(part.types.size()));
  std::vector<int> sorted = part.channels;
  std::sort(sorted.begin(), sorted.end());
  bool fits = sorted.size() == part.types.size() && std::abs(int64_t{part.x}) <= kFar &&
              std::abs(int64_t{part.y}) <= kFar;
  for (size_t i = 0; i < sorted.size(); ++i) fits &= sorted[i] == static_cast<int>(i);
  if (part.rowsByChannel)
    fits &= part.x == 0 && part.y == 0 && part.width == spec.width && part.height == spec.height;
  if (!fits) throw std::runtime_error("parts that are none");
  return part;
}

/// The other process' error is thrown here.
void throwIfFailed(const Json& json) {
  if (!json.contains("error")) return;
  const auto kind = json.at("error").get<std::string>();
  const auto words = json.at("words").get<std::string>();
  if (kind == "memory") throw std::bad_alloc();
  if (kind == "machine") throw MachineError(words);
  throw InputError(words);
}

}  // namespace

std::string messageOf(const PictureRequest& request) {
  return bytesOf({{"file", request.file.string()}, {"threads", request.threads}});
}

PictureRequest pictureRequestOf(const std::string& message) {
  const Json json = jsonOf(message);
  return {json.at("file").get<std::string>(), wholeNumber(json.at("threads"))};
}

std::string messageOf(const PictureAnswer& answer) {
  const ImageSpec& spec = answer.contents.spec;
  Json json = {{"size", {spec.width, spec.height}},      {"channels", spec.channels},
               {"colorSpace", spec.colorSpace},          {"orientation", answer.contents.orientation},
               {"info", jsonFrom(answer.contents.info)}, {"parts", Json::array()},
               {"bandBytes", answer.bandBytes}};
  for (const PicturePart& part : answer.contents.parts) json["parts"].push_back(jsonFrom(part));
  return bytesOf(json);
}

PictureAnswer pictureAnswerOf(const std::string& message, const std::string& file) {
  const Json json = jsonOf(message);
  throwIfFailed(json);
  PictureAnswer answer;
  PictureContents& contents = answer.contents;
  contents.spec.width = wholeNumber(json.at("size").at(0));
  contents.spec.height = wholeNumber(json.at("size").at(1));
  contents.spec.channels = json.at("channels").get<std::vector<std::string>>();
  contents.spec.colorSpace = json.at("colorSpace").get<std::string>();
  contents.orientation = wholeNumber(json.at("orientation"));
  contents.info = infoFrom(json.at("info"));
  checkImageFits(file, contents.spec.width, contents.spec.height, contents.spec.channelCount());
  size_t channels = 0, largest = 0;
  for (const Json& part : json.at("parts")) {
    contents.parts.push_back(partFrom(part, contents.spec, file));
    const PicturePart& read = contents.parts.back();
    channels += read.channels.size();
    largest = std::max(largest, read.rowBytes() * static_cast<size_t>(read.height));
  }
  answer.bandBytes = json.at("bandBytes").get<size_t>();
  const bool fits = channels == contents.spec.channels.size() && !contents.parts.empty() &&
                    contents.info.channelTypes.size() == channels && answer.bandBytes > 0 &&
                    answer.bandBytes <= largest;
  if (!fits) throw std::runtime_error("contents that do not fit together");
  checkBandFits(file, answer.bandBytes);
  return answer;
}

std::string messageOf(const BandAnswer& answer) {
  return bytesOf({answer.band.part, answer.band.y, answer.band.rows, answer.slot, answer.last});
}

BandAnswer bandAnswerOf(const std::string& message, const PictureAnswer& picture) {
  const Json json = jsonOf(message);
  if (json.is_object()) throwIfFailed(json);
  const BandAnswer answer{{wholeNumber(json.at(0)), wholeNumber(json.at(1)), wholeNumber(json.at(2))},
                          wholeNumber(json.at(3)),
                          json.at(4).get<bool>()};
  if (answer.last) return answer;
  const auto& parts = picture.contents.parts;
  const PictureBand& band = answer.band;
  if (band.part < 0 || static_cast<size_t>(band.part) >= parts.size()) throw std::runtime_error("no part");
  const PicturePart& part = parts[static_cast<size_t>(band.part)];
  const bool fits = band.y >= 0 && band.rows > 0 && band.rows <= part.height &&
                    band.y <= part.height - band.rows &&
                    part.rowBytes() * static_cast<size_t>(band.rows) <= picture.bandBytes &&
                    (answer.slot == 0 || answer.slot == 1);
  if (!fits) throw std::runtime_error("no band");
  return answer;
}

std::string messageOf(std::exception_ptr error) {
  const auto message = [](const char* kind, const char* words) {
    return bytesOf({{"error", kind}, {"words", words}});
  };
  try {
    std::rethrow_exception(std::move(error));
  } catch (const MachineError& known) {
    return message("machine", known.what());
  } catch (const InputError& known) {
    return message("input", known.what());
  } catch (const std::exception& other) {
    return message(isOutOfMemory(other) ? "memory" : "input", other.what());
  }
}

}  // namespace swaplight
