#include "samples/hid_device/uhid_port.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <string.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

namespace palpate::hid_device {
namespace {

constexpr const char* kNode = "/dev/uhid";
constexpr std::uint8_t kFeaturesId = 3;

template <std::size_t kSize>
void store_text(const std::string& text, std::uint8_t (&out)[kSize]) {
  std::copy_n(text.begin(), std::min(text.size(), kSize - 1), out);
}

void write_event(int file, const uhid_event& event) {
  if (write(file, &event, sizeof event) >= 0) return;
  throw std::runtime_error(std::string("writing to ") + kNode + ": " + strerror(errno));
}

void answer_get(int file, const uhid_get_report_req& asked, const HapticDevice& device) {
  uhid_event answer{};
  answer.type = UHID_GET_REPORT_REPLY;
  answer.u.get_report_reply.id = asked.id;
  const auto report = device.features();
  if (asked.rnum == kFeaturesId) {
    answer.u.get_report_reply.size = static_cast<std::uint16_t>(report.size());
    std::copy(report.begin(), report.end(), answer.u.get_report_reply.data);
  } else {
    answer.u.get_report_reply.err = EIO;
  }
  write_event(file, answer);
}

void answer_set(int file, const uhid_set_report_req& asked, HapticDevice& device) {
  uhid_event answer{};
  answer.type = UHID_SET_REPORT_REPLY;
  answer.u.set_report_reply.id = asked.id;
  const Bytes report(asked.data, std::min<std::size_t>(asked.size, sizeof asked.data));
  answer.u.set_report_reply.err = device.take_command(report) ? 0 : EIO;
  write_event(file, answer);
}

}  // namespace

UhidPort::UhidPort(std::uint16_t vendor, std::uint16_t product, const std::string& serial)
    : file_(open(kNode, O_RDWR | O_CLOEXEC | O_NONBLOCK)) {
  if (file_ < 0) {
    throw std::runtime_error(std::string(kNode) + ": " + strerror(errno) +
                             ": run as root, on a kernel with the module uhid (modprobe uhid)");
  }
  uhid_event event{};
  event.type = UHID_CREATE2;
  uhid_create2_req& made = event.u.create2;
  store_text("Palpate reference device", made.name);
  store_text(serial, made.uniq);
  const auto descriptor = report_descriptor();
  made.rd_size = static_cast<std::uint16_t>(descriptor.size());
  std::copy(descriptor.begin(), descriptor.end(), made.rd_data);
  made.bus = BUS_USB;
  made.vendor = vendor;
  made.product = product;
  try {
    write_event(file_, event);
  } catch (...) {
    close(file_);
    throw;
  }
}

UhidPort::~UhidPort() {
  close(file_);
}

void UhidPort::serve(HapticDevice& device, std::chrono::steady_clock::time_point until) {
  using std::chrono::nanoseconds;
  constexpr long kSecond = 1'000'000'000;
  while (true) {
    const auto left = std::max(nanoseconds(0), nanoseconds(until - std::chrono::steady_clock::now()));
    const timespec timeout{left.count() / kSecond, left.count() % kSecond};
    pollfd waiting{file_, POLLIN, 0};
    if (ppoll(&waiting, 1, &timeout, nullptr) <= 0) return;
    while (serve_one(device)) {
    }
  }
}

bool UhidPort::serve_one(HapticDevice& device) {
  uhid_event event{};
  if (read(file_, &event, sizeof event) <= 0) return false;
  switch (event.type) {
    case UHID_OUTPUT:
      device.take_wrench({event.u.output.data, std::min<std::size_t>(event.u.output.size, UHID_DATA_MAX)});
      break;
    case UHID_GET_REPORT:
      answer_get(file_, event.u.get_report, device);
      break;
    case UHID_SET_REPORT:
      answer_set(file_, event.u.set_report, device);
      break;
    default:
      break;
  }
  return true;
}

void UhidPort::send(Bytes report) {
  uhid_event event{};
  event.type = UHID_INPUT2;
  event.u.input2.size = static_cast<std::uint16_t>(report.size());
  std::copy(report.begin(), report.end(), event.u.input2.data);
  write_event(file_, event);
}

}  // namespace palpate::hid_device
