#pragma once

#include <array>
#include <cstdint>

#include "engine/trace/bytes.h"

namespace palpate {

inline constexpr std::uint32_t kTraceVersion = 1;

// What every trace begins with, before its header: see FORMAT.md.
struct TracePrologue {
  std::uint64_t magic = 0x4543415254504c50u;  // "PLPTRACE" as its bytes stand in the file
  std::uint32_t version = kTraceVersion;
  std::uint32_t header_size = stored_size<TraceHeader>();
  std::uint32_t tick_size = stored_size<TraceTick>();
  std::uint32_t settings_size = stored_size<TraceSettings>();
  std::uint32_t removal_size = stored_size<TraceRemoval>();
  std::uint32_t move_size = stored_size<TraceMove>();
  std::uint32_t contact_size = stored_size<TraceContact>();
  std::uint32_t body_size = stored_size<TraceBody>();

  friend bool operator==(const TracePrologue&, const TracePrologue&) = default;
};

template <class Visit>
void each_field(TracePrologue& prologue, Visit&& visit) {
  visit(prologue.magic);
  visit(prologue.version);
  visit(prologue.header_size);
  visit(prologue.tick_size);
  visit(prologue.settings_size);
  visit(prologue.removal_size);
  visit(prologue.move_size);
  visit(prologue.contact_size);
  visit(prologue.body_size);
}

// What stands before each block that follows the header.
enum class TraceBlock : std::uint32_t {
  kBody = 0x59444f42,  // "BODY"
  kTick = 0x4b434954,  // "TICK"
  kEnd = 0x45444e45,   // "ENDE"
};

struct TraceBlockHead {
  std::uint32_t kind = 0;  // of TraceBlock
  std::uint32_t size = 0;  // bytes that follow
};

template <class Visit>
void each_field(TraceBlockHead& head, Visit&& visit) {
  visit(head.kind);
  visit(head.size);
}

inline constexpr std::uint32_t kLongestTraceName = 255;  // bytes

// Bytes of a tick and its parts.
inline std::uint64_t stored_size(const TraceTick& tick) {
  return std::uint64_t{stored_size<TraceTick>()} +
         std::uint64_t{tick.settings_count} * stored_size<TraceSettings>() +
         std::uint64_t{tick.removed_count} * stored_size<TraceRemoval>() +
         std::uint64_t{tick.pose_count} * stored_size<TraceMove>() +
         std::uint64_t{tick.contact_count} * stored_size<TraceContact>();
}

}  // namespace palpate
