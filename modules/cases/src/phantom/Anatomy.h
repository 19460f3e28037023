#pragma once

#include "Shapes.h"

#include <string>
#include <string_view>
#include <vector>

namespace insonate::phantom {

/// Parameters that distinguish one neck from another. Lengths mm; arrays are {right, left}.
struct NeckParameters {
  std::uint32_t seed = 1;  ///< tortuosity of vessels
  double skin_mm = 1.6;
  double girth_mm = 0;  ///< added to the radius of the investing fascia
  Platysma platysma;
  double fat_mm = 4.2;
  double veinWidth[2] = {1.0, 0.82};  ///< scale of the jugular vein's width
  double veinHeight[2] = {1.0, 0.9};  ///< and of its height
  double veinMedial_mm[2] = {0, 0};   ///< jugular vein pushed over the carotid
  double veinForward_mm[2] = {0, 0};
  double carotidScale = 1;
  double carotidLateral_mm = 0;
  double bifurcation_z_mm = 31;   ///< above the cricoid
  double headTurn_deg = 0;        ///< face toward the patient's left, at the top of the model
  double sternomastoidScale = 1;  ///< thickness
  double thyroidScale = 1;
  bool chest = false;  ///< what lies below the clavicles, down to 100 mm below the cricoid
};

/// Rule by which a structure meets its neighbors. Organs claim space in the order of the list; muscles share the rest
/// and are separated by fascia.
enum class Kind { kOrgan, kArtery, kVein, kMuscle };

struct Structure {
  Label label = kSoftTissue;
  Kind kind = Kind::kOrgan;
  double sheath_mm = 0;  ///< soft tissue kept free around it
  Shape shape;
};

/// The neck's structures, in order of precedence.
std::vector<Structure> makeAnatomy(const NeckParameters& parameters, std::uint32_t seed);

/// Centre of the internal jugular vein at a level; lateral, posterior (mm), half width, half height, turn (degrees).
std::array<double, 5> jugularVeinAt(const NeckParameters& parameters, Side side, double z_mm);

/// A vessel that has a name of its own, e.g. "left vertebral artery". Model mm.
struct VesselCourse {
  std::string name;
  Label label = kVein;
  std::vector<Tube::Knot> line;
};
std::vector<VesselCourse> vesselCourses(const NeckParameters& parameters, const BodySurface& body);

/// Front of the vertebral bodies, model y at level z.
double vertebralFront_mm(double z_mm);
/// Centre of the airway (larynx, then trachea), model y at level z.
double airwayCentre_mm(double z_mm);
/// Subclavian vein from its confluence, then axillary vein, below the clavicle; with the artery behind and above it.
/// Depth, width and distances after Galloway and Bodenham, Br J Anaesth 2003;90:589: below the middle of the clavicle
/// the vein is 12 mm wide and begins 19 mm below the skin, the artery is 3 mm away and the rib cage 10; 40 mm to the
/// side these are 9, 31, 8 and 20.
std::vector<Tube::Knot> axillaryVein();
std::vector<Tube::Knot> axillaryArtery();

// The regions that makeAnatomy is composed of; each appends its structures.
void addSpine(std::vector<Structure>& into, std::uint32_t seed);
void addGirdle(std::vector<Structure>& into, const NeckParameters& parameters, std::uint32_t seed);
void addAirway(std::vector<Structure>& into, std::uint32_t seed);
void addVessels(std::vector<Structure>& into, const NeckParameters& parameters, std::uint32_t seed);
void addNervesAndGlands(std::vector<Structure>& into, const NeckParameters& parameters, std::uint32_t seed);
void addMuscles(std::vector<Structure>& into, const NeckParameters& parameters, std::uint32_t seed);
void addChestMuscles(std::vector<Structure>& into, std::uint32_t seed);
/// Continuation of the first and second rib, and the third rib.
std::vector<Shape> chestRibs(Side side, std::uint32_t seed);
Column chestLung();

}  // namespace insonate::phantom
