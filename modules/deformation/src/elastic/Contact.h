#pragma once

#include "elastic/Elements.h"

#include <insonate/deformation/FaceProfile.h>

#include <vector>

namespace insonate::elastic {

/// The face pushes the mesh's top nodes: a stiff one-sided spring along z, by the length that a node stands for.
class Contact {
 public:
  static constexpr float kStiffness_kPa_mm = 1500;

  void prepare(const Nodes& rest, int columns);
  /// Samples the face's profile at the nodes' present x; the samples are kept while the nodes slide along. If the same
  /// mesh is met again, moves half way there: at the rounded ends of the face strongly pressed skin slides to and fro.
  /// Columns that touched at the end of the last solution count as touching in the first round; otherwise the skin
  /// would spring back between two images whenever the face retreats.
  void meet(const FaceProfile& face, const Nodes& at);
  /// Stores which columns touch, for the next meet().
  void remember(float shift_mm, const Nodes& at);
  void forget() {
    touched_.clear();
    met_.clear();
  }
  /// Begins the next round: columns that came off are released.
  void settle();

  /// Adds spring and push to the top row; the face is `shift_mm` further in. With `sticking`, nodes that touch keep
  /// the x of their first contact: that at rest for those that touch in the first round.
  void add(float shift_mm, bool sticking, const Nodes& at, GridMatrix& matrix, std::vector<float>& force);

  /// kPa mm: on the face along z, a millimeter of footprint.
  float pressing(float shift_mm, const Nodes& at) const;
  /// The same for the columns that touched in the last add(), as the linear system predicted. Columns that a step has
  /// just pushed a little into the face or off it, which so stiff a spring would exaggerate, enter with the next
  /// round.
  float foreseen(float shift_mm, const Nodes& at) const;

  /// Derivative of add()'s push by the shift, as a right-hand side.
  void pushByShift(float shift_mm, const Nodes& at, std::vector<float>& force) const;
  /// Sum of the top row's z entries.
  float sum(const std::vector<float>& force) const;
  float product(const std::vector<float>& a, const std::vector<float>& b) const;
  /// Distance of the face from touching.
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
