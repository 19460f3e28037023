#pragma once

#include "../overlay/ImageQuad.h"
#include "../overlay/Lines.h"
#include "../overlay/Texts.h"
#include "../ultrasound/FanOutline.h"
#include "FanMask.h"
#include "SliceSampler.h"

#include <insonate/views/MprView.h>

namespace insonate::views {

/// Contents of the drawing over a slice.
struct MprOverlay {
  SliceKind kind = SliceKind::Axial;
  std::optional<Vec3> crosshair_mm;
  std::optional<Vec3> pointer_mm;
  std::vector<DisplayPoint> fan;                  ///< outline of the field of view, a closed polygon
  std::string slice;                              ///< kind and number of the slice, e.g. "axial 42 / 120"
  std::vector<std::pair<int, Caliper>> calipers;  ///< number, and the caliper in the slice's plane
  std::vector<std::pair<int, Vec3>> marks_mm;     ///< number and position of each marked point
  const SliceMarks* toolMarks = nullptr;          ///< marks of the selected tool
  std::vector<const NamedPoint*> places;          ///< places near the slice
  WindowLevel windowLevel;
};

void drawMprOverlay(const MprOverlay& overlay, const SlicePlane& plane, double scale, Lines& lines, Texts& texts);

/// Returns the largest length up to `longest_mm` that is 1, 2 or 5 times a power of ten.
double roundLength_mm(double longest_mm);

struct MprView::Drawing {
  explicit Drawing(vtkRenderer& renderer) : quad(renderer, 3, false), lines(renderer), texts(renderer) {}

  ImageQuad quad;
  Lines lines;
  Texts texts;
  SliceSampler sampler;
  FanMask mask;
  std::vector<PlanePoint> fan;
  SlicePlane sampled;               ///< the plane that `quad` shows
  std::uint64_t sampledLabels = 0;  ///< revision of the labels that `quad` shows
  bool paintStale = true;           ///< true: colors, window or case have changed since `quad` was sampled
};

}  // namespace insonate::views
