#pragma once

#include <string>

namespace palpate::test {

// What /dev/hidraw* is to this process, and the descriptors that it opens, which are below 4096. The
// functions stand in for the system's calls and are called from any thread; a negative result is an errno.
class HidrawNodes {
 public:
  virtual ~HidrawNodes() = default;
  virtual int open(const std::string& path) = 0;  // a descriptor of the caller's
  virtual int access(const std::string& path) = 0;
  virtual int ioctl(int descriptor, unsigned long request, void* argument) = 0;
  virtual void before_poll(int descriptor) = 0;
  virtual void closing(int descriptor) = 0;
};

// From now on; null for the system's own.
void stand_in(HidrawNodes* nodes);

}  // namespace palpate::test
