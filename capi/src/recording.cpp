#include <algorithm>

#include "capi/src/handles.h"
#include "capi/src/structs.h"

namespace palpate::capi {
namespace {

TraceSpace trace_space(const Space& space) {
  const plp_space given = space.given();
  TraceSpace traced;
  std::copy_n(given.axes, 3, traced.axes.begin());
  traced.metres_per_unit = given.metres_per_unit;
  return traced;
}

plp_recording recording_of(const Recording& recording) {
  return {0, recording.running, recording.counts.ticks, recording.counts.lost, recording.counts.bytes};
}

}  // namespace
}  // namespace palpate::capi

using namespace palpate;
using namespace palpate::capi;

void plp_recording_init(plp_recording* recording, size_t size) {
  fill_struct(plp_recording{}, recording, size);
}

plp_result plp_scene_record(plp_scene scene, const char* path) {
  return guarded([&] {
    const auto object = scene_table().pin(bits_of(scene));
    require_handle(object, "scene");
    require(path && *path, "path is null or empty");
    value_or_refuse(object->scene.record(path, trace_space(object->space)));
  });
}

plp_result plp_scene_stop_recording(plp_scene scene, plp_recording* recording) {
  return guarded([&] {
    const auto object = scene_table().pin(bits_of(scene));
    require_handle(object, "scene");
    if (recording) checked_size(recording, "recording");
    Recording outcome;
    Status stopped = object->scene.stop_recording(outcome);
    const bool ended = stopped.ok() || stopped.error().code != ErrorCode::kWrongState;
    if (recording && ended) write_struct(recording_of(outcome), recording, "recording");
    value_or_refuse(std::move(stopped));
  });
}

plp_result plp_scene_get_recording(plp_scene scene, plp_recording* recording) {
  return guarded([&] {
    const auto object = scene_table().pin(bits_of(scene));
    require_handle(object, "scene");
    write_struct(recording_of(object->scene.recording()), recording, "recording");
  });
}
