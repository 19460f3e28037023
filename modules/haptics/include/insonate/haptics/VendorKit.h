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

/// An open device of a vendor's SDK. All calls come from one thread, the thread of the device.
class VendorHandle {
 public:
  virtual ~VendorHandle() = default;
  /// Reads the device's present state into `state`, in the frames of DeviceState.h; `state.time_ns` need not be set.
  /// Must return within a millisecond. Returns false if the device is disconnected.
  virtual bool read(DeviceState& state) noexcept = 0;
  /// Sets the force that the device exerts until the next call, in the device frame. The caller has already limited the
  /// force. Returns false if the device is disconnected.
  virtual bool write(const Force& force) noexcept = 0;
};

/// Interface to a vendor's SDK (OpenHaptics, Force Dimension). The licenses of these SDKs do not allow distribution
/// with Insonate; a site that has an SDK therefore implements this interface. The site defines
/// makeVendorKit_openhaptics() or makeVendorKit_forcedimension() and builds with
///
/// cmake -D INSONATE_WITH_OPENHAPTICS=ON -D INSONATE_OPENHAPTICS_SOURCES=/site/OpenHapticsKit.cpp -D
/// INSONATE_OPENHAPTICS_LIBRARIES="HD;HDU"
///
/// Connection states, force limits, the end of forces after 100 ms, recording and the device panel then work as for all
/// other devices. All calls come from the thread that searches for devices.
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

/// Returns the vendor SDKs with which this program was built; empty if it was built without any.
std::vector<std::unique_ptr<VendorKit>> builtInVendorKits();

/// Returns a bus for DeviceHub that lists and opens the devices of a vendor's SDK.
std::shared_ptr<haptics::HidBus> devicesOf(std::unique_ptr<VendorKit> kit);

/// Returns a bus for DeviceHub that lists and opens the USB and Bluetooth devices and those of all built-in vendor
/// SDKs.
std::shared_ptr<haptics::HidBus> allDevices();

}  // namespace insonate
