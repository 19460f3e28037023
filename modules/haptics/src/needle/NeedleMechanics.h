#pragma once

#include "needle/ShaftTissue.h"
#include "needle/Springs.h"

#include <insonate/haptics/LocalModel.h>
#include <insonate/haptics/NeedleState.h>
#include <insonate/tissue/NeedleTable.h>

#include <array>

namespace insonate::haptics {

/// Events of one tick; events that do not fit are counted as lost.
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
  Vec3 viscous_N;  ///< the part of force_N that depends on speed
};

/// A needle in tissue: punctured walls and resistance. State and force are computed along the path of the tip in steps
/// of a quarter of a millimeter, so that no wall is missed at high speed or at a thin vessel. Everything is stored in
/// coordinates of tissue at rest.
class NeedleMechanics {
 public:
  /// `steepest_Npmm`: maximum stiffness that the device can render; each spring stays below its share of it.
  void configure(const NeedleTable& table, double steepest_Npmm);
  /// Removes the needle, and reports its withdrawal from every wall that it had punctured, as move() does.
  void remove(std::int64_t time_ns, NeedleEvents& events) noexcept;

  /// Moves the tip to `tip_mm`; the needle points along the unit vector `axis` (patient space). `step_s`: time since
  /// the last call. A jump of more than 15 mm cannot be a motion of a hand: the needle is then removed and placed anew.
  NeedleForce move(const TissueGrid& grid, const Transform& restFromPatient, Vec3 tip_mm, Vec3 axis, double step_s,
                   std::int64_t time_ns, NeedleEvents& events) noexcept;

  const NeedleState& state() const { return state_; }
  /// Distance by which an image should draw the tip back against the needle's direction, so that no needle is shown
  /// inside bone.
  double drawnBack_mm() const { return onBone_.active ? onBone_.depth_mm : 0; }

 private:
  /// Contact of the tip with a wall that it has not punctured.
  struct Contact {
    bool active = false;
    bool slides = false;    ///< the angle to the wall is too flat for a puncture
    bool inwards = true;    ///< true: into the structure; false: out of it
    Vec3 point, direction;  ///< point of contact with the wall, and direction of pushing
    Vec3 normal;            ///< normal of the wall, in the direction of the tip's motion
    double depth_mm = 0, force_N = 0;
    Vec3 aside_mm;  ///< displacement of the tip perpendicular to its direction: the tip drags the skin along before it
                    ///< slips
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
  Label around_ = kSoftTissue;  ///< last tissue without a wall of its own that the tip was in
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
