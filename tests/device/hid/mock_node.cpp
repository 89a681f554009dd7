#include "tests/device/hid/mock_node.h"

#include <errno.h>
#include <linux/hidraw.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

namespace palpate::test {
namespace {

// A transfer of ours that waits holds a few reports; the queue of the kernel's is longer than any stall here.
constexpr int kOutgoing = 1;
constexpr int kIncoming = 4 << 20;

int tell_descriptor(const Report& descriptor, void* argument) {
  auto& out = *static_cast<hidraw_report_descriptor*>(argument);
  out.size = static_cast<std::uint32_t>(descriptor.size());
  std::copy(descriptor.begin(), descriptor.end(), out.value);
  return 0;
}

}  // namespace

MockNode::~MockNode() {
  unplug();
}

void MockNode::send(std::span<const std::uint8_t> report) {
  const std::lock_guard lock(mutex_);
  for (const auto& [theirs, ours] : ours_by_theirs_) {
    static_cast<void>(::send(ours, report.data(), report.size(), MSG_DONTWAIT | MSG_NOSIGNAL));
  }
}

std::vector<Report> MockNode::received() {
  const std::lock_guard lock(mutex_);
  std::vector<Report> all;
  if (!taking_) return all;
  std::uint8_t bytes[256];
  for (const auto& [theirs, ours] : ours_by_theirs_) {
    ssize_t length = 0;
    while ((length = recv(ours, bytes, sizeof bytes, MSG_DONTWAIT)) > 0)
      all.emplace_back(bytes, bytes + length);
  }
  return all;
}

std::size_t MockNode::discard() {
  const std::lock_guard lock(mutex_);
  std::size_t count = 0;
  std::uint8_t bytes[256];
  for (const auto& [theirs, ours] : ours_by_theirs_)
    while (recv(ours, bytes, sizeof bytes, MSG_DONTWAIT) > 0) ++count;
  return count;
}

bool MockNode::is_open() {
  const std::lock_guard lock(mutex_);
  return !ours_by_theirs_.empty();
}

void MockNode::hold_readers(bool held) {
  const std::lock_guard lock(mutex_);
  held_ = held;
  released_.notify_all();
}

void MockNode::stop_taking(bool stopped) {
  const std::lock_guard lock(mutex_);
  taking_ = !stopped;
}

int MockNode::open() {
  const std::lock_guard lock(mutex_);
  if (!plugged_) return -ENODEV;
  if (!permitted_) return -EACCES;
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return -errno;
  setsockopt(ends[0], SOL_SOCKET, SO_SNDBUF, &kOutgoing, sizeof kOutgoing);
  if (setsockopt(ends[1], SOL_SOCKET, SO_SNDBUFFORCE, &kIncoming, sizeof kIncoming) != 0) {
    setsockopt(ends[1], SOL_SOCKET, SO_SNDBUF, &kIncoming, sizeof kIncoming);
  }
  ours_by_theirs_[ends[0]] = ends[1];
  return ends[0];
}

void MockNode::permit(bool permitted) {
  const std::lock_guard lock(mutex_);
  permitted_ = permitted;
}

int MockNode::access() {
  const std::lock_guard lock(mutex_);
  return permitted_ ? 0 : -EACCES;
}

int MockNode::ioctl(int, unsigned long request, void* argument) {
  const std::size_t size = _IOC_SIZE(request);
  switch (_IOC_NR(request)) {
    case _IOC_NR(HIDIOCGRDESCSIZE):
      *static_cast<int*>(argument) = static_cast<int>(identity_.descriptor.size());
      return 0;
    case _IOC_NR(HIDIOCGRDESC):
      return tell_descriptor(identity_.descriptor, argument);
    case _IOC_NR(HIDIOCGRAWINFO):
      *static_cast<hidraw_devinfo*>(argument) = {BUS_USB, static_cast<__s16>(identity_.vendor),
                                                 static_cast<__s16>(identity_.product)};
      return 0;
    case _IOC_NR(HIDIOCSFEATURE(0)):
      return set_feature({static_cast<std::uint8_t*>(argument), size}) ? static_cast<int>(size) : -EIO;
    case _IOC_NR(HIDIOCGFEATURE(0)): {
      Report report;
      if (!get_feature(*static_cast<std::uint8_t*>(argument), report)) return -EIO;
      const std::size_t length = std::min(report.size(), size);
      std::copy_n(report.begin(), length, static_cast<std::uint8_t*>(argument));
      return static_cast<int>(length);
    }
    default:
      return -ENOTTY;
  }
}

void MockNode::wait_for_readers_release() {
  std::unique_lock lock(mutex_);
  released_.wait(lock, [this] { return !held_; });
}

void MockNode::closing(int descriptor) {
  const std::lock_guard lock(mutex_);
  const auto found = ours_by_theirs_.find(descriptor);
  if (found == ours_by_theirs_.end()) return;
  ::close(found->second);
  ours_by_theirs_.erase(found);
}

// Their ends stay open, and see that ours have gone.
void MockNode::unplug() {
  const std::lock_guard lock(mutex_);
  plugged_ = held_ = false;
  released_.notify_all();
  for (const auto& [theirs, ours] : ours_by_theirs_) ::close(ours);
  ours_by_theirs_.clear();
}

}  // namespace palpate::test
