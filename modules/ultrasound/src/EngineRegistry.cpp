#include "auto/AutoEngine.h"
#include "compound/CompoundingEngine.h"
#include "cpu/CpuEngine.h"
#include "glsl/GlslEngine.h"
#include "model/FramePlan.h"
#include "reference/ReferenceEngine.h"

#include <insonate/ultrasound/Engine.h>
#include <insonate/ultrasound/PointSpread.h>

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
                                              const ImagingSettings& settings, CompoundingSchedule angles) {
  const std::size_t count = steeringAngles_deg(probe, settings).size();
  if (count == 1) return makeEngine(name);
  std::vector<std::unique_ptr<Engine>> engines;
  for (std::size_t a = 0; a < count; ++a) {
    auto engine = makeEngine(name);
    if (!engine) return engine;
    engines.push_back(std::move(*engine));
  }
  return std::make_unique<CompoundingEngine>(std::move(engines), angles);
}

Region regionOf(const Probe& probe, const ImagingSettings& settings, const Transform& patientFromProbe,
                double largestShift_mm) {
  // The law is within 20 % of the slice thickness that engines compute, and planes are within 2.5 SD of it.
  constexpr double kSlice_sd = 3.5;
  const SliceLaw slice = sliceLaw(probe, settings.frequency_MHz);
  const double thickest_mm = std::max(slice.thickness_mm(0), slice.thickness_mm(settings.depth_mm));
  const BeamGrid straight(probe, settings);
  Region region{{1e30, 1e30, 1e30}, {-1e30, -1e30, -1e30}};
  const double thickness_mm = kSlice_sd * thickest_mm / acoustics::kFwhmPerSd;
  const double beyond_mm = acoustics::kContactReach_mm + largestShift_mm;
  double left_mm = straight.minLateral_mm(), right_mm = straight.maxLateral_mm();
  for (const double angle_deg : steeringAngles_deg(probe, settings)) {
    ImagingSettings steered = settings;
    steered.steering_deg = angle_deg;
    const BeamGrid grid(probe, steered);
    left_mm = std::min(left_mm, grid.minLateral_mm()), right_mm = std::max(right_mm, grid.maxLateral_mm());
  }
  const double lateral[] = {left_mm - largestShift_mm, right_mm + largestShift_mm};
  const double axial[] = {straight.minAxial_mm() - beyond_mm, straight.maxAxial_mm() + beyond_mm};
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
