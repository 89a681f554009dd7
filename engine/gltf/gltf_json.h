#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "engine/gltf/load_error.h"

namespace palpate::gltf {

using Json = nlohmann::json;

// What a property of a glTF object must be.
enum class JsonKind {
  kFlag,
  kIndex,  // 0 … 2³¹ − 1
  kSize,   // 0 … 2⁶⁴ − 1
  kText,
  kNumbers,      // array of numbers
  kIndices,      // array of indices
  kIndexByName,  // object whose values are indices
  kArray,
  kObject,
};

struct JsonProperty {
  std::string_view name;
  JsonKind kind;
  bool required = false;
};

// The document's root object. Nesting is bounded first, because others that walk the document recurse.
Json parse_json(std::string_view text);

// Checks the properties of `object` that `wanted` lists and erases all others.
void reduce(Json& object, std::span<const JsonProperty> wanted);

// Throws kBadFormat if `value` is not an array.
void require_array(const Json& value, const char* name);

// Throws kBadFormat if `value` is not an object.
void require_object(const Json& value);

// The block of extension `name`, or nullptr.
Json* find_extension(Json& object, const char* name);

// Calls work(i, object) for each object of the array `name`, which may be absent; errors are told to be in
// `noun` i.
template <class Work>
void for_each_object(Json& parent, const char* name, const char* noun, Work&& work) {
  const auto found = parent.find(name);
  if (found == parent.end()) return;
  require_array(*found, name);
  for (std::size_t i = 0; i < found->size(); ++i) {
    within(noun, i, [&] {
      require_object((*found)[i]);
      work(i, (*found)[i]);
    });
  }
}

}  // namespace palpate::gltf
