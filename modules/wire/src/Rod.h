#pragma once

#include "BlockSolver.h"

#include <insonate/wire/VesselTree.h>
#include <insonate/wire/Wire.h>
#include <insonate/wire/WireSolver.h>

#include <Eigen/Geometry>
#include <vector>

namespace insonate::wire {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
using Frame = Eigen::Quaterniond;  ///< columns d1 (toward the bend of the J), d2, d3 (toward the tip)

inline Vector eigen(Vec3 v) {
  return {v.x, v.y, v.z};
}
inline Vec3 vec3(const Vector& v) {
  return {v.x(), v.y(), v.z()};
}

/// The free part of a wire, numbered from the tip: nodes 0 to segments, of which the last is the needle's tip; segment
/// j lies between node j + 1 and node j; frame[segments] is the clamp.
struct Rod {
  int segments = 0;
  std::vector<Vector> node, load_N;  ///< load_N: friction, constant during an equilibrium
  std::vector<Frame> frame;
  std::vector<double> length_mm;  ///< length of each segment at rest

  explicit Rod(int maxSegments);
  void copyFrom(const Rod& other);
};

/// Properties of a wire between its nodes, from the tip.
class RodMaterial {
 public:
  RodMaterial(const Wire& wire, double spacing_mm, int maxSegments);
  double bending_Nmm2(int node) const { return bending_[node]; }
  double restCurvature_1pmm(int node) const { return rest_[node]; }
  double kinkCurvature_1pmm(int node) const { return kink_[node]; }
  int curvedNodes() const { return curved_; }  ///< number of nodes from the tip to the end of the J

 private:
  std::vector<double> bending_, rest_, kink_;  ///< [node], each a mean over the half segments beside the node
  int curved_ = 0;
};

/// Energy of a rod, its gradient and its second derivatives. A variation of segment j is the shift of node j and a
/// rotation vector in the segment's frame.
class RodEnergy {
 public:
  RodEnergy(const VesselTree& tree, const Wire& wire, const WireSettings& settings, const RodMaterial& material)
      : tree_(tree), radius_mm_(wire.diameter_mm / 2), settings_(settings), material_(material) {}
  void setSystem(std::uint8_t label) { system_ = label; }

  double energy(const Rod& rod) const;
  /// Gradient, and second derivatives into the blocks of `equations`.
  void assemble(const Rod& rod, std::vector<BlockVector>& gradient, BlockSolver& equations) const;

  struct Contact {
    double stiffness_Npmm = 0, depth_mm = 0;  ///< depth 0: no contact
    VesselTree::Wall wall{};
  };
  Contact contactAt(const Rod& rod, int node) const;
  /// Force of the first segment on the needle, against the direction of the advance.
  double pushOnNeedle_N(const Rod& rod) const;
  /// Curvature at a node, 1 to `segments`.
  double curvature_1pmm(const Rod& rod, int node) const;

 private:
  struct Bend {
    double length_mm;
    Frame relative;  ///< frame toward the tip in the frame toward the needle
    Vector strain;   ///< curvature and twist less those at rest
    Vector stiffness;
  };
  Bend bendAt(const Rod& rod, int node) const;

  const VesselTree& tree_;
  std::uint8_t system_ = 0;
  double radius_mm_;
  const WireSettings& settings_;
  const RodMaterial& material_;
};

}  // namespace insonate::wire
