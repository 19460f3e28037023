#include "doppler/TubeCase.h"

#include <cmath>
#include <numbers>

namespace insonate::bench {
namespace {

constexpr double kDepth_mm = 20, kVoxel_mm = 0.5;

}  // namespace

Vec3 TubeCase::direction() const {
  const double angle = angle_deg * std::numbers::pi / 180;
  return {std::sin(angle), 0, -std::cos(angle)};  // toward the probe
}

double TubeCase::offAxis_mm(Vec3 probe_mm) const {
  const Vec3 from = probe_mm - Vec3{0, 0, kDepth_mm};
  return norm(from - direction() * dot(from, direction()));
}

Result<TubeCase> TubeCase::make(double angle_deg, double radius_mm) {
  TubeCase tube;
  tube.angle_deg = angle_deg, tube.radius_mm = radius_mm;
  auto probe = loadProbe("linear");
  if (!probe) return tl::unexpected(probe.error());
  auto tissues = loadAcousticTable("neck");
  if (!tissues) return tl::unexpected(tissues.error());
  tube.probe = std::move(*probe);
  tube.settings = settingsFor(tube.probe);
  tube.settings.conformingContact = false;
  tube.color = colorSettingsFor(tube.probe, tube.settings);
  tube.color.near_mm = 10, tube.color.far_mm = 30;

  const Region region = regionOf(tube.probe, tube.settings, Transform{});
  VolumeGeometry grid;
  for (int axis = 0; axis < 3; ++axis) {
    grid.spacing_mm[axis] = kVoxel_mm;
    grid.origin_mm[axis] = region.low_mm[axis] - 1;
    grid.size[axis] = static_cast<int>((region.high_mm[axis] - region.low_mm[axis] + 2) / kVoxel_mm) + 1;
  }
  CtVolume ct(grid);
  LabelMap labels(grid);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 at_mm = grid.origin_mm + Vec3{i * kVoxel_mm, j * kVoxel_mm, k * kVoxel_mm};
        labels.at(i, j, k) = tube.offAxis_mm(at_mm) < radius_mm ? kVein : kMuscle;
      }
  auto scene = AcousticScene::make(ct, labels, *tissues, region);
  if (!scene) return tl::unexpected(scene.error());
  tube.scene = std::move(*scene);
  return tube;
}

BloodFlow TubeCase::flowOf(double speed_mmps) const {
  BloodTube tube;
  tube.label = kVein;
  for (const double along_mm : {-60.0, 0.0, 60.0})
    tube.course.push_back({Vec3{0, 0, kDepth_mm} + direction() * along_mm, direction(), radius_mm, 1});
  tube.profile_mmps.fill(speed_mmps);
  return {{tube}};
}

ColorFrame TubeCase::frameOf(const std::string& engine, double speed_mmps) const {
  ColorFrame frame;
  const auto doppler = makeColorDoppler(engine);
  (*doppler)->prepare(probe, settings, color);
  const BloodFlow flow = flowOf(speed_mmps);
  (*doppler)->render(*scene, {}, {}, {.blood = &flow}, frame);
  return frame;
}

double TubeCase::middleVelocity_mmps(const std::string& engine, double speed_mmps) const {
  const ColorFrame frame = frameOf(engine, speed_mmps);
  const std::size_t at = frame.at(frame.lines / 2, frame.gates / 2);
  return std::atan2(frame.lagOneIm[at], frame.lagOneRe[at]) / std::numbers::pi * nyquistVelocity_mmps(color);
}

std::pair<double, double> TubeCase::areas_mm2(const std::string& engine, double speed_mmps) const {
  BModeImage gray;
  Display(probe, settings).process({}, gray);
  ColorImage image;
  ColorDisplay(probe, settings, color).process(frameOf(engine, speed_mmps), gray, image, 1);
  double colored = 0, lumen = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const std::uint8_t* p = image.rgba.data() + (std::size_t(row) * image.width + column) * 4;
      colored += p[3] != 0 && p[0] != p[2];  // without the gray outline
      lumen += offAxis_mm({gray.left_mm + (image.column + column) * gray.pixel_mm, 0,
                           gray.top_mm + (image.row + row) * gray.pixel_mm}) < radius_mm;
    }
  const double pixel_mm2 = gray.pixel_mm * gray.pixel_mm;
  return {colored * pixel_mm2, lumen * pixel_mm2};
}

double flowThrough_mm3ps(const BloodTube& tube, const BloodTube::Point& point) {
  constexpr int kRings = 400;
  double sum = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const double share = (ring + 0.5) / kRings;
    sum += point.scale * tube.profileAt_mmps(share) * 2 * std::numbers::pi * share / kRings;
  }
  return sum * point.radius_mm * point.radius_mm;
}

}  // namespace insonate::bench
