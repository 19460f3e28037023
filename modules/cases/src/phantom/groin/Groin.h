#pragma once

#include "phantom/Region.h"
#include "phantom/Structure.h"

namespace insonate::phantom {

/// Parameters that distinguish one right groin from another.
///
/// Model frame: x = 0 near the common femoral artery (x grows toward the patient's left, and the thigh's midline is at
/// the artery), y = 0 on the fascia lata in front of the artery, z = 0 where the inguinal ligament crosses the artery.
struct GroinParameters {
  double skin_mm = 1.8;
  double fat_mm = 6.5;       ///< mean thickness of the subcutaneous fat in front of the vessels
  double veinScale = 1;      ///< scale of the femoral vein's diameters
  double arteryScale = 1;    ///< scale of the arteries' diameters
  double overlap = 0;        ///< 0 to 1: shift of the artery in front of the vein; 1: half of the vein is covered
  bool hasThrombus = false;  ///< true: a thrombus fills the vein below the saphenofemoral junction
  std::uint32_t seed = 1;    ///< seed of the vessels' tortuosity
};

/// Makes the right groin from the external iliac vessels to the middle of the femoral triangle.
Region makeRegion(const GroinParameters& parameters, std::uint32_t seed);

/// Label of the thrombus: an own label of the case, since the label table has none.
inline constexpr std::uint8_t kThrombus = kLabelCount;

/// Returns the level of the inguinal ligament at a distance from the artery, lateral positive.
double inguinalLigament_mm(double lateral_mm);

/// Returns the femoral vein at a level, from the external iliac vein to the femoral vein of the thigh: lateral and
/// posterior position of its center, half width, half height, rotation (degrees).
std::array<double, 5> femoralVeinAt(const GroinParameters& parameters, double z_mm);

// Parts of the groin; each appends its structures.
void addGroinVessels(std::vector<Structure>& into, const GroinParameters& parameters, std::uint32_t seed);
void addGroinSkeleton(std::vector<Structure>& into, std::uint32_t seed);
void addGroinNerves(std::vector<Structure>& into, std::uint32_t seed);
void addGroinMuscles(std::vector<Structure>& into, std::uint32_t seed);

std::vector<VesselCourse> groinVessels(const GroinParameters& parameters);

}  // namespace insonate::phantom
