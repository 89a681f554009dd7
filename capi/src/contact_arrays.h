#pragma once

#include <vector>

#include "capi/src/space.h"
#include "engine/scene/contacts.h"

namespace palpate::capi {

// The arrays and numbers that a plp_contacts shows, in the caller's space. Keeps its memory.
class ContactArrays {
 public:
  ContactArrays() { clear(); }

  // If it throws, what was shown before is unchanged.
  void assign(const Contacts& contacts, const Space& space);
  void clear();

  // Everything but struct_size. Valid until the next assign() or clear().
  const plp_contacts& shown() const { return shown_; }

 private:
  std::vector<plp_lmd> lmds_;
  std::vector<plp_lmd> springs_;
  std::vector<plp_overlap> overlaps_;
  plp_contacts shown_;
};

}  // namespace palpate::capi
