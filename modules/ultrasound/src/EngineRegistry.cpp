#include "auto/AutoEngine.h"
#include "compound/CompoundingEngine.h"
#include "cpu/CpuEngine.h"
#include "glsl/GlslEngine.h"
#include "model/FramePlan.h"
#include "reference/ReferenceEngine.h"

#include <insonate/ultrasound/Engine.h>

#include <algorithm>

namespace insonate {

std::vector<std::string> engineNames() {
  return {"reference", "cpu", "glsl"};
}

Result<std::unique_ptr<Engine>> makeEngine(std::string_view name) {
  if (name == "reference") return makeReferenceEngine();
  if (name == "cpu") return makeCpuEngine();
  if (name == "glsl") return makeGlslEngine();
  if (name == "auto") return makeAutoEngine();
  return fail("There is no engine \"" + std::string(name) + "\"; choose auto, reference, cpu or glsl.");
}

Result<std::unique_ptr<Engine>> makeEngineFor(std::string_view name, const Probe& probe,
                                              const ImagingSettings& settings) {
  const std::size_t angles = steeringAngles_deg(probe, settings).size();
  if (angles == 1) return makeEngine(name);
  std::vector<std::unique_ptr<Engine>> engines;
  for (std::size_t a = 0; a < angles; ++a) {
    auto engine = makeEngine(name);
    if (!engine) return engine;
    engines.push_back(std::move(*engine));
  }
  return std::make_unique<CompoundingEngine>(std::move(engines));
}

Region regionOf(const Probe& probe, const ImagingSettings& settings, const Transform& patientFromProbe,
                double largestShift_mm) {
  const FramePlan plan(probe, settings);
  Region region{{1e30, 1e30, 1e30}, {-1e30, -1e30, -1e30}};
  const double thickness_mm = 3 * *std::max_element(plan.elevationSd_mm.begin(), plan.elevationSd_mm.end());
  const double beyond_mm = acoustics::kContactReach_mm + largestShift_mm;
  double left_mm = plan.grid.minLateral_mm(), right_mm = plan.grid.maxLateral_mm();
  for (const double angle_deg : steeringAngles_deg(probe, settings)) {
    ImagingSettings steered = settings;
    steered.steering_deg = angle_deg;
    const BeamGrid grid(probe, steered);
    left_mm = std::min(left_mm, grid.minLateral_mm()), right_mm = std::max(right_mm, grid.maxLateral_mm());
  }
  const double lateral[] = {left_mm - largestShift_mm, right_mm + largestShift_mm};
  const double axial[] = {plan.grid.minAxial_mm() - beyond_mm, plan.grid.maxAxial_mm() + beyond_mm};
  for (const double x : lateral)
    for (const double y : {-thickness_mm, thickness_mm})
      for (const double z : axial) {
        const Vec3 p = patientFromProbe * Vec3{x, y, z};
        for (int a = 0; a < 3; ++a) {
          region.low_mm[a] = std::min(region.low_mm[a], p[a]);
          region.high_mm[a] = std::max(region.high_mm[a], p[a]);
        }
      }
  return region;
}

}  // namespace insonate
