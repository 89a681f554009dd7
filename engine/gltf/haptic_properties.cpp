// Based on: Khronos, KHR_physics_rigid_bodies (draft), for motions, friction and collision filters; ISO/IEC
// 23090-14, MPEG_material_haptic, whose properties are textures: images are not read, so that the numbers
// that come beside them in `extras` are what counts.
#include "engine/gltf/haptic_properties.h"

#include <algorithm>
#include <utility>

namespace palpate::gltf {
namespace {

using enum JsonKind;

constexpr const char* kPhysics = "KHR_physics_rigid_bodies";
constexpr const char* kMpegNames[] = {"MPEG_material_haptic", "MPEG_haptic_material"};  // both are in use
constexpr double kDefaultFriction = 0.6;  // of a physics material that says nothing
constexpr double kLargestNumber = 1e15;   // that the library takes

constexpr JsonProperty kPhysicsRoot[] = {{"physicsMaterials", kArray}, {"collisionFilters", kArray}};
constexpr JsonProperty kPhysicsNode[] = {{"motion", kObject}, {"collider", kObject}, {"trigger", kObject}};
constexpr JsonProperty kCollider[] = {{"physicsMaterial", kIndex}, {"collisionFilter", kIndex}};
constexpr JsonProperty kFilter[] = {
    {"collisionSystems", kArray}, {"collideWithSystems", kArray}, {"notCollideWithSystems", kArray}};

bool is_sensible(double number) {
  return number >= 0.0 && number <= kLargestNumber;  // false for NaN, too
}

// Reads one key of an object that may mean anything.
std::optional<double> number_of(const Json& object, const char* key, const std::string& place,
                                std::vector<std::string>& notes) {
  const auto found = object.find(key);
  if (found == object.end()) return std::nullopt;
  if (found->is_number() && is_sensible(found->get<double>())) return found->get<double>();
  notes.push_back(sentence(place, ": \"", key, "\" is no number from 0 to 1e15 and was left out."));
  return std::nullopt;
}

HapticMaterial material_of(const Json& object, const std::string& place, std::vector<std::string>& notes) {
  return {number_of(object, "stiffness", place, notes), number_of(object, "damping", place, notes),
          number_of(object, "friction", place, notes)};
}

HapticMaterial material_of_extras(const Json& object, const std::string& place,
                                  std::vector<std::string>& notes) {
  const auto extras = object.find("extras");
  if (extras == object.end() || !extras->is_object()) return {};
  return material_of(*extras, place + " extras", notes);
}

std::vector<std::string> systems_of(const Json& filter, const char* name) {
  std::vector<std::string> systems;
  const auto found = filter.find(name);
  if (found == filter.end()) return systems;
  for (const Json& system : *found) {
    if (!system.is_string()) fail(ErrorCode::kBadFormat, '"', name, "\" must hold strings");
    systems.push_back(system.get<std::string>());
  }
  std::sort(systems.begin(), systems.end());
  return systems;
}

double friction_of(const Json& material) {
  const auto found = material.find("dynamicFriction");
  if (found == material.end()) return kDefaultFriction;
  if (!found->is_number() || !is_sensible(found->get<double>()))
    fail(ErrorCode::kBadFormat, "\"dynamicFriction\" must be a number from 0 to 1e15");
  return found->get<double>();
}

void read_physics(Json& root, HapticProperties& properties) {
  Json* physics = find_extension(root, kPhysics);
  if (physics == nullptr) return;
  reduce(*physics, kPhysicsRoot);
  for_each_object(*physics, "physicsMaterials", "physics material", [&](std::size_t, Json& material) {
    properties.frictions.push_back({std::nullopt, std::nullopt, friction_of(material)});
  });
  for_each_object(*physics, "collisionFilters", "collision filter", [&](std::size_t, Json& filter) {
    reduce(filter, kFilter);
    properties.filters.push_back({systems_of(filter, "collisionSystems"),
                                  systems_of(filter, "collideWithSystems"),
                                  systems_of(filter, "notCollideWithSystems")});
  });
}

int reference(const Json& object, const char* name, std::size_t count) {
  const int index = object.value(name, -1);
  if (index >= 0 && static_cast<std::size_t>(index) >= count)
    fail(ErrorCode::kBadFormat, name, ' ', index, " does not exist");
  return index;
}

void read_physics_of(Json& node, const HapticProperties& properties, NodeHaptics& haptics) {
  Json* physics = find_extension(node, kPhysics);
  if (physics == nullptr) return;
  reduce(*physics, kPhysicsNode);
  haptics.moves = physics->contains("motion");
  const auto collider = physics->find("collider");
  haptics.solid = collider != physics->end() || !physics->contains("trigger");
  if (collider == physics->end()) return;
  reduce(*collider, kCollider);
  haptics.physics_material = reference(*collider, "physicsMaterial", properties.frictions.size());
  haptics.collision_filter = reference(*collider, "collisionFilter", properties.filters.size());
}

void read_nodes(Json& root, HapticProperties& properties) {
  for_each_object(root, "nodes", "node", [&](std::size_t i, Json& node) {
    NodeHaptics haptics;
    haptics.material = material_of_extras(node, sentence("node ", i), properties.notes);
    read_physics_of(node, properties, haptics);
    properties.nodes.push_back(haptics);
  });
}

// Null if the object has neither name of the extension.
Json* find_mpeg(Json& object) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object()) return nullptr;
  for (const char* name : kMpegNames) {
    const auto found = extensions->find(name);
    if (found != extensions->end()) return &*found;
  }
  return nullptr;
}

HapticMaterial mpeg_material(const Json& material, std::size_t index, std::vector<std::string>& notes) {
  const std::string place = sentence("haptic material ", index);
  const HapticMaterial found = material_of_extras(material, place, notes);
  const auto misses = [&](const char* key, const std::optional<double>& number) {
    if (material.contains(key) && !number)
      notes.push_back(sentence(place, ": \"", key,
                               "\" is in a texture, which is not read; a number in "
                               "\"extras\" would be."));
  };
  misses("stiffness", found.stiffness);
  misses("friction", found.friction);
  return found;
}

std::vector<HapticMaterial> read_mpeg(Json& root, std::vector<std::string>& notes) {
  std::vector<HapticMaterial> materials;
  Json* mpeg = find_mpeg(root);
  if (mpeg == nullptr) return materials;
  require_object(*mpeg);
  for_each_object(*mpeg, "materials", "haptic material", [&](std::size_t i, const Json& material) {
    materials.push_back(mpeg_material(material, i, notes));
  });
  return materials;
}

// The index stands alone in early files, later in an object.
HapticMaterial mpeg_material_of(Json& mesh, const std::vector<HapticMaterial>& materials) {
  constexpr JsonProperty kReference[] = {{"hapticMaterialIndex", kIndex, true}};
  Json* mpeg = find_mpeg(mesh);
  if (mpeg == nullptr) return {};
  Json holder = mpeg->is_object() ? *mpeg : Json{{"hapticMaterialIndex", *mpeg}};
  reduce(holder, kReference);
  const int index = reference(holder, "hapticMaterialIndex", materials.size());
  return materials[static_cast<std::size_t>(index)];
}

void read_meshes(Json& root, HapticProperties& properties) {
  const std::vector<HapticMaterial> materials = read_mpeg(root, properties.notes);
  for_each_object(root, "meshes", "mesh", [&](std::size_t i, Json& mesh) {
    properties.meshes.push_back(first_of(material_of_extras(mesh, sentence("mesh ", i), properties.notes),
                                         mpeg_material_of(mesh, materials)));
  });
}

}  // namespace

HapticProperties read_haptics(Json& root) {
  HapticProperties properties;
  read_physics(root, properties);
  read_nodes(root, properties);
  read_meshes(root, properties);
  return properties;
}

}  // namespace palpate::gltf
