#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "capi/src/contact_arrays.h"
#include "capi/src/errors.h"
#include "capi/src/space.h"
#include "engine/device/guarded_device.h"
#include "engine/exchange/handle_table.h"
#include "engine/gltf/load_tally.h"
#include "engine/runtime/scene_threads.h"
#include "engine/runtime/worker_pool.h"
#include "engine/scene/query.h"
#include "engine/trace/trace_reader.h"

namespace palpate::capi {

struct ModelObject {
  std::shared_ptr<const Model> model;
  LoadTally tally;  // zeros unless it came from glTF
  double load_us;
  std::string name;  // of its file, without folders
};

struct QueryObject {
  Query query;
  ContactArrays arrays;
};

struct SceneObject {
  SceneObject(const Space& its_space, const SceneOptions& options)
      : space(its_space), scene(options), threads(scene) {}

  Space space;
  std::unique_ptr<WorkerPool> workers;  // null: the caller's thread alone; outlives the scene
  LiveScene scene;
  ContactArrays arrays;
  SceneThreads threads;  // end first
};

struct DeviceObject {
  std::shared_ptr<GuardedDevice> device;  // shared with the scene whose tool it moves
};

struct TraceObject {
  TraceObject(std::unique_ptr<const TraceReader> its_reader, const plp_space& its_space)
      : reader(std::move(its_reader)), space(its_space, "the trace's space") {}

  std::unique_ptr<const TraceReader> reader;
  Space space;

  // Of the step that was read last.
  bool has_step = false;
  TraceStep step;
  std::vector<plp_trace_move> moves;
  Contacts contacts;
  ContactArrays arrays;
};

// The tables live until the process ends: a thread that still calls at exit must not meet a destroyed one.
HandleTable<ModelObject>& model_table();
HandleTable<QueryObject>& query_table();
HandleTable<SceneObject>& scene_table();
HandleTable<DeviceObject>& device_table();
HandleTable<TraceObject>& trace_table();

// A C handle is a pointer type that holds the 64 bits of a table's handle.
template <class T>
std::uint64_t bits_of(T* handle) {
  static_assert(sizeof(std::uintptr_t) == sizeof(std::uint64_t), "handles need 64 bits");
  return reinterpret_cast<std::uintptr_t>(handle);
}

// Refuses what a table did not know. `name` is the argument's.
template <class Pin>
void require_handle(const Pin& pin, const char* name) {
  if (!pin) refuse(ErrorCode::kInvalidHandle, std::string(name) + " is null, released or of another kind");
}

inline HandleTable<SceneObject>::Pin pin_scene(plp_scene scene) {
  return scene_table().pin(bits_of(scene));
}

inline void require_body(bool found) {
  if (!found) refuse(ErrorCode::kInvalidHandle, "body is none of this scene");
}

// Puts `object` into `table`; refuses with PLP_ERROR_LIMIT if that is full.
template <class Handle, class T>
Handle new_handle(HandleTable<T>& table, std::unique_ptr<T> object) {
  const std::uint64_t bits = table.create(std::move(object));
  if (bits == 0) refuse(ErrorCode::kLimit, "there are too many objects of this kind");
  // A number in the type of a pointer, which nobody follows. NOLINTNEXTLINE(performance-no-int-to-ptr)
  return reinterpret_cast<Handle>(static_cast<std::uintptr_t>(bits));
}

// What every release function does: null is allowed, the last reference destroys.
template <class T, class Handle>
void release_handle(HandleTable<T>& table, Handle handle, const char* name) {
  if (!handle) return;
  const bool released = table.release(bits_of(handle)) == SlotTable::Outcome::kDone;
  require_handle(released, name);
}

}  // namespace palpate::capi
