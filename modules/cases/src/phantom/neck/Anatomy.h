#pragma once

#include "phantom/BodySurface.h"
#include "phantom/Structure.h"

#include <array>
#include <vector>

namespace insonate::phantom {

/// Parameters that distinguish one neck from another. Lengths are in mm; arrays hold {right, left}.
struct NeckParameters {
  std::uint32_t seed = 1;  ///< seed of the vessels' tortuosity
  double skin_mm = 1.6;
  double girth_mm = 0;  ///< increase of the neck's girth, added to the radius of the investing fascia
  Platysma platysma;
  double fat_mm = 4.2;
  double veinWidth[2] = {1.0, 0.82};  ///< scale of the jugular vein's width
  double veinHeight[2] = {1.0, 0.9};  ///< scale of the jugular vein's height
  double veinMedial_mm[2] = {0, 0};   ///< shift of the jugular vein toward the carotid artery
  double veinForward_mm[2] = {0, 0};
  double carotidScale = 1;
  double carotidLateral_mm = 0;
  double bifurcation_z_mm = 31;   ///< level of the carotid bifurcation above the cricoid
  double headTurn_deg = 0;        ///< rotation of the head toward the patient's left, at the top of the model
  double sternomastoidScale = 1;  ///< scale of the sternocleidomastoid's thickness
  double thyroidScale = 1;
  bool chest = false;     ///< true: adds the structures below the clavicles, down to 100 mm below the cricoid
  bool axillary = false;  ///< true: the target is the axillary vein, lateral of the first rib
};

/// Returns one person's neck, varied around a variant's default values within the limits of the variant's description.
NeckParameters individualNeck(NeckParameters usual, std::uint32_t seed);

/// Returns the shape of the neck.
const Outline& neckOutline();

/// Returns the neck's structures, in order of precedence.
std::vector<Structure> makeAnatomy(const NeckParameters& parameters, std::uint32_t seed);

/// Returns the internal jugular vein at a level: lateral and posterior position of its center (mm), half width, half
/// height, rotation (degrees).
std::array<double, 5> jugularVeinAt(const NeckParameters& parameters, Side side, double z_mm);

/// Returns the named vessels.
std::vector<VesselCourse> vesselCourses(const NeckParameters& parameters, const BodySurface& body);

/// Returns the front of the vertebral bodies: model y at level z.
double vertebralFront_mm(double z_mm);
/// Returns the center of the airway (larynx, then trachea): model y at level z.
double airwayCenter_mm(double z_mm);
/// Returns the course of the subclavian vein from its confluence to the axillary vein, below the clavicle; the artery
/// (axillaryArtery) lies behind and above it. Dimensions after Galloway and Bodenham, Br J Anaesth 2003;90:589. Below
/// the middle of the clavicle, the vein is 12 mm wide and begins 19 mm below the skin; the artery is 3 mm and the rib
/// cage 10 mm away. 40 mm farther lateral, the vein is 9 mm wide and 31 mm deep, the artery is 8 mm and the rib cage 20
/// mm away.
std::vector<Tube::Knot> axillaryVein();
/// Distance from the midline at which the vessels pass the outer border of the first rib and are called axillary.
inline constexpr double kFirstRib_mm = 74;
std::vector<Tube::Knot> axillaryArtery();

// Parts of makeAnatomy(); each appends the structures of one region.
void addSpine(std::vector<Structure>& into, std::uint32_t seed);
void addGirdle(std::vector<Structure>& into, const NeckParameters& parameters, std::uint32_t seed);
void addAirway(std::vector<Structure>& into, std::uint32_t seed);
void addVessels(std::vector<Structure>& into, const NeckParameters& parameters, std::uint32_t seed);
void addNervesAndGlands(std::vector<Structure>& into, const NeckParameters& parameters, std::uint32_t seed);
void addMuscles(std::vector<Structure>& into, const NeckParameters& parameters, std::uint32_t seed);
void addChestMuscles(std::vector<Structure>& into, std::uint32_t seed);
/// Returns the continuations of the first and second ribs, and the third rib.
std::vector<Shape> chestRibs(Side side, std::uint32_t seed);
Column chestLung();

}  // namespace insonate::phantom
