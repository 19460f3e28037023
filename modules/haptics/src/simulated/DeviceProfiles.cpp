#include <insonate/haptics/SimulatedHand.h>

#include <algorithm>
#include <array>
#include <limits>

namespace insonate {
namespace {

/// Force, workspace, resolution and friction from the manufacturers' data sheets; maximum stiffness as device software
/// lists it. If no friction is published it is 0.05 N, below that of the best other device, so that the servo does not
/// count on more.
constexpr std::array<DeviceProfile, 5> kProfiles{{
    {"Touch",
     {.sensedAxes = 6,
      .forceAxes = 3,
      .workspace_mm = {160, 120, 70},
      .maxForce_N = 3.3,
      .continuousForce_N = 0.88,
      .maxTorque_Nmm = 0,
      .maxStiffness_Npmm = 0.4,
      .rate_Hz = 1000,
      .resolution_mm = 0.055,
      .damping_Nspm = 0,
      .friction_N = 0.26,
      .mass_kg = 0.045}},
    {"Desktop",
     {.sensedAxes = 6,
      .forceAxes = 3,
      .workspace_mm = {160, 120, 120},
      .maxForce_N = 7.9,
      .continuousForce_N = 1.75,
      .maxTorque_Nmm = 0,
      .maxStiffness_Npmm = 1,
      .rate_Hz = 1000,
      .resolution_mm = 0.023,
      .damping_Nspm = 0,
      .friction_N = 0.06,
      .mass_kg = 0.045}},
    {"Falcon",
     {.sensedAxes = 3,
      .forceAxes = 3,
      .workspace_mm = {100, 100, 100},
      .maxForce_N = 8,
      .continuousForce_N = 8,
      .maxTorque_Nmm = 0,
      .maxStiffness_Npmm = 3,
      .rate_Hz = 1000,
      .resolution_mm = 0.0635,
      .damping_Nspm = 0,
      .friction_N = 0.05,
      .mass_kg = 0.1}},
    {"omega",
     {.sensedAxes = 3,
      .forceAxes = 3,
      .workspace_mm = {160, 160, 110},
      .maxForce_N = 12,
      .continuousForce_N = 12,
      .maxTorque_Nmm = 0,
      .maxStiffness_Npmm = 5,
      .rate_Hz = 1000,
      .resolution_mm = 0.01,
      .damping_Nspm = 0,
      .friction_N = 0.05,
      .mass_kg = 0.2}},
    {"WoodenHaptics",
     {.sensedAxes = 3,
      .forceAxes = 3,
      .workspace_mm = {200, 250, 200},
      .maxForce_N = 9.9,
      .continuousForce_N = 0,
      .maxTorque_Nmm = 0,
      .maxStiffness_Npmm = 1,
      .rate_Hz = 1000,
      .resolution_mm = 0.03,
      .damping_Nspm = 0,
      .friction_N = 0.05,
      .mass_kg = 0.2}},
}};

}  // namespace

std::span<const DeviceProfile> deviceProfiles() {
  return kProfiles;
}

double passiveStiffness_Npmm(const DeviceLimits& limits, double virtualDamping_Nspm, double fastest_mmps) {
  const double tick_s = 1 / (limits.rate_Hz > 0 ? limits.rate_Hz : 1000);
  const double byDamping_Npm = std::max(0.0, 2 * (limits.damping_Nspm - virtualDamping_Nspm) / tick_s);
  const double bySteps_Npmm =
      limits.resolution_mm > 0 ? 2 * limits.friction_N / limits.resolution_mm : std::numeric_limits<double>::infinity();
  const double bySpeed_Npmm = 2 * limits.friction_N / (tick_s * std::max(fastest_mmps, 1e-9));
  return std::max(byDamping_Npm * 1e-3, std::min(bySteps_Npmm, bySpeed_Npmm));
}

}  // namespace insonate
