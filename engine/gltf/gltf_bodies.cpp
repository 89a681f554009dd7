#include "engine/gltf/gltf_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "engine/gltf/load_error.h"
#include "engine/gltf/rigid_part.h"

namespace palpate {
namespace {

using gltf::fail;
using gltf::quoted;
using gltf::sentence;

constexpr std::int32_t kNone = -1;

// Numbers that differ less than single precision, in which exporters write, tells apart come to the same.
// Relative to the matrix's largest entry.
constexpr int kSharedBits = 19;

constexpr double kTooSmall = 1e-290;  // to have a step: all that is smaller is nothing

double rounded(double number, double step) {
  return step * std::nearbyint(number / step);
}

class BodyGatherer {
 public:
  BodyGatherer(const GltfScene& scene, const MeshOptions& options, double scale)
      : scene_(scene), options_(options), scene_from_file_(DMat3(scale)) {}

  GltfBodies gather(const std::string& tool) &&;

 private:
  // A mesh and, coarsely, where it is in the body.
  using ShapeKey = std::array<double, 13>;

  void sort_instances();
  void find_tool(const std::string& name);
  void take_below_tool();
  void filter_by_tool();
  void add_body(std::int32_t node);
  GltfBody body_of(std::int32_t node) const;
  bool touches_tool(const GltfNode& node) const;
  std::optional<std::uint32_t> shape_of(const std::vector<GltfInstance>& instances, const std::string& place);
  std::optional<std::uint32_t> build_shape(const std::vector<GltfInstance>& instances,
                                           const std::string& place);
  static ShapeKey key_of(const GltfInstance& instance);
  const GltfNode& node(std::int32_t place) const { return scene_.nodes[static_cast<std::size_t>(place)]; }

  const GltfScene& scene_;
  const MeshOptions& options_;
  const DMat4 scene_from_file_;  // a scale
  GltfBodies found_;
  std::vector<std::vector<GltfInstance>> instances_;  // by node
  std::vector<std::int32_t> bodies_;                  // by node: that of the node or of the nearest above
  std::int32_t tool_ = kNone;                         // node
  std::vector<bool> never_with_tool_;                 // by filter
  std::map<ShapeKey, std::optional<std::uint32_t>> shapes_;
};

GltfBodies BodyGatherer::gather(const std::string& tool) && {
  sort_instances();
  if (!tool.empty()) {
    find_tool(tool);
    take_below_tool();
    filter_by_tool();
  }
  bodies_.assign(scene_.nodes.size(), kNone);
  for (std::size_t i = 0; i < scene_.nodes.size(); ++i) add_body(static_cast<std::int32_t>(i));
  if (found_.bodies.empty()) fail(ErrorCode::kNoTriangles, "the scene has no triangle of positive area");
  return std::move(found_);
}

void BodyGatherer::sort_instances() {
  std::unordered_map<std::uint32_t, std::size_t> places;
  for (std::size_t i = 0; i < scene_.nodes.size(); ++i) places.emplace(scene_.nodes[i].index, i);
  instances_.resize(scene_.nodes.size());
  for (const GltfInstance& instance : scene_.instances) {
    std::vector<GltfInstance>& here = instances_[places.at(instance.node)];
    here.push_back(instance);
    here.back().scene_from_mesh = scene_from_file_ * instance.scene_from_mesh;
  }
}

void BodyGatherer::find_tool(const std::string& name) {
  for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
    if (scene_.nodes[i].name != name) continue;
    if (tool_ != kNone)
      fail(ErrorCode::kInvalidArgument, "nodes ", node(tool_).index, " and ", scene_.nodes[i].index,
           " are both called ", quoted(name), ", so that neither is the tool");
    tool_ = static_cast<std::int32_t>(i);
  }
  for (std::size_t i = 0; i < scene_.nodes.size() && tool_ == kNone; ++i) {
    if ("/nodes/" + std::to_string(scene_.nodes[i].index) == name) tool_ = static_cast<std::int32_t>(i);
  }
  if (tool_ == kNone)
    fail(ErrorCode::kInvalidArgument, "no node of the scene is called ", quoted(name), ", the tool");
}

// The tool has all instances of the nodes below it, which have no bodies of their own.
void BodyGatherer::take_below_tool() {
  std::vector<bool> below(scene_.nodes.size(), false);
  const auto tool = static_cast<std::size_t>(tool_);
  below[tool] = true;
  for (std::size_t i = tool + 1; i < scene_.nodes.size(); ++i) {
    const std::int32_t parent = scene_.nodes[i].parent;
    below[i] = parent != kNone && below[static_cast<std::size_t>(parent)];
    if (!below[i]) continue;
    instances_[tool].insert(instances_[tool].end(), instances_[i].begin(), instances_[i].end());
    instances_[i].clear();
  }
  if (instances_[tool].empty())
    fail(ErrorCode::kNoTriangles, "node ", node(tool_).index, ", the tool, has no triangles");
}

void BodyGatherer::filter_by_tool() {
  const std::int32_t filter = node(tool_).filter;
  if (filter == kNone) return;
  const CollisionFilter& of_tool = scene_.filters[static_cast<std::size_t>(filter)];
  for (const CollisionFilter& other : scene_.filters) never_with_tool_.push_back(never_touch(of_tool, other));
}

bool BodyGatherer::touches_tool(const GltfNode& node) const {
  if (!node.solid) return false;
  return never_with_tool_.empty() || node.filter == kNone ||
         !never_with_tool_[static_cast<std::size_t>(node.filter)];
}

void BodyGatherer::add_body(std::int32_t place) {
  const auto at = static_cast<std::size_t>(place);
  const std::int32_t parent = node(place).parent;
  bodies_[at] = parent == kNone ? kNone : bodies_[static_cast<std::size_t>(parent)];
  std::vector<GltfInstance>& instances = instances_[at];
  if (instances.empty()) return;
  GltfBody body = body_of(place);
  for (GltfInstance& instance : instances)
    instance.scene_from_mesh = relative_to(body.scene_from_body, instance.scene_from_mesh);
  const std::string name = sentence("node ", body.node);
  const std::optional<std::uint32_t> shape = shape_of(instances, name);
  if (!shape && body.tool)
    fail(ErrorCode::kNoTriangles, name, ", the tool, has no triangle of positive area");
  if (!shape) {
    found_.notes.push_back(name + " has no triangle of positive area and is no body.");
    return;
  }
  body.shape = *shape;
  bodies_[at] = static_cast<std::int32_t>(found_.bodies.size());
  found_.bodies.push_back(std::move(body));
}

GltfBody BodyGatherer::body_of(std::int32_t place) const {
  const GltfNode& source = node(place);
  GltfBody body;
  body.name = source.name;
  body.node = source.index;
  const DMat4 scene_from_node = scene_from_file_ * source.scene_from_node;
  body.scene_from_body = rigid_part(scene_from_node);
  body.body_from_node = relative_to(body.scene_from_body, scene_from_node);
  body.above = bodies_[static_cast<std::size_t>(place)];
  body.above_from_parent = scene_from_file_;
  if (source.parent != kNone) body.above_from_parent = scene_from_file_ * node(source.parent).scene_from_node;
  if (body.above != kNone) {
    const GltfBody& above = found_.bodies[static_cast<std::size_t>(body.above)];
    body.above_from_parent = relative_to(above.scene_from_body, body.above_from_parent);
  }
  body.material = source.material;
  body.tool = place == tool_;
  body.moves = source.moves;
  body.touches_tool = body.tool || touches_tool(source);
  return body;
}

BodyGatherer::ShapeKey BodyGatherer::key_of(const GltfInstance& instance) {
  ShapeKey key{static_cast<double>(instance.mesh)};
  double largest = 0.0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row)
      largest = std::max(largest, std::abs(instance.scene_from_mesh[column][row]));
  }
  const double step = largest > kTooSmall ? std::ldexp(1.0, std::ilogb(largest) - kSharedBits) : kTooSmall;
  std::size_t i = 1;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double number = instance.scene_from_mesh[column][row];
      key[i++] = column < 3 ? rounded(number, step) : number;
    }
  }
  return key;
}

// Nothing if it has no triangle of positive area.
std::optional<std::uint32_t> BodyGatherer::shape_of(const std::vector<GltfInstance>& instances,
                                                    const std::string& place) {
  const ShapeKey key = key_of(instances.front());
  const bool orderly =
      std::all_of(key.begin(), key.end(), [](double number) { return std::isfinite(number); });
  if (instances.size() > 1 || !orderly) return build_shape(instances, place);
  const auto [known, is_new] = shapes_.try_emplace(key);
  if (is_new) known->second = build_shape(instances, place);
  return known->second;
}

std::optional<std::uint32_t> BodyGatherer::build_shape(const std::vector<GltfInstance>& instances,
                                                       const std::string& place) {
  Result<Mesh> mesh = build_mesh(bake(scene_.meshes, instances), options_);
  if (!mesh && mesh.error().code == ErrorCode::kNoTriangles) return std::nullopt;
  if (!mesh) fail(mesh.error().code, place, ": ", mesh.error().message);
  found_.shapes.push_back(std::move(mesh.value()));
  return static_cast<std::uint32_t>(found_.shapes.size() - 1);
}

}  // namespace

Result<GltfBodies> gather_bodies(const GltfScene& scene, const std::string& tool, const MeshOptions& options,
                                 double scale) {
  try {
    return BodyGatherer(scene, options, scale).gather(tool);
  } catch (const gltf::LoadError& error) {
    return Error{error.code(), error.what()};
  }
}

}  // namespace palpate
