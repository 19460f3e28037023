#pragma once

#include "Shapes.h"

#include <string>
#include <string_view>
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
  bool chest = false;  ///< true: adds the structures below the clavicles, down to 100 mm below the cricoid
};

/// Kind of a structure, which determines how it meets its neighbors. Organs take their space in the order of the list;
/// muscles share the remaining space and are separated by fascia.
enum class Kind { kOrgan, kArtery, kVein, kMuscle };

struct Structure {
  Label label = kSoftTissue;
  Kind kind = Kind::kOrgan;
  double sheath_mm = 0;  ///< width of the layer around the structure that remains soft tissue
  Shape shape;
};

/// Returns the neck's structures, in order of precedence.
std::vector<Structure> makeAnatomy(const NeckParameters& parameters, std::uint32_t seed);

/// Returns the internal jugular vein at a level: lateral and posterior position of its center (mm), half width, half
/// height, rotation (degrees).
std::array<double, 5> jugularVeinAt(const NeckParameters& parameters, Side side, double z_mm);

/// A named vessel, e.g. "left vertebral artery", with its center line in the model frame, mm.
struct VesselCourse {
  std::string name;
  Label label = kVein;
  std::vector<Tube::Knot> line;
};
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
