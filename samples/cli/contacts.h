#pragma once

#include <cstddef>

#include "palpate/palpate.h"

namespace palpate::cli {

// The i-th LMD, stepping as far as the loaded library says, which may be newer than its header here.
inline const plp_lmd& lmd_at(const plp_contacts& contacts, std::size_t i) {
  const auto* bytes = reinterpret_cast<const std::byte*>(contacts.lmds);
  return *reinterpret_cast<const plp_lmd*>(bytes + i * contacts.lmd_stride);
}

}  // namespace palpate::cli
