#pragma once

#include <umockdev.h>

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "tests/device/hid/hidraw_shim.h"
#include "tests/device/hid/mock_node.h"

namespace palpate::test {

// A USB bus of this process' own: umockdev's sysfs, in which devices are found, and hidraw nodes, through
// which they speak.
class MockBus final : public HidrawNodes {
 public:
  MockBus();
  ~MockBus() override;

  // The number of its node: the lowest that was never used.
  int plug(std::shared_ptr<MockNode> node);
  void unplug(int number);

  int open(const std::string& path) override;
  int access(const std::string& path) override;
  int ioctl(int descriptor, unsigned long request, void* argument) override;
  void before_poll(int descriptor) override;
  void closing(int descriptor) override;

 private:
  std::shared_ptr<MockNode> at(const std::string& path);
  std::shared_ptr<MockNode> of(int descriptor);

  UMockdevTestbed* const testbed_;
  int next_ = 0;
  std::mutex mutex_;  // guards what follows
  std::map<int, std::shared_ptr<MockNode>> nodes_;
  std::map<int, std::shared_ptr<MockNode>> opened_;  // by descriptor
};

}  // namespace palpate::test
