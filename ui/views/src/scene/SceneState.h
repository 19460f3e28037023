#pragma once

#include <insonate/views/SceneView.h>

#include <array>
#include <memory>
#include <vector>

namespace insonate::views {

/// A label's surface as it was set. The object is constant, and is shared by the threads that describe and draw the
/// scene.
struct SceneShape {
  struct Triangles {
    std::vector<float> points_mm, normals;
    std::vector<std::uint32_t> corners;
    Surface surface() const { return {points_mm, normals, corners}; }
  };
  Triangles fine, coarse;  ///< `coarse` may be empty
  double box[6] = {};      ///< VTK order: x low, x high, ...
};

struct LabelLook {
  Color color{200, 200, 200};
  double opacity = 1;
  bool visible = true;
  bool operator==(const LabelLook&) const = default;
};

struct CameraPlace {
  Vec3 position_mm{0, 0, 1}, focus_mm, up{0, 1, 0};
  double angle_deg = 30;
};

/// State that determines a frame of a scene, as plain data. The window's thread writes the state and passes it to the
/// drawing thread. Large parts are shared. Copying a state into another state of the same case allocates nothing.
struct SceneState {
  int width_px = 1, height_px = 1;
  double scale = 1;
  std::array<std::shared_ptr<const SceneShape>, 256> shapes;
  std::array<LabelLook, 256> looks{};
  std::shared_ptr<const PatientCase> patient;
  TransferFunction transfer = transferPresets().front().function;
  bool ctVisible = false;
  std::optional<ClippingPlane> cut;
  std::optional<Probe> probe;
  ImagingSettings settings;
  Transform patientFromProbe;
  bool probeVisible = true, planeVisible = true;
  BModeImage image;  ///< live image; empty if there is no image of the present probe
  std::optional<SceneView::Needle> needle;
  std::optional<Transform> tray;
  std::shared_ptr<const std::vector<ScenePath>> paths;  ///< lines in space; null: none
  CameraPlace camera;
  Stereo stereo = Stereo::Off;
  std::optional<HeadCoupling> coupling;
  bool moving = false;
  /// Counters of changes, which are compared instead of the data themselves.
  int probeChanges = 0, imageChanges = 0, needleChanges = 0;
};

}  // namespace insonate::views
