#include "line/PleuraSight.h"

#include <insonate/ultrasound/AcousticScene.h>

#include <cmath>

namespace insonate {
namespace {

constexpr double kLungStep_mm = 1;

}  // namespace

std::optional<BodySide> lungSideAt(Vec3 patient_mm, double trachea_mm) {
  const double beside_mm = patient_mm.x - trachea_mm;
  if (std::abs(beside_mm) <= AcousticScene::kLungFromTrachea_mm) return std::nullopt;
  return beside_mm < 0 ? BodySide::Right : BodySide::Left;
}

std::optional<LungPuncture> pneumothoraxOf(const AttemptEvent& event, double trachea_mm) {
  if (event.kind != AttemptEventKind::Entered || event.wall != kAirway) return std::nullopt;
  const auto side = lungSideAt(event.tip_mm, trachea_mm);
  if (!side) return std::nullopt;
  return LungPuncture{*side,
                      {.time_us = event.time_us,
                       .kind = AttemptEventKind::Pneumothorax,
                       .wall = kAirway,
                       .into = kAirway,
                       .tip_mm = event.tip_mm,
                       .axis = event.axis,
                       .depth_mm = event.depth_mm}};
}

PleuraSight pleuraIn(const WirePlane& plane, const Lungs& lungs) {
  PleuraSight sight;
  const Transform indexFromPatient = inverted(lungs.labels.geometry.patientFromIndex());
  const double half_mm = plane.depth_mm + plane.field.width_mm / 2;
  for (double x_mm = -half_mm; x_mm <= half_mm; x_mm += kLungStep_mm)
    for (double z_mm = 0; z_mm <= plane.depth_mm; z_mm += kLungStep_mm) {
      const Vec3 shown{x_mm, 0, z_mm};
      if (!isTipInView(plane.field, plane.depth_mm, shown)) continue;
      const Vec3 rest_mm = plane.patientFromProbe * (shown + shiftAt(plane.displacement, x_mm, z_mm));
      const Label label = knownLabel(sampleNearest(lungs.labels, indexFromPatient * rest_mm));
      if (label != kAirway && label != kBone) continue;
      const auto side = label == kAirway ? lungSideAt(rest_mm, lungs.trachea_mm) : std::nullopt;
      if (side && (!lungs.side || side == lungs.side)) {
        sight.width_mm += kLungStep_mm;
        const double detached_mm = lungs.detached_mm[*side == BodySide::Right ? 0 : 1];
        if (std::abs(rest_mm.x - lungs.trachea_mm) < detached_mm) sight.still_mm += kLungStep_mm;
      }
      break;  // bone and gas hide the tissue behind them
    }
  return sight;
}

LineHands::Sight sightOf(const WirePlane& plane, LineHands& line, const LabelMap& labels,
                         std::optional<double> trachea_mm, const std::array<double, 2>& detached_mm) {
  LineHands::Sight sight = wireSightOf(plane, line);
  sight.bubbles = bubblesIn(plane, line, labels);
  if (!trachea_mm || line.state().catheter_mm <= 0) return sight;
  const PleuraSight pleura = pleuraIn(plane, {labels, *trachea_mm, detached_mm, line.side()});
  sight.pleura_mm = pleura.width_mm, sight.still_mm = pleura.still_mm;
  return sight;
}

}  // namespace insonate
