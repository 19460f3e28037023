#pragma once

#include "LiveProbe.h"
#include "devices/HidBus.h"

#include <insonate/haptics/SimulatedDevice.h>
#include <insonate/simulator/HapticSession.h>
#include <insonate/simulator/NeedlePlacement.h>

namespace insonate::test {

class NoDevices final : public haptics::HidBus {
 public:
  std::vector<haptics::HidFound> list() override { return {}; }
  Result<std::unique_ptr<haptics::HidHandle>> open(const haptics::HidFound&) override { return fail("nothing here"); }
};

/// A skin that faces -y at y = -0.5 mm, veins every 20 mm with their middle at y = 12.
inline ImagingSetup elasticSetup() {
  ImagingSetup setup = smallSetup();
  setup.mechanics.model = "elastic";
  setup.mechanics.settings.mesh_mm = 1;
  return setup;
}

inline Transform pressedBy(double mm) {
  return *patientFromProbe({0, mm - 0.5, 0}, {0, 1, 0}, {1, 0, 0});
}

template <class Holds>
bool eventually(const Holds& holds, std::chrono::milliseconds patience = std::chrono::minutes(5)) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// Hands on a wide case, with live pictures.
struct HandsBench {
  std::shared_ptr<const PatientCase> patient = wideCase();
  ProbePlacement probe = *ProbePlacement::make(patient->labels, pressedBy(-2));
  Live live;
  HapticSession hands{std::make_shared<NoDevices>()};

  explicit HandsBench(const LiveOptions& options = {}) : live(pressedBy(-2), elasticSetup(), options, patient) {
    live.frameAt(pressedBy(-2));
    hands.setImaging(live.operator->());
    hands.setCase(CaseVolumes(patient).labels, &probe);
    EXPECT_TRUE(eventually([&] { return hands.isTissueGridReady(); }));
  }
  ~HandsBench() { hands.setImaging(nullptr); }

  /// A device of the strongest kind, held by a hand that mouse and keys lead.
  std::shared_ptr<SimulatedDevice> probeDevice() {
    const auto device = std::make_shared<SimulatedDevice>("omega", deviceProfiles()[3], Grip{}, HandPath::Point{});
    ToolSetup setup;
    setup.patientFromDevice.offset = pressedBy(-2).offset;
    setup.stylusFromTool.linear = pressedBy(-2).linear;
    hands.assignDevice(kProbeTool, device, setup);
    return device;
  }
  /// By mouse and keys, square to the skin over a vein.
  NeedlePlacement takeNeedle() {
    NeedlePlacement needle = NeedlePlacement::makeBeside(probe, 19, NeedlePlane::InPlane, {});
    needle.moveTo({0, -0.5, 0});
    needle.tilt(90 - needle.state().angle_deg);
    hands.assignMouse(kNeedleTool, needle.patientFromNeedle());
    return needle;
  }
  /// Pushes the needle as mouse and keys do, at 25 mm/s.
  void push(NeedlePlacement& needle, double to_mm) {
    while (std::abs(needle.state().advance_mm - to_mm) > 1e-9) {
      needle.advance(std::clamp(to_mm - needle.state().advance_mm, -0.4, 0.4));
      hands.moveByMouse(kNeedleTool, needle.patientFromNeedle());
      std::this_thread::sleep_for(std::chrono::milliseconds(16));
      for (const NeedleEvent& event : hands.takeEvents()) events.push_back(event);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    for (const NeedleEvent& event : hands.takeEvents()) events.push_back(event);
  }
  std::vector<NeedleEvent> events;
};

}  // namespace insonate::test
