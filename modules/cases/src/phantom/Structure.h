#pragma once

#include "Shapes.h"

#include <string>
#include <vector>

namespace insonate::phantom {

/// Kind of a structure, which determines how it meets its neighbors. Organs take their space in the order of the list;
/// muscles share the remaining space and are separated by fascia.
enum class Kind { kOrgan, kArtery, kVein, kMuscle };

struct Structure {
  Label label = kSoftTissue;
  Kind kind = Kind::kOrgan;
  double sheath_mm = 0;  ///< width of the layer around the structure that remains soft tissue
  Shape shape;
};

/// A named vessel, e.g. "left vertebral artery", with its center line in the model frame, mm.
struct VesselCourse {
  std::string name;
  Label label = kVein;
  std::vector<Tube::Knot> line;
};

}  // namespace insonate::phantom
