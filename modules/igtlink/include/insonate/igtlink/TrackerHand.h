#pragma once

#include <insonate/camera/ToolCalibration.h>
#include <insonate/haptics/PoseDevice.h>
#include <insonate/igtlink/LinkClient.h>

#include <memory>
#include <string>

namespace insonate {

/// Places that calibration finds for a tool of a tracker. The marker frame is that in which the tracker measures the
/// tool.
struct TrackerCalibration {
  /// Maps the tracker's frame to the device frame of DeviceState: x to the user's right, y up, z toward the user.
  Transform deviceFromTracker;
  /// Origin: tip of the tool; -z: from the marker to the tip.
  Transform markerFromStylus;
};

/// A tool of a tracking program as a hand-held device: each tracker that PLUS drives can move probe or needle. The
/// device is lost while the tracker does not see the tool, or while there is no connection; it stays where it was.
/// Every function may be called from any thread.
class TrackerHand {
 public:
  /// Poses of this time are kept for calibration.
  static constexpr int kKept_s = 15;

  /// Starts to connect to the tracking program. `tool`: name of the TRANSFORM or POSITION message, or of the tool in
  /// TDATA, e.g. "ProbeToTracker"; empty: the first tool of which a pose arrives.
  TrackerHand(const std::string& host, int port, const std::string& tool, const TrackerCalibration& calibration = {});
  ~TrackerHand();
  TrackerHand(const TrackerHand&) = delete;
  TrackerHand& operator=(const TrackerHand&) = delete;

  /// Returns the device, to be added to the DeviceHub. After this object is destroyed, the device is absent.
  std::shared_ptr<PoseDevice> device() const;
  LinkClientStatus status() const;

  TrackerCalibration calibration() const;
  /// Computes the tip from the poses of the last 15 s, in which the user has pivoted the tool about its tip in all
  /// directions, and uses it from now on. Fails as calibratePivot() does, and without poses.
  Result<PivotCalibration> calibrateTip();
  /// Computes the place of the desk from the poses of the last second, in which the user has held the tool still on the
  /// printed outline (see registerDesk()) with the outline's arrow to the right, and uses it from now on. The axes of
  /// the marker must be those of the probe: x toward the arrow, z into the desk.
  Result<DeskRegistration> setDesk();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
