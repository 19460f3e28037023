#pragma once

#include "FovModel.h"
#include "Plate.h"

namespace insonate::fit {

/// Evidence of the image along one edge of a model, as shares of the edge's length within the image.
struct EdgeEvidence {
  double visible = 0;  ///< of the edge's whole length
  double seen = 0;     ///< light inside, ground outside
  double against = 0;  ///< light outside
};

struct Evidence {
  std::array<EdgeEvidence, kEdges> edges;
  double outline = 0;    ///< seen less against, of the whole visible outline; -1..1
  double agreement = 0;  ///< seen over seen and against
  double cover = 0;      ///< how well the model's area is the body's; dark inside counts little
  double filled = 0;     ///< share of the model's visible area that is body
  double gaps = 0;       ///< share of the body in the model with ground close by: of letters, all
  double score() const { return 0.5 * outline + 0.5 * cover; }
};

/// Balance of evidence for and against the outline alone, -1..1. Quick.
double outlineFor(const FovModel& model, const Plate& plate, double tolerance_px);
/// Evidence for a model; `tolerance_px` to either side of the outline are ignored.
Evidence evidenceFor(const FovModel& model, const Plate& plate, double tolerance_px);

/// Moves the model's edges onto the steps from light to ground that lie within some pixels of them: robust least
/// squares, in rounds of narrowing reach. What the image does not show stays where it was.
FovModel refined(const FovModel& model, const Plate& plate, double reach_px);

}  // namespace insonate::fit
