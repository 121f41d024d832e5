#include "src/files/io/json_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "core/base/echoed_text.h"
#include "core/base/word_list.h"
#include "src/files/io/text_file.h"

namespace cutis {
namespace {

using nlohmann::json;

struct TextPosition {
  std::size_t line = 1;
  std::size_t column = 1;
};

// Columns count characters, as editors do: in UTF-8 all bytes but those that continue one.
TextPosition positionOf(std::string_view text, std::size_t byte) {
  TextPosition position;
  for (std::size_t i = 0; i < std::min(byte, text.size()); ++i) {
    if (text[i] == '\n') {
      ++position.line;
      position.column = 1;
    } else if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) {
      ++position.column;
    }
  }
  return position;
}

// The parser's own words, without its prefix and position: "syntax error while parsing …".
std::string reason(const json::parse_error& error) {
  std::string text = error.what();
  const auto marker = text.find(": ");
  if (marker != std::string::npos) text = text.substr(marker + 2);
  // What the file holds there, however long.
  const auto read = text.find("last read: '");
  const auto end = text.rfind('\'');
  if (read != std::string::npos && end > text.find('\'', read)) {
    const auto begin = text.find('\'', read) + 1;
    text = text.substr(0, begin - 1) + inQuotes(text.substr(begin, end - begin)) +
           text.substr(end + 1);
  }
  return onOneLine(std::move(text));
}

}  // namespace

JsonValue::JsonValue(std::shared_ptr<const json> root, const json* node, std::string file,
                     std::string path)
    : root_(std::move(root)), node_(node), file_(std::move(file)), path_(std::move(path)) {}

JsonValue JsonValue::child(const json& node, const std::string& path) const {
  return {root_, &node, file_, path};
}

std::string JsonValue::pathOf(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

const json* JsonValue::find(const std::string& key) const {
  const auto found = node_->find(key);
  return found == node_->end() ? nullptr : &*found;
}

bool JsonValue::isObject() const {
  return node_->is_object();
}
bool JsonValue::has(const std::string& key) const {
  return find(key) != nullptr;
}
bool JsonValue::isNull(const std::string& key) const {
  return has(key) && find(key)->is_null();
}

std::vector<std::string> JsonValue::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : node_->items()) {
    names.push_back(key);
  }
  return names;
}

std::vector<std::string> JsonValue::unknownFields(std::span<const std::string_view> known) const {
  std::vector<std::string> unknown;
  for (const std::string& key : keys()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) unknown.push_back(pathOf(key));
  }
  return unknown;
}

std::vector<std::string> JsonValue::texts() const {
  std::vector<std::string> found;
  std::vector<const nlohmann::json*> open = {node_};
  while (!open.empty()) {
    const nlohmann::json& value = *open.back();
    open.pop_back();
    if (value.is_string()) found.push_back(value.get<std::string>());
    if (!value.is_structured()) continue;
    for (const nlohmann::json& element : value)
      open.push_back(&element);
  }
  return found;
}

Error JsonValue::error(const std::string& demand) const {
  return inputError(file_, (path_.empty() ? "the file" : path_) + " must be " + demand);
}

Error JsonValue::error(const std::string& key, const std::string& demand) const {
  const std::string state = has(key) ? "" : " (it is missing)";
  return inputError(file_, pathOf(key) + " must be " + demand + state);
}

Result<JsonValue> JsonValue::object(const std::string& key) const {
  const json* field = find(key);
  if (field == nullptr || !field->is_object()) return error(key, "an object");
  return child(*field, pathOf(key));
}

Result<std::vector<JsonValue>> JsonValue::array(const std::string& key) const {
  const json* field = find(key);
  if (field == nullptr || !field->is_array()) return error(key, "a list");
  std::vector<JsonValue> elements;
  for (std::size_t i = 0; i < field->size(); ++i) {
    elements.push_back(child((*field)[i], pathOf(key) + "[" + std::to_string(i) + "]"));
  }
  return elements;
}

Result<std::vector<double>> JsonValue::asNumbers(std::size_t count) const {
  const std::string demand = "a list of " + std::to_string(count) + " finite numbers";
  if (!node_->is_array() || node_->size() != count) return error(demand);
  std::vector<double> numbers;
  numbers.reserve(count);
  for (const json& element : *node_) {
    if (!element.is_number() || !std::isfinite(element.get<double>())) return error(demand);
    numbers.push_back(element.get<double>());
  }
  return numbers;
}

Result<JsonValue> JsonValue::list(const std::string& key) const {
  const json* field = find(key);
  if (field == nullptr || !field->is_array()) return error(key, "a list");
  return child(*field, pathOf(key));
}

Result<double> JsonValue::asNumber() const {
  if (!node_->is_number() || !std::isfinite(node_->get<double>())) return error("a finite number");
  return node_->get<double>();
}

Result<std::string> JsonValue::asText() const {
  if (!node_->is_string()) return error("a text");
  return node_->get<std::string>();
}

Result<bool> JsonValue::boolean(const std::string& key, bool fallback) const {
  const json* field = find(key);
  if (field == nullptr) return fallback;
  if (!field->is_boolean()) return error(key, "true or false");
  return field->get<bool>();
}

Result<double> JsonValue::number(const std::string& key) const {
  const json* field = find(key);
  if (field == nullptr) return error(key, "a number");
  return child(*field, pathOf(key)).asNumber();
}

Result<double> JsonValue::number(const std::string& key, double fallback) const {
  if (!has(key)) return fallback;
  return number(key);
}

Result<int> JsonValue::integer(const std::string& key) const {
  const json* field = find(key);
  if (field == nullptr || !field->is_number_integer()) return error(key, "a whole number");
  // Beyond 2⁶³ the library holds it without a sign, and would turn it round on the way to one.
  const bool huge = field->is_number_unsigned() && field->get<std::uint64_t>() > INT32_MAX;
  const auto wide = field->get<std::int64_t>();
  if (huge || wide < INT32_MIN || wide > INT32_MAX) return error(key, "a smaller whole number");
  return static_cast<int>(wide);
}

Result<std::string> JsonValue::text(const std::string& key) const {
  const json* field = find(key);
  if (field == nullptr || !field->is_string()) return error(key, "a text");
  return field->get<std::string>();
}

Result<std::string> JsonValue::text(const std::string& key, const std::string& fallback) const {
  if (!has(key)) return fallback;
  return text(key);
}

Status JsonValue::allowOnly(std::span<const std::string_view> keys) const {
  const std::vector<std::string> unknown = unknownFields(keys);
  if (unknown.empty()) return {};
  return inputError(file_, "unknown field " + inQuotes(unknown.front()) +
                               "; known here: " + wordList(keys, ", "));
}

void JsonValue::sayUnknown(std::span<const std::string_view> keys, const Notice& notice) const {
  if (!notice) return;
  for (const std::string& field : unknownFields(keys))
    notice(file_ + ": " + inQuotes(field) + " means nothing to this version and is passed over");
}

Result<JsonValue> parseJson(std::string_view text, const std::string& place) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  try {
    auto root = std::make_shared<const json>(json::parse(text));
    if (!root->is_object()) return inputError(place, "the file must contain one JSON object { … }");
    const json* node = root.get();
    return JsonValue(std::move(root), node, place, {});
  } catch (const json::parse_error& error) {
    // The reported byte is one past the last one read.
    const TextPosition at = positionOf(text, error.byte > 0 ? error.byte - 1 : 0);
    return inputError(place + ":" + std::to_string(at.line) + ":" + std::to_string(at.column),
                      "not valid JSON (" + reason(error) + "); correct it there");
  } catch (const json::exception& error) {
    return inputError(place, std::string("not valid JSON (") + error.what() + "); correct it");
  }
}

Result<JsonValue> readJson(const std::filesystem::path& path) {
  CUTIS_TRY(text, readTextFile(path));
  return parseJson(text, path.string());
}

Status checkVersion(const JsonValue& root, const std::string& key, int newest) {
  if (!root.has(key)) {
    return inputError(root.file(),
                      "the field \"" + key + "\": " + std::to_string(newest) +
                          " is missing; this does not look like the right kind of file");
  }
  CUTIS_TRY(version, root.integer(key));
  if (version > newest) {
    return inputError(root.file(),
                      key + " is " + std::to_string(version) +
                          ", written by a newer version of Cutis; this one reads up to " +
                          std::to_string(newest));
  }
  if (version < 1) return root.error(key, "a version number from 1");
  return {};
}

}  // namespace cutis
