#pragma once

#include <memory>
#include <utility>

#include "engine/exchange/slot_table.h"

namespace palpate {

// A SlotTable of objects of type T.
template <class T>
class HandleTable {
 public:
  using Handle = SlotTable::Handle;
  using Outcome = SlotTable::Outcome;

  // Keeps an object alive while it is used; false if the handle was invalid.
  class Pin {
   public:
    Pin(SlotTable& table, Handle handle)
        : table_(table), handle_(handle), object_(static_cast<T*>(table.pin(handle))) {}
    ~Pin() {
      if (object_) table_.unpin(handle_);
    }
    Pin(const Pin&) = delete;
    Pin& operator=(const Pin&) = delete;

    explicit operator bool() const { return object_ != nullptr; }
    T& operator*() const { return *object_; }
    T* operator->() const { return object_; }

   private:
    SlotTable& table_;
    Handle handle_;
    T* object_;
  };

  explicit HandleTable(std::uint8_t kind, const SlotTable::Limits& limits = {})
      : slots_(
            kind, [](void* object) { delete static_cast<T*>(object); }, limits) {}

  // 0 if the table is full.
  Handle create(std::unique_ptr<T> object) {
    const Handle handle = slots_.create(object.get());
    if (handle != 0) static_cast<void>(object.release());
    return handle;
  }

  Pin pin(Handle handle) { return Pin(slots_, handle); }
  Outcome retain(Handle handle) { return slots_.retain(handle); }
  Outcome release(Handle handle) { return slots_.release(handle); }

 private:
  SlotTable slots_;
};

}  // namespace palpate
