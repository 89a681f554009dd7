#include "engine/device/hid/hid_advice.h"

#include <cstdio>

namespace palpate {

std::string udev_rule(const HidName& name) {
  char rule[96];
  std::snprintf(rule, sizeof rule, R"(KERNEL=="hidraw*", KERNELS=="*:%04X:%04X.*", TAG+="uaccess")",
                unsigned{name.vendor}, unsigned{name.product});
  return rule;
}

std::string obstacle_to(const HidEntry& entry) {
  if (entry.kind == HidKind::kVendor) {
    return "it speaks its maker's own protocol: use the OpenHaptics backend, openhaptics:Default Device";
  }
  if (entry.taken) return "it is open already";
  if (entry.permitted) return "";
  return "no permission for " + entry.path + ": put the line " + udev_rule(entry.name) +
         " into /etc/udev/rules.d/70-palpate.rules, run \"udevadm control --reload\" as root and plug it in "
         "again";
}

}  // namespace palpate
