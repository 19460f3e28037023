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

/// A plugged-in device that a vendor's SDK has found.
struct VendorFound {
  std::string serial;  ///< identifies the device within the SDK; the same each time the device is plugged in
  std::string name;
  DeviceLimits limits;
};

/// An open device of a vendor's SDK. All calls come from one thread, that of the device.
class VendorHandle {
 public:
  virtual ~VendorHandle() = default;
  /// Reads the device's present state, in the frame of DeviceState.h, into `state`; its time_ns is not used. Returns
  /// within a millisecond; false if the device is disconnected.
  virtual bool read(DeviceState& state) noexcept = 0;
  /// Sets the force that the device exerts until the next call; the caller has limited it already. Returns false if the
  /// device is disconnected.
  virtual bool write(const Force& force) noexcept = 0;
};

/// Interface to a vendor's SDK (OpenHaptics, Force Dimension), whose license does not allow distribution with Insonate;
/// each site implements it. The site defines makeVendorKit_openhaptics() or makeVendorKit_forcedimension() and builds
/// with
///
/// cmake -D INSONATE_WITH_OPENHAPTICS=ON -D INSONATE_OPENHAPTICS_SOURCES=/site/OpenHapticsKit.cpp -D
/// INSONATE_OPENHAPTICS_LIBRARIES="HD;HDU"
///
/// Connection states, limits, the end of forces after 100 ms, recording and the device panel then work as for every
/// device. All calls come from the thread that searches for devices.
class VendorKit {
 public:
  virtual ~VendorKit() = default;
  virtual std::string_view name() const = 0;
  /// Lists the SDK's plugged-in devices; called every second, also while devices are open.
  virtual std::vector<VendorFound> list() = 0;
  virtual Result<std::unique_ptr<VendorHandle>> open(const VendorFound& found) = 0;
};

std::unique_ptr<VendorKit> makeVendorKit_openhaptics();
std::unique_ptr<VendorKit> makeVendorKit_forcedimension();

/// Returns the vendor SDKs that this program was built with; empty unless the build selected some.
std::vector<std::unique_ptr<VendorKit>> builtInVendorKits();

/// Returns the devices of a vendor's SDK as a bus for a DeviceHub.
std::shared_ptr<haptics::HidBus> devicesOf(std::unique_ptr<VendorKit> kit);

/// Returns the USB and Bluetooth devices and those of all built-in vendor SDKs as one bus for a DeviceHub.
std::shared_ptr<haptics::HidBus> allDevices();

}  // namespace insonate
