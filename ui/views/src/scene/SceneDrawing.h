#pragma once

#include "CtVolumeActor.h"
#include "ImagePlane.h"
#include "MovingDetail.h"
#include "NeedleModel.h"
#include "OrientationCube.h"
#include "ProbeModel.h"
#include "SceneCamera.h"
#include "Structure.h"

#include <vtkCamera.h>

#include <array>
#include <map>

namespace insonate::views {

struct LabelLook {
  Colour colour{200, 200, 200};
  double opacity = 1;
  bool visible = true;
};

struct SceneView::Drawing {
  explicit Drawing(vtkRenderer& renderer) : ct(renderer), plane(renderer), probe(renderer), needle(renderer) {}

  std::map<std::uint8_t, Structure> structures;
  std::array<LabelLook, 256> looks{};
  CtVolumeActor ct;
  ImagePlane plane;
  ProbeModel probe;
  NeedleModel needle;
  OrientationCube cube;
  MovingDetail detail;
  unsigned long startObserver = 0;

  std::shared_ptr<const VtkCase> patient;
  TransferFunction transfer = transferPresets().front().function;
  bool ctVisible = false;
  Clipping clipping;
  std::optional<ClippingPlane> cut;  ///< where the clipping lies now
  std::optional<HeadCoupling> coupling;
  vtkNew<vtkCamera> usual, coupled;
  Stereo stereo = Stereo::Off;
  Transform patientFromProbe;
  std::function<void()> structuresChanged;
  std::optional<bool> software;  ///< known once the CT was drawn
  Viewpoint viewpoint = Viewpoint::Anterior;
  bool hasProbe = false, probeVisible = true, planeVisible = true, moving = false;
  bool framed = false;  ///< the camera has seen something to look at
  Button held = Button::None;
  DisplayPoint last;
};

}  // namespace insonate::views
