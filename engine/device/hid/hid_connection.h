#pragma once

#include <string>
#include <utility>

#include "engine/device/hid/hid_entry.h"
#include "engine/device/hid/hid_handle.h"
#include "engine/exchange/flag.h"

namespace palpate {

// A device that this process has. It is opened twice, because hidapi keeps the last error in the handle: of
// two threads that shared one, both would free it when the device is pulled out.
class HidConnection {
 public:
  HidConnection(HidEntry entry, HidHandle in, HidHandle out)
      : entry_(std::move(entry)), in_(std::move(in)), out_(std::move(out)) {}
  ~HidConnection();  // another may then have the device
  HidConnection(const HidConnection&) = delete;
  HidConnection& operator=(const HidConnection&) = delete;

  const HidEntry& entry() const { return entry_; }
  HidHandle& in() { return in_; }    // the reader's
  HidHandle& out() { return out_; }  // the writer's, and before that of whoever connects

  // The writer found that the device has gone.
  void give_up() { broken_.raise(); }
  bool given_up() const { return broken_.raised(); }

 private:
  const HidEntry entry_;
  HidHandle in_;
  HidHandle out_;
  Flag broken_;
};

}  // namespace palpate
