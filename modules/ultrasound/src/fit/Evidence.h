#pragma once

#include "FovModel.h"
#include "Plate.h"

namespace insonate::fit {

/// Agreement of the image with one edge of a model of the field of view, as shares of the edge's length within the
/// image.
struct EdgeEvidence {
  double visible = 0;  ///< share of the edge's whole length that lies within the image
  double seen = 0;     ///< share with light inside and background outside the edge: evidence for the edge
  double against = 0;  ///< share with light outside the edge: evidence against the edge
};

struct Evidence {
  std::array<EdgeEvidence, kEdges> edges;
  double outline = 0;    ///< `seen` minus `against`, over the whole visible outline; -1 to 1
  double agreement = 0;  ///< `seen` divided by the sum of `seen` and `against`
  double cover = 0;   ///< agreement of the model's area with the body (the bright area of the image); dark areas inside
                      ///< count little
  double filled = 0;  ///< share of the model's area within the image that is body (bright)
  double gaps = 0;    ///< share of the body inside the model that is close to background; 1 for letters
  double score() const { return 0.5 * outline + 0.5 * cover; }
};

/// Returns the evidence for the outline of a model minus the evidence against the outline, -1 to 1. The model's area is
/// not used. Fast.
double outlineFor(const FovModel& model, const Plate& plate, double tolerance_px);
/// Computes the evidence in an image for a model. A strip of `tolerance_px` to either side of the outline is ignored.
Evidence evidenceFor(const FovModel& model, const Plate& plate, double tolerance_px);

/// Returns a model whose edges are moved to nearby steps from light to background: robust least squares, in rounds with
/// decreasing `reach_px`. An edge that is not visible in the image stays in place.
FovModel refined(const FovModel& model, const Plate& plate, double reach_px);

}  // namespace insonate::fit
