#pragma once

#include "line/WireSight.h"

#include <insonate/cases/VesselName.h>
#include <insonate/core/Vec3.h>

#include <array>
#include <optional>

namespace insonate {

/// Returns the side of the lung that contains a point of gas (kAirway), patient LPS; empty: the point is in the airway.
/// `trachea_mm`: AcousticScene::trachea_mm().
std::optional<BodySide> lungSideAt(Vec3 patient_mm, double trachea_mm);

/// The event Pneumothorax that follows from an event: a needle has punctured a lung. Empty after other events.
struct LungPuncture {
  BodySide side;
  AttemptEvent event;
};
std::optional<LungPuncture> pneumothoraxOf(const AttemptEvent& event, double trachea_mm);

/// The lungs of a case.
struct Lungs {
  const LabelMap& labels;
  double trachea_mm = 0;                ///< AcousticScene::trachea_mm()
  std::array<double, 2> detached_mm{};  ///< LungMotion::detached_mm
  std::optional<BodySide> side{};       ///< lung that is looked for; empty: both
};

/// Part of the pleura in an image.
struct PleuraSight {
  double width_mm = 0;  ///< width of the pleura in the image, not hidden by bone
  double still_mm = 0;  ///< part of this width over which a pneumothorax has detached the lung
};

/// Finds the pleura in the image plane. Neither waits nor allocates.
PleuraSight pleuraIn(const WirePlane& plane, const Lungs& lungs);

/// Finds all that the hands of the line look for in the image: the wire, the bubbles of a flush, and the pleura of the
/// target's side. `trachea_mm`, empty: unknown, and no pleura is found.
LineHands::Sight sightOf(const WirePlane& plane, LineHands& line, const LabelMap& labels,
                         std::optional<double> trachea_mm, const std::array<double, 2>& detached_mm);

}  // namespace insonate
