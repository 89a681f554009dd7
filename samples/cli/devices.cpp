#include <algorithm>
#include <cstdio>
#include <iostream>
#include <vector>

#include "samples/cli/commands.h"
#include "samples/cli/handles.h"
#include "samples/cli/json_writer.h"

namespace palpate::cli {
namespace {

std::vector<plp_device_info> listed_devices() {
  std::size_t count = 0;
  check(plp_device_list(nullptr, 0, &count));
  std::vector<plp_device_info> infos(count);
  for (plp_device_info& info : infos) plp_device_info_init(&info, sizeof info);
  const std::size_t room = infos.size();
  check(plp_device_list(infos.data(), room, &count));
  infos.resize(std::min(room, count));
  return infos;
}

void print_json(const std::vector<plp_device_info>& infos) {
  JsonWriter json(std::cout);
  json.open_array();
  for (const plp_device_info& info : infos) {
    json.open_object()
        .field("uri", info.uri)
        .field("name", info.name)
        .field("serial", info.serial)
        .field("buttons", info.buttons)
        .field("sensed", info.sensed)
        .field("actuated", info.actuated)
        .field("max_force", info.max_force)
        .field("max_torque", info.max_torque)
        .field("max_stiffness", info.max_stiffness)
        .field("update_rate", info.update_rate)
        .field("workspace_min", std::span(info.workspace_min))
        .field("workspace_max", std::span(info.workspace_max))
        .field("condition", info.condition)
        .field("status", info.status)
        .close();
  }
  json.close();
  std::cout << '\n';
}

void print_table(const std::vector<plp_device_info>& infos) {
  for (const plp_device_info& info : infos) {
    if (info.condition != PLP_CONDITION_READY || info.max_force == 0.0) {
      std::printf("%-20s %s: %s\n", info.uri, info.name, info.status);
      continue;
    }
    std::printf("%-20s %s: %g N, %g N·m, up to %g N/m\n", info.uri, info.name, info.max_force,
                info.max_torque, info.max_stiffness);
  }
}

}  // namespace

void run_devices(const DevicesArguments& arguments) {
  const std::vector<plp_device_info> infos = listed_devices();
  if (arguments.json) {
    print_json(infos);
  } else {
    print_table(infos);
  }
}

}  // namespace palpate::cli
