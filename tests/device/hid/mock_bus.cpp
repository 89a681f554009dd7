#include "tests/device/hid/mock_bus.h"

#include <errno.h>

#include <cstdio>
#include <stdexcept>

namespace palpate::test {
namespace {

std::string hex(const Report& bytes) {
  std::string text;
  char two[3];
  for (const std::uint8_t byte : bytes) {
    std::snprintf(two, sizeof two, "%02X", byte);
    text += two;
  }
  return text;
}

std::string ids(const MockIdentity& identity, const char* format) {
  char text[96];
  std::snprintf(text, sizeof text, format, unsigned{identity.vendor}, unsigned{identity.product});
  return text;
}

std::string usb_path(int number) {
  return "/devices/pci0000:00/usb1/1-" + std::to_string(number + 1);
}

std::string hid_name(const MockIdentity& identity, int number) {
  return "0003:" + ids(identity, "%04X:%04X") + "." + std::to_string(1000 + number);
}

std::string hid_path(const MockIdentity& identity, int number) {
  return usb_path(number) + "/1-" + std::to_string(number + 1) + ":1.0/" + hid_name(identity, number);
}

std::string node_path(const MockIdentity& identity, int number) {
  return hid_path(identity, number) + "/hidraw/hidraw" + std::to_string(number);
}

// What umockdev-record would write of such a device.
std::string usb_record(const MockIdentity& identity, int number) {
  const std::string path = usb_path(number);
  const std::string interface = path + "/1-" + std::to_string(number + 1) + ":1.0";
  const std::string id_lines = ids(identity, "A: idVendor=%04x\\n\nA: idProduct=%04x\\n\n");
  return "P: " + path + "\nE: DEVTYPE=usb_device\nE: SUBSYSTEM=usb\n" + id_lines +
         "A: manufacturer=Mock\\n\nA: product=" + identity.name + "\\n\nA: serial=" + identity.serial +
         "\\n\nA: bcdDevice=0100\\n\n\nP: " + interface +
         "\nE: DEVTYPE=usb_interface\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=00\\n\n\n";
}

std::string hid_record(const MockIdentity& identity, int number) {
  return "P: " + hid_path(identity, number) +
         "\nE: SUBSYSTEM=hid\nE: DRIVER=hid-generic\nE: HID_ID=" + ids(identity, "0003:0000%04X:0000%04X") +
         "\nE: HID_NAME=" + identity.name + "\nE: HID_PHYS=usb-" + std::to_string(number) +
         "/input0\nE: HID_UNIQ=" + identity.serial + "\nH: report_descriptor=" + hex(identity.descriptor) +
         "\n\n";
}

std::string node_record(const MockIdentity& identity, int number) {
  const std::string name = "hidraw" + std::to_string(number);
  const std::string device = "240:" + std::to_string(number);
  return "P: " + node_path(identity, number) + "\nN: " + name + "\nE: DEVNAME=/dev/" + name +
         "\nE: MAJOR=240\nE: MINOR=" + std::to_string(number) + "\nE: SUBSYSTEM=hidraw\nA: dev=" + device +
         "\\n\nL: device=../../../" + hid_name(identity, number) + "\n\n";
}

}  // namespace

MockBus::MockBus() : testbed_(umockdev_testbed_new()) {
  stand_in(this);
}

MockBus::~MockBus() {
  stand_in(nullptr);
  g_object_unref(testbed_);
}

int MockBus::plug(std::shared_ptr<MockNode> node) {
  const int number = next_++;
  const MockIdentity& identity = node->identity();
  const std::string record =
      usb_record(identity, number) + hid_record(identity, number) + node_record(identity, number);
  {
    const std::lock_guard lock(mutex_);
    nodes_[number] = std::move(node);
  }
  GError* error = nullptr;
  if (!umockdev_testbed_add_from_string(testbed_, record.c_str(), &error))
    throw std::runtime_error(error->message);
  return number;
}

// The node first, so that who looks for devices meanwhile finds it whole or not at all.
void MockBus::unplug(int number) {
  std::shared_ptr<MockNode> node;
  {
    const std::lock_guard lock(mutex_);
    node = nodes_.at(number);
    nodes_.erase(number);
  }
  umockdev_testbed_remove_device(testbed_, ("/sys" + node_path(node->identity(), number)).c_str());
  node->unplug();
}

int MockBus::open(const std::string& path) {
  const auto node = at(path);
  if (!node) return -ENOENT;
  const int descriptor = node->open();
  if (descriptor < 0) return descriptor;
  const std::lock_guard lock(mutex_);
  opened_[descriptor] = node;
  return descriptor;
}

int MockBus::access(const std::string& path) {
  const auto node = at(path);
  return node ? node->access() : -ENOENT;
}

int MockBus::ioctl(int descriptor, unsigned long request, void* argument) {
  const auto node = of(descriptor);
  return node ? node->ioctl(descriptor, request, argument) : -EBADF;
}

void MockBus::before_poll(int descriptor) {
  if (const auto node = of(descriptor)) node->wait_for_readers_release();
}

void MockBus::closing(int descriptor) {
  const auto node = of(descriptor);
  if (!node) return;
  node->closing(descriptor);
  const std::lock_guard lock(mutex_);
  opened_.erase(descriptor);
}

std::shared_ptr<MockNode> MockBus::at(const std::string& path) {
  const std::lock_guard lock(mutex_);
  for (const auto& [number, node] : nodes_) {
    if (path == "/dev/hidraw" + std::to_string(number)) return node;
  }
  return nullptr;
}

std::shared_ptr<MockNode> MockBus::of(int descriptor) {
  const std::lock_guard lock(mutex_);
  const auto found = opened_.find(descriptor);
  return found == opened_.end() ? nullptr : found->second;
}

}  // namespace palpate::test
