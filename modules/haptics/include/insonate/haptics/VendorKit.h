#pragma once

#include <insonate/core/Result.h>
#include <insonate/haptics/DeviceLimits.h>
#include <insonate/haptics/DeviceState.h>
#include <insonate/haptics/Force.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

namespace haptics {
class HidBus;
}

/// A device that a vendor's kit has found.
struct VendorFound {
  std::string serial;  ///< identifies the device in the kit; the same each time it is plugged in
  std::string name;
  DeviceLimits limits;
};

/// An open device. All calls come from one thread, the device's own.
class VendorHandle {
 public:
  virtual ~VendorHandle() = default;
  /// Reads the present state, in the frame of DeviceState.h; time_ns is not used. Returns within a millisecond; false
  /// if the device is gone.
  virtual bool read(DeviceState& state) noexcept = 0;
  /// Sets the force until the next call; it is already within the limits. Returns false if the device is gone.
  virtual bool write(const Force& force) noexcept = 0;
};

/// Interface that a site implements with its vendor's kit (OpenHaptics, Force Dimension), whose license does not allow
/// distribution with Insonate. The site defines makeVendorKit_openhaptics() or makeVendorKit_forcedimension() and
/// builds with
///
/// cmake -D INSONATE_WITH_OPENHAPTICS=ON -D INSONATE_OPENHAPTICS_SOURCES=/site/OpenHapticsKit.cpp -D
/// INSONATE_OPENHAPTICS_LIBRARIES="HD;HDU"
///
/// Phases, limits, the 100 ms rule, recording and the panel then work as for every device. All calls come from the
/// thread that looks for devices.
class VendorKit {
 public:
  virtual ~VendorKit() = default;
  virtual std::string_view name() const = 0;
  /// Lists the devices that are plugged in; called every second, also while devices are open.
  virtual std::vector<VendorFound> list() = 0;
  virtual Result<std::unique_ptr<VendorHandle>> open(const VendorFound& found) = 0;
};

std::unique_ptr<VendorKit> makeVendorKit_openhaptics();
std::unique_ptr<VendorKit> makeVendorKit_forcedimension();

/// Returns the kits that this program was built with; empty unless the build selected some.
std::vector<std::unique_ptr<VendorKit>> builtInVendorKits();

/// Returns a kit's devices as a bus, for a DeviceHub.
std::shared_ptr<haptics::HidBus> devicesOf(std::unique_ptr<VendorKit> kit);

/// Returns the devices on USB and of all built-in kits as a bus, for a DeviceHub.
std::shared_ptr<haptics::HidBus> allDevices();

}  // namespace insonate
