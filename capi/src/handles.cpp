#include "capi/src/handles.h"

namespace palpate::capi {
namespace {

// The kind byte of each table's handles.
constexpr std::uint8_t kModelKind = 1;
constexpr std::uint8_t kQueryKind = 2;
constexpr std::uint8_t kSceneKind = 3;
constexpr std::uint8_t kDeviceKind = 5;
constexpr std::uint8_t kTraceKind = 7;

}  // namespace

HandleTable<ModelObject>& model_table() {
  static auto* const table = new HandleTable<ModelObject>(kModelKind);
  return *table;
}

HandleTable<QueryObject>& query_table() {
  static auto* const table = new HandleTable<QueryObject>(kQueryKind);
  return *table;
}

HandleTable<SceneObject>& scene_table() {
  static auto* const table = new HandleTable<SceneObject>(kSceneKind);
  return *table;
}

HandleTable<DeviceObject>& device_table() {
  static auto* const table = new HandleTable<DeviceObject>(kDeviceKind);
  return *table;
}

HandleTable<TraceObject>& trace_table() {
  static auto* const table = new HandleTable<TraceObject>(kTraceKind);
  return *table;
}

}  // namespace palpate::capi
