#pragma once

#include "FovModel.h"
#include "Plate.h"

namespace insonate::fit {

/// Evidence in the image along one edge of a model, as shares of the edge's length within the image.
struct EdgeEvidence {
  double visible = 0;  ///< share of the edge's whole length
  double seen = 0;     ///< light inside, background outside
  double against = 0;  ///< light outside
};

struct Evidence {
  std::array<EdgeEvidence, kEdges> edges;
  double outline = 0;    ///< `seen` minus `against`, over the whole visible outline; -1..1
  double agreement = 0;  ///< `seen` over `seen` plus `against`
  double cover = 0;      ///< match of the model's area with the body's; dark areas inside count little
  double filled = 0;     ///< share of the model's visible area that is body
  double gaps = 0;       ///< share of the body in the model that is close to background; 1 for letters
  double score() const { return 0.5 * outline + 0.5 * cover; }
};

/// Balance of evidence for and against the outline alone, -1..1. Fast.
double outlineFor(const FovModel& model, const Plate& plate, double tolerance_px);
/// Evidence for a model. A strip of `tolerance_px` to either side of the outline is ignored.
Evidence evidenceFor(const FovModel& model, const Plate& plate, double tolerance_px);

/// Moves the model's edges to nearby steps from light to background: robust least squares, in rounds with decreasing
/// `reach_px`. An edge that is not visible in the image stays in place.
FovModel refined(const FovModel& model, const Plate& plate, double reach_px);

}  // namespace insonate::fit
