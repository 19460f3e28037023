#pragma once

#include "phantom/Region.h"
#include "phantom/Structure.h"

namespace insonate::phantom {

/// Parameters that distinguish one right arm from another.
///
/// Model frame: the arm is abducted and turned outward, so that its inner side faces the probe. The axes of the case
/// are those of the arm: z grows toward the shoulder, y from the inner to the outer side, and x from the front of the
/// arm (biceps) to its back (triceps). z = 0 is the middle of the humerus.
struct ArmParameters {
  double skin_mm = 1.4;
  double fat_mm = 7.4;
  double veinScale = 1;    ///< scale of the veins' diameters
  std::uint32_t seed = 1;  ///< seed of the vessels' tortuosity
};

/// Makes the middle third of the right upper arm.
Region makeRegion(const ArmParameters& parameters, std::uint32_t seed);

/// Returns the basilic vein, from the elbow to the shoulder.
std::vector<Tube::Knot> basilicVein(const ArmParameters& parameters);

// Parts of the arm; each appends its structures.
void addArmVessels(std::vector<Structure>& into, const ArmParameters& parameters, std::uint32_t seed);
void addArmNerves(std::vector<Structure>& into, const ArmParameters& parameters, std::uint32_t seed);
void addArmMusclesAndBone(std::vector<Structure>& into, std::uint32_t seed);

std::vector<VesselCourse> armVessels(const ArmParameters& parameters);

}  // namespace insonate::phantom
