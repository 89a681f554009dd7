#pragma once

#include "engine/trace/records.h"

namespace palpate {

// Whether what a file says can be: null, or what is wrong with it. A file may hold anything.
const char* fault_of(const TraceHeader& header);
const char* fault_of(const TraceSettings& settings);
const char* fault_of(const TraceBody& body);
const char* fault_of(const TraceTick& tick);
const char* fault_of(const TraceMove& move);
const char* fault_of(const TraceContact& contact);

}  // namespace palpate
