#pragma once

#include "elastic/Elements.h"

#include <insonate/deformation/FaceProfile.h>

#include <vector>

namespace insonate::elastic {

/// Contact between the probe's face and the top row of the mesh: each node of the row has a stiff one-sided spring
/// along z, proportional to the length of skin that the node represents.
class Contact {
 public:
  static constexpr float kStiffness_kPa_mm = 1500;

  void prepare(const Nodes& rest, int columns);
  /// Samples the outline of the face at the present x of the top row's nodes. The samples are used until the next
  /// meet(), even if nodes slide. If the same mesh meets the face again, each sampling position moves only half-way to
  /// the node's present x; otherwise, strongly compressed skin under the rounded ends of the face would oscillate.
  /// Columns that touched at the end of the last solution count as touching in the first iteration; otherwise the skin
  /// would spring back between two images whenever the face retreats.
  void meet(const FaceProfile& face, const Nodes& at);
  /// Stores which columns touch the face, for the next meet().
  void remember(float shift_mm, const Nodes& at);
  void forget() {
    touched_.clear();
    met_.clear();
  }
  /// Begins the next iteration: columns that lost contact with the face are released.
  void settle();

  /// Adds the stiffness of the contact springs to `matrix` and their forces to `force`, with the face moved by
  /// `shift_mm` along z. With `sticking`, nodes that touch keep the x of their first contact; nodes that touch in the
  /// first iteration keep their undeformed x.
  void add(float shift_mm, bool sticking, const Nodes& at, GridMatrix& matrix, std::vector<float>& force);

  /// Returns the force on the face along z per millimeter of footprint, kPa mm.
  float pressing(float shift_mm, const Nodes& at) const;
  /// Returns the force on the face along z per millimeter of footprint, kPa mm, from the springs of the last add()
  /// only, as the last Newton step predicted it. Nodes that this step moved slightly into or off the face count only
  /// from the next iteration on, because their stiff springs would exaggerate the change of the force.
  float foreseen(float shift_mm, const Nodes& at) const;

  /// Adds to `force` the derivative of the contact force with respect to the face's shift along z, as a right-hand
  /// side.
  void pushByShift(float shift_mm, const Nodes& at, std::vector<float>& force) const;
  /// Returns the sum of the z components of a nodal vector over the top row.
  float sum(const std::vector<float>& force) const;
  float product(const std::vector<float>& a, const std::vector<float>& b) const;
  /// Returns the minimum distance between face and skin along z.
  float gap(float shift_mm, const Nodes& at) const;

 private:
  int columns_ = 0;
  std::vector<float> length_, met_, restX_, stuckX_;
  std::vector<FaceProfile::Point> profile_;
  std::vector<char> touching_, touched_, added_;
  bool touches(int column, float depth_mm) const {
    return profile_[column].under && (depth_mm > 0 || touching_[column]);
  }
};

}  // namespace insonate::elastic
