#include <cinttypes>
#include <cstdio>
#include <iostream>
#include <string>
#include <unordered_map>
#include <vector>

#include "samples/cli/commands.h"
#include "samples/cli/handles.h"
#include "samples/cli/json_writer.h"

namespace palpate::cli {
namespace {

const char* kind_text(plp_body_kind kind) {
  switch (kind) {
    case PLP_BODY_MOVING:
      return "moving";
    case PLP_BODY_TOOL:
      return "tool";
    default:
      return "static";
  }
}

struct ListedBody {
  plp_body id;
  plp_body_info info;
  plp_pose pose;
};

using NodesById = std::unordered_map<plp_body, std::int32_t>;

OwnedScene load_scene(const SceneArguments& arguments) {
  plp_scene_options options;
  plp_scene_options_init(&options, sizeof options);
  options.cutoff = 1.0;  // nothing is searched
  OwnedScene scene;
  check(plp_scene_create(&options, scene.receive()));
  plp_gltf_scene_options how;
  plp_gltf_scene_options_init(&how, sizeof how);
  how.tool = arguments.tool.empty() ? nullptr : arguments.tool.c_str();
  check(plp_scene_load_gltf(scene.get(), arguments.file.c_str(), &how, nullptr, 0, nullptr));
  return scene;
}

std::vector<ListedBody> bodies_of(plp_scene scene) {
  std::size_t count = 0;
  check(plp_scene_list_bodies(scene, nullptr, 0, &count));
  std::vector<plp_body> ids(count);
  check(plp_scene_list_bodies(scene, ids.data(), ids.size(), &count));
  std::vector<ListedBody> bodies;
  for (const plp_body id : ids) {
    ListedBody body{id, {}, {}};
    plp_body_info_init(&body.info, sizeof body.info);
    check(plp_scene_get_body_info(scene, id, &body.info));
    check(plp_scene_get_pose(scene, id, &body.pose));
    bodies.push_back(body);
  }
  return bodies;
}

// Null where the scene's is meant.
void write_own(JsonWriter& json, const char* name, double number) {
  json.key(name);
  if (number == 0.0) {
    json.null();
  } else {
    json.value(number < 0.0 ? 0.0 : number);
  }
}

void write_body(JsonWriter& json, const ListedBody& body, const NodesById& nodes) {
  json.open_object()
      .field("name", body.info.name)
      .field("node", body.info.node)
      .field("kind", kind_text(body.info.kind))
      .field("intangible", body.info.intangible != 0)
      .field("triangles", body.info.triangles)
      .field("position", std::span<const double>(body.pose.position))
      .field("orientation", std::span<const double>(body.pose.orientation));
  write_own(json, "stiffness", body.info.stiffness);
  write_own(json, "damping", body.info.damping);
  write_own(json, "friction", body.info.friction);
  json.key("above_node");
  const auto above = nodes.find(body.info.above);
  if (above == nodes.end()) {
    json.null().close();
  } else {
    json.value(above->second).close();
  }
}

void print_json(const std::vector<ListedBody>& bodies) {
  JsonWriter json(std::cout);
  json.open_object().key("bodies").open_array();
  NodesById nodes;
  for (const ListedBody& body : bodies) nodes.emplace(body.id, body.info.node);
  for (const ListedBody& body : bodies) write_body(json, body, nodes);
  json.close().close();
  std::cout << '\n';
}

// "-" where the scene's is meant.
std::string own_text(double number) {
  if (number == 0.0) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%g", number < 0.0 ? 0.0 : number);
  return text;
}

// A name is the file's: nothing in it may steer the terminal.
std::string printable(std::string name) {
  for (char& byte : name) {
    if (static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F) byte = '?';
  }
  return name;
}

void print_table(const std::vector<ListedBody>& bodies) {
  std::printf("%-24s %-10s %10s  %-28s %-32s %9s %9s %9s\n", "name", "kind", "triangles", "position, m",
              "orientation, x y z w", "stiffness", "damping", "friction");
  for (const ListedBody& body : bodies) {
    const double* p = body.pose.position;
    const double* q = body.pose.orientation;
    char position[96];
    char orientation[128];
    std::snprintf(position, sizeof position, "%.4g %.4g %.4g", p[0], p[1], p[2]);
    std::snprintf(orientation, sizeof orientation, "%.4g %.4g %.4g %.4g", q[0], q[1], q[2], q[3]);
    std::printf("%-24s %-10s %10" PRIu64 "  %-28s %-32s %9s %9s %9s\n", printable(body.info.name).c_str(),
                body.info.intangible ? "intangible" : kind_text(body.info.kind), body.info.triangles,
                position, orientation, own_text(body.info.stiffness).c_str(),
                own_text(body.info.damping).c_str(), own_text(body.info.friction).c_str());
  }
}

}  // namespace

void run_scene(const SceneArguments& arguments) {
  const OwnedScene scene = load_scene(arguments);
  const std::vector<ListedBody> bodies = bodies_of(scene.get());
  if (arguments.json) {
    print_json(bodies);
  } else {
    print_table(bodies);
  }
}

}  // namespace palpate::cli
