#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// The lumens of a case as tubes that are joined where a vessel begins in, or within 3 mm of, another one, and
/// that are continued beyond the case: veins through the superior or inferior vena cava into the right atrium, arteries
/// to the root of the aorta, other large vessels straight on. Veins and arteries are separate systems. Patient LPS.
///
/// All queries neither wait nor allocate, and may be called by several threads.
class VesselTree {
 public:
  struct Vessel {
    NamedVessel tube;
    bool beyondCase = false;     ///< part of the stated anatomy beyond the case
    bool isBeyondHeart = false;  ///< the right atrium, or the vena cava on its other side
  };

  /// Fails if no vessel has the label of a vein or an artery. With `labels`, each cross-section is an ellipse that is
  /// measured in the label map, so that flat veins are flat; null: all tubes are round.
  static Result<VesselTree> make(std::span<const NamedVessel> vessels, const LabelMap* labels = nullptr);

  std::span<const Vessel> vessels() const;

  /// The wall at a point.
  struct Wall {
    double distance_mm = 0;     ///< distance from the point to the wall, negative in the lumen
    Vec3 outward{};             ///< gradient of `distance_mm`
    Vec3 axis{};                ///< unit direction of the tube
    double curvature_1pmm = 0;  ///< second derivative of the distance around the tube
  };
  /// Returns the wall of the system with this label (kVein or kArtery). Infinitely far if the case has no such system.
  Wall wallAt(std::uint8_t label, Vec3 patient_mm) const noexcept;

  struct Location {
    int vessel = -1;         ///< index in vessels()
    double along_mm = 0;     ///< length of the center line from the first point of its course
    double distance_mm = 0;  ///< distance to the wall, negative in the lumen
    /// length of the center lines to the heart (veins: junction of vena cava and right atrium; arteries: root of the
    /// aorta); negative in the atrium and beyond; not a number if the vessel does not lead there
    double toHeart_mm = 0;
    Vec3 towardHeart{};  ///< unit direction of the center line toward the heart; zero if it does not lead there
  };
  /// Returns the tube of the system with this label that contains the point, or whose wall is nearest.
  Location locate(std::uint8_t label, Vec3 patient_mm) const noexcept;

  /// Returns the label of the system whose lumen contains the point, else of the nearest wall.
  std::uint8_t systemAt(Vec3 patient_mm) const noexcept;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace insonate
