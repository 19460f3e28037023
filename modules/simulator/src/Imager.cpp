#include <insonate/simulator/Imager.h>
#include <insonate/simulator/PointScene.h>
#include <insonate/tissue/PatientVariation.h>
#include <insonate/ultrasound/FrameCost.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace insonate {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Region united(const Region& a, const Region& b) {
  Region sum = a;
  for (int axis = 0; axis < 3; ++axis) {
    sum.low_mm[axis] = std::min(a.low_mm[axis], b.low_mm[axis]);
    sum.high_mm[axis] = std::max(a.high_mm[axis], b.high_mm[axis]);
  }
  return sum;
}

double volumeOf(const Region& region) {
  const Vec3 edge = region.high_mm - region.low_mm;
  return edge.x * edge.y * edge.z;
}

/// Bounds of the volume, including half a voxel around the centers of the outermost voxels.
Region boundsOf(const VolumeGeometry& geometry) {
  const Transform patientFromIndex = geometry.patientFromIndex();
  Region bounds{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int axis = 0; axis < 3; ++axis) index[axis] = corner >> axis & 1 ? geometry.size[axis] - 0.5 : -0.5;
    const Vec3 point_mm = patientFromIndex * index;
    bounds = united(bounds, {point_mm, point_mm});
  }
  return bounds;
}

std::string rounded(Vec3 v) {
  const auto one = [](double x) { return std::abs(x) < 1e9 ? std::to_string(std::lround(x)) : std::string("huge"); };
  return std::string("(") + one(v.x) + ", " + one(v.y) + ", " + one(v.z) + ")";
}

Result<std::shared_ptr<const AcousticScene>> sceneOf(const SceneSource& source, const ImagingSetup& setup,
                                                     const Region& region, std::vector<PointTarget> points,
                                                     const Progress& progress,
                                                     SceneQuality quality = SceneQuality::Full) {
  const bool varies = setup.settings.look != Look::Thesis;
  return AcousticScene::make(source, varies ? tableOfPatient(setup.tissues, source.patient()) : setup.tissues, region,
                             progress, std::move(points), sceneDetail_mm(setup.probe, setup.settings), quality);
}

}  // namespace

Result<Imager> Imager::make(const ImagingSetup& setup, CompoundingSchedule angles) {
  if (auto ok = validate(setup.probe); !ok) return tl::unexpected(ok.error());
  if (auto ok = validate(setup.settings, setup.probe); !ok) return tl::unexpected(ok.error());
  auto engine = makeEngineFor(setup.engine, setup.probe, setup.settings, angles);
  if (!engine) return tl::unexpected(engine.error());
  (*engine)->prepare(setup.probe, setup.settings);
  Imager imager(std::move(*engine), Display(setup.probe, setup.settings));
  if (!setup.color) return imager;
  if (auto ok = validate(*setup.color, setup.probe, setup.settings); !ok) return tl::unexpected(ok.error());
  auto doppler = makeColorDoppler(setup.engine);
  if (!doppler) return tl::unexpected(doppler.error());
  (*doppler)->prepare(setup.probe, setup.settings, *setup.color);
  imager.color_ = Color{std::move(*doppler), ColorDisplay(setup.probe, setup.settings, *setup.color), {}};
  return imager;
}

void Imager::renderColor(const AcousticScene& scene, const Transform& patientFromProbe,
                         const PlaneDisplacement& displacement, ImagingFrame& frame) {
  color_->doppler->render(scene, patientFromProbe, displacement, frame.motion, color_->frame);
  color_->display.process(color_->frame, frame.image, frame.color, frame.noiseSeed);
}

void Imager::render(const AcousticScene& scene, const Transform& patientFromProbe,
                    const PlaneDisplacement& displacement, const Instruments& instruments, ImagingFrame& frame) {
  const auto start = Clock::now();
  engine_->render(scene, patientFromProbe, displacement, instruments, frame.envelope);
  display_.process(frame.envelope, frame.image, frame.noiseSeed);
  const auto colorStart = Clock::now();
  if (color_)
    renderColor(scene, patientFromProbe, displacement, frame);
  else
    frame.color.width = frame.color.height = 0;
  frame.frame_ms = millisecondsSince(start);
  const double color_ms = millisecondsSince(colorStart);
  frame.engine = engine_->name(), frame.engineNote = engine_->note();

  const Display::Stages_ms& display = display_.stages();
  const auto& engine = engine_->stages();
  frame.stages.resize(engine.size() + (color_ ? 5 : 4));
  auto stage = frame.stages.begin();
  const auto put = [&stage](std::string_view name, double ms) {
    stage->name = name;
    stage++->ms = ms;
  };
  for (const Engine::Stage& of : engine) put(of.name, of.ms);
  put("compound", display.compound);
  put("compress", display.compress);
  put("smooth", display.smooth);
  put("scan_convert", display.scanConvert);
  if (color_) put("color", color_ms);
}

void Imager::forget() {
  engine_->forget();
  display_.reset();
  if (color_) color_->display.reset();
}

Region sceneRegion(const ImagingSetup& setup, const Transform& patientFromProbe, double further_mm) {
  Region box = regionOf(setup.probe, setup.settings, Transform{});
  if (setup.mechanics.model != kNoDeformation) {
    const DeformationWindow window = deformationWindow(setup.probe, setup.settings, setup.mechanics);
    box = united(box,
                 {{-window.half_mm, box.low_mm.y, window.top_mm}, {window.half_mm, box.high_mm.y, window.bottom_mm}});
  }
  box.high_mm.z += further_mm;
  Region region{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 point_mm;
    for (int axis = 0; axis < 3; ++axis) point_mm[axis] = corner >> axis & 1 ? box.high_mm[axis] : box.low_mm[axis];
    point_mm = patientFromProbe * point_mm;
    region = united(region, {point_mm, point_mm});
  }
  return region;
}

std::vector<SceneRun> sceneRuns(const ImagingSetup& setup, std::span<const Transform> path, double further_mm) {
  std::vector<SceneRun> runs;
  double largest_mm3 = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Region needed = sceneRegion(setup, path[i], further_mm);
    if (!runs.empty()) {
      SceneRun& run = runs.back();
      const Region both = united(run.region, needed);
      largest_mm3 = std::max(largest_mm3, volumeOf(needed));
      if (volumeOf(both) <= 2 * largest_mm3) {
        run.region = both;
        ++run.count;
        continue;
      }
    }
    largest_mm3 = volumeOf(needed);
    runs.push_back({needed, i, 1});
  }
  return runs;
}

Result<std::shared_ptr<const SceneSource>> makeSceneSource(const CaseView& patient) {
  return SceneSource::make(patient.ct, patient.labels);
}

Result<std::shared_ptr<const AcousticScene>> makeScene(const CaseView& patient, const ImagingSetup& setup,
                                                       const Region& region, const Progress& progress) {
  return makePointScene(patient, setup, region, {}, progress);
}

Result<std::shared_ptr<const AcousticScene>> makeScene(const SceneSource& source, const ImagingSetup& setup,
                                                       const Region& region, const Progress& progress,
                                                       SceneQuality quality) {
  return sceneOf(source, setup, region, {}, progress, quality);
}

Result<std::shared_ptr<const AcousticScene>> makePointScene(const CaseView& patient, const ImagingSetup& setup,
                                                            const Region& region, std::vector<PointTarget> points,
                                                            const Progress& progress) {
  const auto source = makeSceneSource(patient);
  if (!source) return tl::unexpected(source.error());
  return sceneOf(**source, setup, region, std::move(points), progress);
}

Result<void> checkPosesTouchVolume(const PatientCase& patient, const ImagingSetup& setup,
                                   std::span<const Transform> path) {
  const Region bounds_mm = boundsOf(patient.labels.geometry);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Region needed_mm = regionOf(setup.probe, setup.settings, path[i]);
    bool meets = true;
    for (int axis = 0; axis < 3; ++axis)
      meets =
          meets && needed_mm.low_mm[axis] < bounds_mm.high_mm[axis] && needed_mm.high_mm[axis] > bounds_mm.low_mm[axis];
    if (!meets)
      return fail("Pose " + std::to_string(i) + " at " + rounded(path[i].offset) +
                  " mm shows nothing of the case, whose volume extends from " + rounded(bounds_mm.low_mm) + " to " +
                  rounded(bounds_mm.high_mm) + " mm (patient LPS); move the probe there, or use auto.");
  }
  return {};
}

}  // namespace insonate
