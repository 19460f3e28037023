#include <insonate/haptics/DeviceTable.h>
#include <insonate/haptics/UdevRules.h>

#include <cstdio>

namespace insonate {

std::string udevRules() {
  std::string rules =
      "# Lets the user at the computer use the devices that Insonate knows. As root:\n"
      "#   insonate-cli devices --udev-rules > /etc/udev/rules.d/70-insonate.rules && udevadm control --reload\n"
      "# then unplug the device and plug it in again.\n";
  for (const DeviceTable& table : builtInDeviceTables()) {
    rules += "\n# " + table.name + "\n";
    for (const DeviceMatch& match : table.matches) {
      char line[120];
      std::snprintf(line, sizeof line,
                    "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\", TAG+=\"uaccess\"\n",
                    match.vendor, match.product);
      rules += line;
    }
  }
  return rules;
}

}  // namespace insonate
