#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace palpate::test {

using Report = std::vector<std::uint8_t>;

// What the sysfs of a kernel tells of a device.
struct MockIdentity {
  std::uint16_t vendor = 0x1209;
  std::uint16_t product = 0x0001;
  std::string serial;
  std::string name = "Mock";
  Report descriptor;
};

// The kernel's side of a hidraw node: those who have opened it, each with a queue of its own. From any
// thread.
class MockNode {
 public:
  explicit MockNode(MockIdentity identity) : identity_(std::move(identity)) {}
  virtual ~MockNode();

  const MockIdentity& identity() const { return identity_; }

  // The device's. A report goes to all who have the node open; whose queue is full misses it.
  void send(std::span<const std::uint8_t> report);
  std::vector<Report> received();  // what was written since the last call
  std::size_t discard();           // the same without keeping it: how many there were. Allocates nothing
  bool is_open();

  // Faults.
  void permit(bool permitted);
  void hold_readers(bool held);    // their threads stand still before the next read
  void stop_taking(bool stopped);  // what they write fills up their queues, and then they wait

  // The host's.
  int open();
  int access();
  int ioctl(int descriptor, unsigned long request, void* argument);
  void wait_for_readers_release();
  void closing(int descriptor);
  void unplug();  // all who have it open are told that it has gone

  // By feature report; false: the device refuses.
  virtual bool get_feature(std::uint8_t, Report&) { return false; }
  virtual bool set_feature(std::span<const std::uint8_t>) { return false; }

 private:
  const MockIdentity identity_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable released_;
  std::map<int, int> ours_by_theirs_;  // both ends of each socket
  bool permitted_ = true;
  bool held_ = false;
  bool taking_ = true;
  bool plugged_ = true;
};

}  // namespace palpate::test
