#pragma once

#include "needle/ShaftTissue.h"
#include "needle/Springs.h"

#include <insonate/haptics/LocalModel.h>
#include <insonate/haptics/NeedleState.h>
#include <insonate/tissue/NeedleTable.h>

#include <array>

namespace insonate::haptics {

/// Needle events (punctures, contacts) of one tick of the force loop; events that do not fit are counted as lost.
struct NeedleEvents {
  std::array<NeedleEvent, 16> list{};
  int count = 0, lost = 0;
  void add(const NeedleEvent& event) {
    if (count < static_cast<int>(list.size()))
      list[count++] = event;
    else
      ++lost;
  }
};

/// Force on the needle in patient space, with the torque about its tip.
struct NeedleForce {
  Vec3 force_N;
  Vec3 torque_Nmm;
  Vec3 viscous_N;  ///< part of force_N that depends on speed (viscous friction)
};

/// Mechanics of a needle in tissue: which walls (surfaces of structures) the needle has punctured, and the resistance
/// of the tissue. Both are computed along the path of the tip in steps of a quarter of a millimeter, so that no wall is
/// missed at high speed or at a thin vessel. Positions are stored in undeformed tissue.
class NeedleMechanics {
 public:
  /// Sets the needle's table of forces. `steepest_Npmm`: maximum stiffness that the haptic device can render; the
  /// stiffness of each spring is limited to a fraction of this maximum.
  void configure(const NeedleTable& table, double steepest_Npmm);
  /// Removes the needle from the tissue, and adds a Withdrawn event for every wall that it had punctured.
  void remove(std::int64_t time_ns, NeedleEvents& events) noexcept;

  /// Moves the tip to `tip_mm`; the needle points along the unit vector `axis` (patient space). `step_s`: time since
  /// the last call. After a jump of more than 15 mm, which no hand makes, the needle is removed and placed anew.
  NeedleForce move(const TissueGrid& grid, const Transform& restFromPatient, Vec3 tip_mm, Vec3 axis, double step_s,
                   std::int64_t time_ns, NeedleEvents& events) noexcept;

  const NeedleState& state() const { return state_; }
  /// Returns the distance by which the displayed tip must be drawn back along the needle, so that it is not shown
  /// inside bone.
  double drawnBack_mm() const { return onBone_.active ? onBone_.depth_mm : 0; }

 private:
  /// Contact of the tip with a wall (surface of a structure) that it has not punctured.
  struct Contact {
    bool active = false;
    bool slides = false;    ///< true: the angle to the wall is too flat for a puncture
    bool inwards = true;    ///< true: the tip moves into the structure; false: the tip moves out of the structure
    Vec3 point, direction;  ///< first point of contact with the wall, and direction in which the tip pushes
    Vec3 normal;            ///< unit normal of the wall, on the side toward which the tip moves
    double depth_mm = 0, force_N = 0;
    /// Displacement of the tip perpendicular to its direction, by which the tip drags the skin sideways before the tip
    /// slips.
    Vec3 aside_mm;
  };
  struct Hole {
    int wall = 0;
    bool inwards = true;
    Vec3 point;
  };

  void place(const TissueGrid& grid, Vec3 tip, Vec3 axis);
  void step(const TissueGrid& grid, Vec3 tip, Vec3 axis, NeedleEvents& events);
  void withdraw(Vec3 tip, NeedleEvents& events);
  void closeHole(NeedleEvents& events);
  void touch(const TissueGrid& grid, const TissueSample& sample, int wall, Vec3 tip, Vec3 axis, NeedleEvents& events);
  void meet(const TissueGrid& grid, const TissueSample& sample, int wall, Vec3 tip, Vec3 axis, NeedleEvents& events);
  void follow(const TissueGrid& grid, const TissueSample& sample, int wall, Vec3 tip, Vec3 axis);
  void puncture(int wall, Vec3 tip, Vec3 axis, NeedleEvents& events);
  void tell(NeedleEventKind kind, int wall, double depth_mm, NeedleEvents& events);
  bool acts(int wall) const;
  Label tissueOf(const TissueSample& sample) const;
  void track(const TissueSample& sample, Vec3 tip, Vec3 axis);
  NeedleForce resist(Vec3 axis, double speed_mmps);
  Vec3 along(Vec3 axis, double speed_mmps, NeedleForce& force);
  void aside(Vec3 axis, NeedleForce& force);

  NeedleTable table_;
  double steepest_Npmm_ = 1;
  NeedleState state_;
  bool placed_ = false;
  Vec3 tip_, before_;
  Vec3 patientTip_, patientAxis_;
  std::int64_t time_ns_ = 0;
  TissueSample sample_;
  Label around_ = kSoftTissue;  ///< last tissue without a wall (not in kNeedleWalls) in which the tip was
  std::array<bool, kNeedleWallCount> inside_{};
  std::array<Contact, kNeedleWallCount> contacts_{};
  Contact onBone_;
  std::array<Hole, 32> holes_{};
  int holeCount_ = 0;
  ShaftTissue shaft_;
  CutFront cut_;
  StickSlip friction_;
  double speed_mmps_ = 0;
};

}  // namespace insonate::haptics
