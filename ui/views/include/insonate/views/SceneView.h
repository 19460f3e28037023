#pragma once

#include <insonate/ultrasound/Frames.h>
#include <insonate/ultrasound/ImagingSettings.h>
#include <insonate/views/SceneOptions.h>
#include <insonate/views/Theme.h>
#include <insonate/views/TransferFunction.h>
#include <insonate/views/View.h>
#include <insonate/views/VtkCase.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkCamera;

namespace insonate::views {

/// A view of patient, probe and image plane in 3D. World coordinates are patient LPS in mm. Left drag turns the view,
/// middle drag (or left drag with Shift) pans, right drag and wheel zoom, R returns to the view from the front.
class SceneView final : public View {
 public:
  SceneView();
  ~SceneView() override;

  /// Sets the case for CT rendering and picking; may be null.
  void setCase(std::shared_ptr<const VtkCase> patient);

  /// Copies the surface of a label; an empty surface removes it. Color and opacity do not change; initially the color
  /// is the one in the label table, and all surfaces except the skin are opaque. `coarse` is a simplified surface that
  /// is drawn during movement. If `coarse` is empty, a simplified surface is computed for surfaces with more than 12
  /// 000 triangles.
  void setSurface(std::uint8_t label, const Surface& surface, const Surface& coarse = {});
  void setColor(std::uint8_t label, Color color);
  void setOpacity(std::uint8_t label, double opacity);
  void setVisible(std::uint8_t label, bool visible);
  void setSkinOpacity(double opacity);
  /// Returns the labels that have a surface, in increasing order.
  std::vector<std::uint8_t> structures() const;
  Color color(std::uint8_t label) const;
  double opacity(std::uint8_t label) const;
  bool isVisible(std::uint8_t label) const;
  /// Sets a listener that is called after a surface was added or removed, and after the color, opacity or visibility of
  /// a surface has changed.
  void setStructuresChanged(std::function<void()> listener);

  /// Shows or hides the volume-rendered CT. Has no effect without a case. Initially, the CT is hidden and has the
  /// transfer function for bone.
  void setCtVisible(bool visible);
  bool isCtVisible() const;
  /// Sets the transfer function, corrected by sortedAndClamped().
  void setTransferFunction(const TransferFunction& function);
  const TransferFunction& transferFunction() const;

  void setClipping(const Clipping& clipping);
  const Clipping& clipping() const;
  /// Returns the present clipping plane; empty if nothing is clipped, for example if the clipping plane is the image
  /// plane and there is no probe.
  std::optional<ClippingPlane> clippingPlane() const;
  /// Returns the maximum of Clipping::offset_mm at which a plane of this kind intersects the CT or, without a CT, the
  /// surfaces.
  double maxClippingOffset_mm(const Clipping& clipping) const;

  /// Sets the probe, which determines the shapes of transducer and image plane; empty hides both.
  void setProbe(std::optional<Probe> probe, const ImagingSettings& settings = {});
  void setProbePose(const Transform& patientFromProbe);
  void setProbeVisible(bool visible);
  void setImagePlaneVisible(bool visible);
  /// Copies the live image of the present probe; only its field of view is shown.
  void setImage(const BModeImage& image);

  /// A straight steel needle with its hub, at true size. Its frame has its origin at the tip and z along the shaft in
  /// the direction of insertion; the bevel faces -y.
  struct Needle {
    Transform patientFromNeedle;
    double length_mm = 70, diameter_mm = 1.27;  ///< length and diameter of the shaft; defaults: 18 G
    Color color = theme::kText;                 ///< color of the shaft
  };
  void setNeedle(std::optional<Needle> needle);
  const std::optional<Needle>& needle() const;

  /// Sets the pose of a tray with a new needle; empty: no tray. The tray's frame has its origin at the center of the
  /// floor, x along the tray, z up.
  void setTray(const std::optional<Transform>& patientFromTray);
  static constexpr Vec3 kTray_mm{120, 40, 10};

  /// Sets lines, for example the path of a needle's tip. They replace all earlier lines.
  void setPaths(std::vector<ScenePath> paths);

  /// Places the camera so that it sees all surfaces from this side of the patient. Hidden surfaces are included, so
  /// that hiding a surface does not affect the camera.
  void setViewpoint(Viewpoint from);
  /// Turns the view about the focal point, in degrees to the right and up.
  void orbit(double across_deg, double up_deg);
  void pan(double across_px, double down_px);
  void zoom(double factor);

  /// Sets whether the scene moves. A moving scene is drawn at a lower resolution if necessary for a sufficient frame
  /// rate. The view calls this function itself during a drag.
  void setMoving(bool moving);
  bool isMoving() const;
  /// Tells whether the last frame has its full resolution. Without a graphics card, a CT at rest is first drawn with
  /// few rays. A background thread then casts all rays; when they can be rendered, the listener of setWakeListener() is
  /// called.
  bool isExact() const;
  /// Renders a scene at rest until isExact() is true or `patience_s` has passed; for saved images, not for the window.
  /// Returns isExact().
  bool renderExactly(double patience_s = 60);

  void setStereo(Stereo stereo);
  Stereo stereo() const;
  /// Tells whether the window can show this stereo mode; without a window, true for all modes except QuadBuffer.
  bool supports(Stereo stereo);
  /// Sets a head-coupled view in place of the default camera, whose state is kept. An empty value, or an eye closer
  /// than 1 mm to the screen, restores the default camera. The function is fast enough to be called for every message
  /// of a head tracker.
  void setHeadCoupling(std::optional<HeadCoupling> coupling);
  const std::optional<HeadCoupling>& headCoupling() const;
  /// Returns the direction toward the viewer, patient space: the normal of a plane that faces the viewer.
  Vec3 viewerDirection() const;

  /// Returns the first voxel on the line of sight through a display point whose label is visible and has at least this
  /// opacity. Does not render.
  std::optional<ScenePick> pick(DisplayPoint at, double minOpacity = 0);
  DisplayPoint displayFromPatient(Vec3 point_mm);
  /// Returns a point on the line of sight through a display point, in front of everything that is drawn. Use it for
  /// lines over the scene.
  Vec3 pointInFrontOf(DisplayPoint at);
  /// Returns the position of the viewer's eye, patient space.
  Vec3 eye_mm();

  /// Returns the duration of VTK's last rendering, in seconds.
  double renderTime_s() const;
  /// Returns the name of the renderer according to OpenGL; empty before the first frame.
  std::string rendererName() const;

  /// Returns true: the state of this view is plain data that is copied for each frame.
  bool canDrawOnThread() const override { return true; }

  bool pressed(const Pointer& pointer) override;
  bool moved(const Pointer& pointer) override;
  bool released(const Pointer& pointer) override;
  bool wheel(const Pointer& pointer, double notches) override;
  bool key(Key key) override;
  void inputIdle() override;

 protected:
  void layout() override;
  bool isStale() const override;
  void publishState() override;
  void adoptState() override;
  void draw() override;
  void attached(vtkRenderWindow& window) override;
  void detached(vtkRenderWindow& window) override;

 private:
  struct Drawing;
  void frame();
  vtkCamera& aimed();
  /// Returns the point on the line of sight through a display point at this depth, from -1 (near plane) to 1 (far
  /// plane).
  Vec3 along(DisplayPoint at, double depth);
  void clip();
  void structuresChanged();

  std::unique_ptr<Drawing> drawing_;
};

}  // namespace insonate::views
