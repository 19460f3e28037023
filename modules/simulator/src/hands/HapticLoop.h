#pragma once

#include "hand/SkinSurface.h"
#include "hands/FacePatches.h"
#include "hands/GridMaker.h"

#include <insonate/haptics/SimulatedDevice.h>
#include <insonate/simulator/HapticSession.h>
#include <insonate/simulator/LiveAttempt.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace insonate {

/// Implementation of HapticSession. Its thread runs step() 60 times a second and holds the mutex meanwhile, some tenths
/// of a millisecond.
class HapticSession::Impl {
 public:
  explicit Impl(std::shared_ptr<haptics::HidBus> bus);
  ~Impl();

  void assignDevice(HapticTool hand, std::shared_ptr<HapticDevice> device, ToolSetup setup);
  void testForce(HapticTool hand, Vec3 force_N);
  void setNeedleFixed(bool held);
  void setFreeHand(FreeHand hand, const WireGrip& wire);
  void wake();

  // The following functions must be called with the mutex locked.
  bool isMouseAssigned(HapticTool hand) const { return devices[hand] && devices[hand] == mice[hand]; }
  SimulatedDevice* simulated(HapticTool hand) const { return dynamic_cast<SimulatedDevice*>(devices[hand].get()); }
  void moveByMouse(HapticTool hand, const Transform& patientFromTool);
  void moveMouse(HapticTool hand, const Transform& before, const Transform& patientFromTool);
  void placeMouse(HapticTool hand, const Transform& patientFromTool);
  void show(LiveImaging* in);
  void hideNeedle();
  void showAttempt(const LiveAttempt* of);
  void forgetTissue();
  void wantTissue(const Transform& patientFromTool);

  DeviceHub hub;
  std::once_flag looking;
  mutable std::mutex mutex;  ///< guards all members that are declared below it
  std::array<std::shared_ptr<MouseDevice>, 2> mice;
  std::array<Transform, 2> mouseAt;
  /// center of the workspace of the device emulated by the mouse, for probe and needle
  std::array<Vec3, 2> mousePlace_mm;
  std::array<std::shared_ptr<HapticDevice>, 2> devices;
  ServoSetup setup;
  std::shared_ptr<const LabelMap> labels;
  std::shared_ptr<const SkinSurface> skin;
  LiveImaging* imaging = nullptr;
  std::shared_ptr<const LiveFrame> frame;  ///< last live image from which patches_ has taken the tissue's stiffness
  std::shared_ptr<const TissueGrid> grid;
  std::shared_ptr<const std::vector<CenterLine>> veins;
  VesselLocator vessels;
  std::shared_ptr<HapticDevice> pedal;
  std::uint32_t pedalDown = 0, presses = 0;
  std::unique_ptr<ServoThread> servo;
  std::shared_ptr<LiveAttempt> attempt;

 private:
  using Clock = std::chrono::steady_clock;

  /// A test force in progress (HapticSession::testForce()); meanwhile the device is detached from the force loop.
  struct Test {
    std::shared_ptr<HapticDevice> device;
    HapticTool hand = kProbeTool;
    Vec3 force_N;
    Clock::time_point begin;
  };

  void run(const std::stop_token& stop);
  void regrip(const ServoSnapshot& now);
  void step();
  bool busy() const { return devices[0] || devices[1] || pedal; }
  void takeMade();
  void takeTissue(const ServoSnapshot& now);
  void takeFrame();
  void drive(const ServoSnapshot& now);
  void showNeedle(const ServoSnapshot& now);
  LocalModel modelFor(const ServoSnapshot& now) const;
  void pollPedal();
  void goOnTesting();
  void shapesOf(const LiveFrame& of);

  FacePatches patches_;
  GridMaker maker_;
  Vec3 center_mm_;  ///< center of the tissue grid that is ready or being computed
  bool making_ = false;
  SharedRods rods_;                   ///< rods that were passed to the live imaging last
  std::optional<SalineFlush> flush_;  ///< flush that was passed to the live imaging last
  std::array<bool, 2> lungs_{};       ///< pneumothoraces that were passed to the live imaging last
  std::optional<Needle> needle_;      ///< needle that was passed to the live imaging last
  std::optional<Tenting> tenting_;
  Transform driven_;  ///< probe pose that was passed to the live imaging last
  std::optional<Test> test_;
  std::condition_variable_any changed_;
  std::jthread thread_;  // declared last, since the thread uses the other members
};

}  // namespace insonate
