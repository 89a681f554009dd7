#pragma once

#include "engine/scene/scene.h"
#include "engine/trace/trace_reader.h"

namespace palpate {

// What a trace says of a scene, and back. Nothing is rounded.

TraceVector trace_of(const DVec3& vector);
TracePose trace_of(const Pose& pose);
TraceSettings trace_settings(const Scene& scene);  // those in force
TraceHeader trace_of(const SceneOptions& options, const TraceSpace& space);
TraceBody trace_of(BodyId id, const BodyOptions& options);
TraceContact trace_of(const Contact& contact);

// A tick without its counts of parts.
TraceTick trace_of(const Contacts& contacts);

DVec3 vector_from(const TraceVector& vector);
Pose pose_from(const TracePose& pose);
// All but springs and the list of overlaps, which are not in a trace. Keeps the memory.
void fill_from(const TraceStep& step, Contacts& contacts);

}  // namespace palpate
