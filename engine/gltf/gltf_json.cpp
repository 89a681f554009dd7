#include "engine/gltf/gltf_json.h"

#include <algorithm>
#include <limits>
#include <string>

namespace palpate::gltf {
namespace {

constexpr int kDeepest = 256;  // core glTF nests 8 deep; `extras` may be deeper
constexpr std::uint64_t kLargestIndex = std::numeric_limits<std::int32_t>::max();

void bound_nesting(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char byte = text[i];
    if (in_string) {
      if (byte == '\\') ++i;
      if (byte == '"') in_string = false;
    } else if (byte == '"') {
      in_string = true;
    } else if (byte == '{' || byte == '[') {
      if (++depth > kDeepest) fail(ErrorCode::kLimit, "the JSON nests deeper than ", kDeepest);
    } else if (byte == '}' || byte == ']') {
      --depth;
    }
  }
}

bool is_index(const Json& value) {
  return value.is_number_unsigned() && value.get<std::uint64_t>() <= kLargestIndex;
}

bool is_number(const Json& value) {
  return value.is_number();
}

template <class Test>
bool all_are(const Json& values, Test test) {
  return std::all_of(values.begin(), values.end(), test);
}

bool is_of_kind(const Json& value, JsonKind kind) {
  switch (kind) {
    case JsonKind::kFlag:
      return value.is_boolean();
    case JsonKind::kIndex:
      return is_index(value);
    case JsonKind::kSize:
      return value.is_number_unsigned();
    case JsonKind::kText:
      return value.is_string();
    case JsonKind::kNumbers:
      return value.is_array() && all_are(value, is_number);
    case JsonKind::kIndices:
      return value.is_array() && all_are(value, is_index);
    case JsonKind::kIndexByName:
      return value.is_object() && all_are(value, is_index);
    case JsonKind::kArray:
      return value.is_array();
    case JsonKind::kObject:
      return value.is_object();
  }
  return false;
}

const char* describe(JsonKind kind) {
  switch (kind) {
    case JsonKind::kFlag:
      return "true or false";
    case JsonKind::kIndex:
      return "an index, 0 to 2147483647";
    case JsonKind::kSize:
      return "a non-negative integer";
    case JsonKind::kText:
      return "a string";
    case JsonKind::kNumbers:
      return "an array of numbers";
    case JsonKind::kIndices:
      return "an array of indices";
    case JsonKind::kIndexByName:
      return "an object of indices";
    case JsonKind::kArray:
      return "an array";
    case JsonKind::kObject:
      return "an object";
  }
  return "something else";
}

}  // namespace

Json parse_json(std::string_view text) {
  bound_nesting(text);
  Json root;
  try {
    root = Json::parse(text);
  } catch (const Json::parse_error& error) {
    fail(ErrorCode::kBadFormat, "not a glTF file: the JSON is wrong at byte ", error.byte);
  } catch (const Json::exception&) {
    fail(ErrorCode::kBadFormat, "a number of the JSON is out of range");
  }
  if (!root.is_object()) fail(ErrorCode::kBadFormat, "not a glTF file: the JSON is not an object");
  return root;
}

void reduce(Json& object, std::span<const JsonProperty> wanted) {
  for (const JsonProperty& property : wanted) {
    const auto found = object.find(property.name);
    if (found == object.end()) {
      if (property.required) fail(ErrorCode::kBadFormat, '"', property.name, "\" is missing");
    } else if (!is_of_kind(*found, property.kind)) {
      fail(ErrorCode::kBadFormat, '"', property.name, "\" must be ", describe(property.kind));
    }
  }
  for (auto item = object.begin(); item != object.end();) {
    const bool keep = std::any_of(wanted.begin(), wanted.end(),
                                  [&](const JsonProperty& property) { return property.name == item.key(); });
    item = keep ? std::next(item) : object.erase(item);
  }
}

void require_array(const Json& value, const char* name) {
  if (!value.is_array()) fail(ErrorCode::kBadFormat, '"', name, "\" must be an array");
}

void require_object(const Json& value) {
  if (!value.is_object()) fail(ErrorCode::kBadFormat, "must be an object");
}

Json* find_extension(Json& object, const char* name) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end()) return nullptr;
  if (!extensions->is_object()) fail(ErrorCode::kBadFormat, "\"extensions\" must be an object");
  const auto block = extensions->find(name);
  if (block == extensions->end()) return nullptr;
  if (!block->is_object()) fail(ErrorCode::kBadFormat, "extension ", name, " must be an object");
  return &*block;
}

}  // namespace palpate::gltf
