#pragma once

#include <insonate/camera/CameraSource.h>
#include <insonate/camera/HandTracker.h>
#include <insonate/haptics/HapticServo.h>
#include <insonate/haptics/PoseDevice.h>

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace insonate {

/// Calibration of a camera: its lens, and its place above the desk.
struct CameraCalibration {
  std::optional<LensModel> lens;            ///< no value: a usual lens without distortion is assumed
  std::optional<Transform> cameraFromDesk;  ///< no value: the desk was not registered (see registerDesk())
};

/// Latest image of the camera, and the bodies that were seen in it, for the user.
struct CameraView {
  struct Edge {
    FramePoint from, to;
  };
  struct Body {
    HandSight sight = HandSight::kNeverSeen;
    HandAdvice advice = HandAdvice::kNotSeen;
    std::vector<Edge> outline;  ///< edges of the body in the image; empty unless sight is kTracked
  };
  CameraFrame frame;           ///< empty before the first frame
  std::array<Body, 2> bodies;  ///< index: HapticTool
};

/// State of the camera, and of a calibration in progress.
struct CameraState {
  std::string name;  ///< name of the camera; empty before it was opened
  int width = 0, height = 0;
  double frames_Hz = 0;   ///< measured rate of frames
  double compute_ms = 0;  ///< time that a frame takes, without waiting for it
  std::string error;      ///< why the camera does not work, and what to do; empty if it works
  enum class Task { kTracking, kLens, kDesk } task = Task::kTracking;
  int taken = 0, needed = 0;  ///< images or poses that the task has, and that it needs
  std::string outcome;        ///< sentence about the last task that ended; empty if there was none
  bool hasFailed = false;     ///< true: the last task ended without a result
};

/// Hands that a camera follows: probe and needle as printed bodies. A thread reads frames, follows both bodies, and
/// posts their poses to two devices. If the camera is lost, the thread tries to open it again each second.
///
/// Device frame: if the desk is registered, that of the desk: origin in the middle of the printed outline, x toward its
/// arrow, y up. Else that of a camera that faces the user: x to the right of the user, y up, z toward the user. The
/// stylus is the tool: its origin is the tip of the needle or the center of the probe's face.
class CameraHands {
 public:
  using Open = std::function<Result<std::unique_ptr<CameraSource>>()>;

  /// `open` is called on the object's thread.
  CameraHands(Open open, std::array<std::shared_ptr<PoseDevice>, 2> devices, const CameraCalibration& calibration);
  /// Ends the thread; the phase of the devices becomes kAbsent.
  ~CameraHands();
  CameraHands(const CameraHands&) = delete;
  CameraHands& operator=(const CameraHands&) = delete;

  /// Makes the two devices that a camera leads: "Camera: probe" and "Camera: needle".
  static std::array<std::shared_ptr<PoseDevice>, 2> makeDevices();

  CameraState state() const;
  /// Copies the latest image.
  CameraView view() const;
  CameraCalibration calibration() const;

  /// Begins to take images of the printed board, until the lens can be computed. Meanwhile no hands are followed.
  void calibrateLens();
  /// Begins to take poses of the probe that the user holds on the printed outline.
  void registerDesk();
  void cancelTask();

 private:
  struct Work;

  void run(const std::stop_token& stop);
  bool openSource(Work& work);
  void setPhases(DevicePhase phase, const std::string& sentence);
  void take(Work& work);
  void follow(Work& work);
  void post(Work& work, HapticTool hand, const TrackedHand& seen);
  void takeBoard(Work& work);
  void takeDesk(Work& work, const TrackedHand& probe);
  void end(const std::string& outcome, bool hasFailed);

  const Open open_;
  const std::array<std::shared_ptr<PoseDevice>, 2> devices_;
  mutable std::mutex mutex_;  ///< guards the following members
  CameraCalibration calibration_;
  CameraState state_;
  CameraView view_;
  std::jthread thread_;  // declared last, since the thread uses the other members
};

/// Returns the state of the device of a body, as CameraHands posts it, without its time; at rest if the body is hidden.
DeviceState stateOf(const TrackedHand& seen, const TagBody& body, const std::optional<Transform>& cameraFromDesk);
/// Pose of the stylus when the probe is held on the printed outline, in the device frame of a registered desk.
Transform stylusOnOutline();
/// Returns a setup in which the tool of a camera's device with a registered desk is at `patientFromOutline` when the
/// probe is held on the printed outline. Both hands then share one frame.
ToolSetup setupOnDesk(const Transform& patientFromOutline);

}  // namespace insonate
