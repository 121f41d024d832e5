#pragma once

// JSON with errors that say where: file:line:column for syntax, file: field for content.

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/base/job_context.h"
#include "core/base/result.h"

namespace cutis {

// A value inside a document; keeps the document alive. Getters fail with a sentence that names the
// field; those with a fallback return it only if the field is absent.
class JsonValue {
 public:
  // Precondition for getters with a key: isObject().
  bool isObject() const;
  bool has(const std::string& key) const;
  bool isNull(const std::string& key) const;  // there, and null
  // Names of all fields, sorted.
  std::vector<std::string> keys() const;
  // Every text in it, however deep; names of fields are left out.
  std::vector<std::string> texts() const;

  Result<JsonValue> object(const std::string& key) const;
  // Elements of an array field.
  Result<std::vector<JsonValue>> array(const std::string& key) const;
  // The array itself, for asNumbers().
  Result<JsonValue> list(const std::string& key) const;
  Result<double> number(const std::string& key) const;  // finite
  Result<double> number(const std::string& key, double fallback) const;
  Result<int> integer(const std::string& key) const;
  Result<bool> boolean(const std::string& key, bool fallback) const;
  Result<std::string> text(const std::string& key) const;
  Result<std::string> text(const std::string& key, const std::string& fallback) const;

  // This value itself, as exactly `count` finite numbers, a finite number or a text.
  Result<std::vector<double>> asNumbers(std::size_t count) const;
  Result<double> asNumber() const;
  Result<std::string> asText() const;

  // Fails if there is a field of another name: a misspelt option must not pass as absent.
  Status allowOnly(std::initializer_list<std::string_view> keys) const {
    return allowOnly(std::span(keys.begin(), keys.size()));
  }
  Status allowOnly(std::span<const std::string_view> keys) const;
  // For files that later versions may say more in: notes each field of another name.
  void sayUnknown(std::initializer_list<std::string_view> keys, const Notice& notice) const {
    sayUnknown(std::span(keys.begin(), keys.size()), notice);
  }
  void sayUnknown(std::span<const std::string_view> keys, const Notice& notice) const;

  // "file: field.inner must be …"
  Error error(const std::string& demand) const;
  Error error(const std::string& key, const std::string& demand) const;
  const std::string& file() const { return file_; }

 private:
  friend Result<JsonValue> parseJson(std::string_view text, const std::string& place);
  JsonValue(std::shared_ptr<const nlohmann::json> root, const nlohmann::json* node,
            std::string file, std::string path);
  JsonValue child(const nlohmann::json& node, const std::string& path) const;
  std::string pathOf(const std::string& key) const;
  const nlohmann::json* find(const std::string& key) const;
  // Paths of the fields of other names, sorted: "lights[1].colour".
  std::vector<std::string> unknownFields(std::span<const std::string_view> known) const;

  std::shared_ptr<const nlohmann::json> root_;
  const nlohmann::json* node_;
  std::string file_;
  std::string path_;  // "lights[1].mix"
};

// The root must be an object.
Result<JsonValue> parseJson(std::string_view text, const std::string& place);
Result<JsonValue> readJson(const std::filesystem::path& path);

// Checks the version field that our own files start with, e.g. "cutis_rig": 1. A file without it is
// not of this kind; one with a higher number comes from a newer program.
Status checkVersion(const JsonValue& root, const std::string& key, int newest);

}  // namespace cutis
