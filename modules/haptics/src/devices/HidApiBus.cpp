#include "HidBus.h"

#include <insonate/haptics/DeviceHub.h>

#include <hidapi/hidapi.h>
#include <unistd.h>

#include <cerrno>
#include <cwchar>

namespace insonate {
namespace {

using haptics::HidBus;
using haptics::HidFound;
using haptics::HidHandle;

/// Each character of hidapi's wide strings is one code point.
std::string utf8(const wchar_t* wide) {
  std::string text;
  for (; wide && *wide; ++wide) {
    const auto c = static_cast<std::uint32_t>(*wide);
    if (c < 0x80) {
      text += static_cast<char>(c);
    } else if (c < 0x800) {
      text += {static_cast<char>(0xC0 | c >> 6), static_cast<char>(0x80 | (c & 0x3F))};
    } else if (c < 0x10000) {
      text += {static_cast<char>(0xE0 | c >> 12), static_cast<char>(0x80 | (c >> 6 & 0x3F)),
               static_cast<char>(0x80 | (c & 0x3F))};
    } else if (c < 0x110000) {
      text += {static_cast<char>(0xF0 | c >> 18), static_cast<char>(0x80 | (c >> 12 & 0x3F)),
               static_cast<char>(0x80 | (c >> 6 & 0x3F)), static_cast<char>(0x80 | (c & 0x3F))};
    }
  }
  return text;
}

class HidApiHandle final : public HidHandle {
 public:
  explicit HidApiHandle(hid_device* device) : device_(device) {}
  ~HidApiHandle() override { hid_close(device_); }
  HidApiHandle(const HidApiHandle&) = delete;
  HidApiHandle& operator=(const HidApiHandle&) = delete;

  int read(std::span<std::uint8_t> report, int wait_ms) noexcept override {
    return hid_read_timeout(device_, report.data(), report.size(), wait_ms);
  }
  bool write(std::span<const std::uint8_t> report) noexcept override {
    return hid_write(device_, report.data(), report.size()) >= 0;
  }

 private:
  hid_device* device_;
};

class HidApiBus final : public HidBus {
 public:
  std::vector<HidFound> list() override {
    std::vector<HidFound> found;
    hid_device_info* const first = hid_enumerate(0, 0);
    for (const hid_device_info* d = first; d; d = d->next)
      found.push_back({d->path, utf8(d->manufacturer_string), utf8(d->product_string), utf8(d->serial_number),
                       d->vendor_id, d->product_id, d->usage_page, d->usage});
    hid_free_enumeration(first);
    return found;
  }

  Result<std::unique_ptr<HidHandle>> open(const HidFound& found) override {
    if (::access(found.path.c_str(), R_OK | W_OK) != 0 && errno == EACCES)
      return fail(
          found.path +
          " cannot be opened, because this user has no permission. Run as root: insonate-cli devices --udev-rules > "
          "/etc/udev/rules.d/70-insonate.rules && udevadm control --reload; then unplug the device and plug it "
          "in again.");
    if (hid_device* device = hid_open_path(found.path.c_str())) return std::make_unique<HidApiHandle>(device);
    return fail(found.path + " cannot be opened: " + utf8(hid_error(nullptr)) + ".");
  }
};

}  // namespace

std::shared_ptr<haptics::HidBus> usbDevices() {
  return std::make_shared<HidApiBus>();
}

}  // namespace insonate
