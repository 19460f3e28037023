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

/// Patient, probe and image plane in three dimensions; the world is patient LPS mm. Left drag turns, middle drag (or
/// left with shift) pans, right drag and wheel come nearer, r looks from the front again.
class SceneView final : public View {
 public:
  SceneView();
  ~SceneView() override;

  /// Sets the case for CT rendering and picking; may be null.
  void setCase(std::shared_ptr<const VtkCase> patient);

  /// Copies the surface of a label; an empty one removes it. Color and opacity stay what they are set to (at first the
  /// label table's, opaque but for the skin). `coarse` is drawn while things move; without one, surfaces over 12 000
  /// triangles get one made, which is quick and rough.
  void setSurface(std::uint8_t label, const Surface& surface, const Surface& coarse = {});
  void setColour(std::uint8_t label, Colour colour);
  void setOpacity(std::uint8_t label, double opacity);
  void setVisible(std::uint8_t label, bool visible);
  void setSkinOpacity(double opacity);
  /// Labels that have a surface, rising.
  std::vector<std::uint8_t> structures() const;
  Colour colour(std::uint8_t label) const;
  double opacity(std::uint8_t label) const;
  bool isVisible(std::uint8_t label) const;
  /// Sets a listener that is called after surfaces were added or removed, and after color, opacity or visibility of
  /// one changed.
  void setStructuresChanged(std::function<void()> listener);

  /// The CT itself, ray cast; nothing without a case. At first not visible, and bone.
  void setCtVisible(bool visible);
  bool isCtVisible() const;
  /// Sets the transfer function, tidied().
  void setTransferFunction(const TransferFunction& function);
  const TransferFunction& transferFunction() const;

  void setClipping(const Clipping& clipping);
  const Clipping& clipping() const;
  /// Present clipping plane; none if nothing is clipped, for example along an image plane without a probe.
  std::optional<ClippingPlane> clippingPlane() const;
  /// Distance from the middle at which a plane of this kind still meets the CT (or without one the surfaces), in mm.
  double clippingReach_mm(const Clipping& clipping) const;

  /// Shape of transducer and image plane. None hides both.
  void setProbe(std::optional<Probe> probe, const ImagingSettings& settings = {});
  void setProbePose(const Transform& patientFromProbe);
  void setProbeVisible(bool visible);
  void setImagePlaneVisible(bool visible);
  /// The live image of the current probe; copied. It shows within the field of view only.
  void setImage(const BModeImage& image);

  /// A straight steel needle with its hub, at true size; none for none. Its frame has its origin at the tip, z along
  /// the shaft the way it goes in; the bevel looks along -y.
  struct Needle {
    Transform patientFromNeedle;
    double length_mm = 70, diameter_mm = 1.27;  ///< of the shaft; 18 G
    Colour colour = theme::kText;               ///< of the shaft
  };
  void setNeedle(std::optional<Needle> needle);

  /// A tray with a new needle; none for none. Its frame has its origin in the middle of the floor, x along the tray and
  /// z up out of it.
  void setTray(const std::optional<Transform>& patientFromTray);
  static constexpr Vec3 kTray_mm{120, 40, 10};

  /// Lines that stay until others are set, e.g. the way that a needle's tip has gone; none for none.
  void setPaths(std::vector<ScenePath> paths);

  /// Looks from this side at all surfaces, hidden ones too, so that hiding one does not move the camera.
  void look(Viewpoint from);
  /// Turns about the focal point, in degrees: to the right and up.
  void orbit(double across_deg, double up_deg);
  void pan(double across_px, double down_px);
  void zoom(double factor);

  /// Sets whether the scene moves: then it is drawn coarser, as far as speed requires; dragging in the view does this
  /// by itself.
  void setMoving(bool moving);
  bool isMoving() const;
  /// Tells whether the last rendering is complete. Without a graphics card, a CT at rest is drawn with few rays first;
  /// all of them are cast in the background, and setWake()'s listener is called when they can be rendered.
  bool isExact() const;
  /// Renders at rest until the image is exact, or for this long; for saved images, not for the live window. False if
  /// it is not exact then.
  bool renderExactly(double patience_s = 60);

  void setStereo(Stereo stereo);
  Stereo stereo() const;
  /// Tells whether the window can show it; without a window, all but QuadBuffer.
  bool supports(Stereo stereo);
  /// Sets an eye for the default camera, which is kept meanwhile; none, or an eye nearer than 1 mm to the screen, ends
  /// the coupling. Cheap enough for every message of a head tracker.
  void setHeadCoupling(std::optional<HeadCoupling> coupling);
  const std::optional<HeadCoupling>& headCoupling() const;
  /// Direction toward the viewer in patient LPS: the normal of a plane that faces the viewer.
  Vec3 towardViewer() const;

  /// The first labeled voxel of the case under a display point that is visible, and as opaque as this; nothing is
  /// rendered for it.
  std::optional<ScenePick> pick(DisplayPoint at, double leastOpacity = 0);
  DisplayPoint displayFromPatient(Vec3 point_mm);
  /// Just before everything that is drawn, under a display point: for lines that are drawn over the scene.
  Vec3 frontOf(DisplayPoint at);
  /// Position of the eye.
  Vec3 eye_mm();

  /// Duration of VTK's last rendering, in seconds.
  double renderTime_s() const;
  /// OpenGL's name of the renderer; empty before the first frame.
  std::string graphics() const;

  /// True: the state is plain data, which is passed on for each image.
  bool canDrawOnThread() const override { return true; }

  bool pressed(const Pointer& pointer) override;
  bool moved(const Pointer& pointer) override;
  bool released(const Pointer& pointer) override;
  bool wheel(const Pointer& pointer, double notches) override;
  bool key(Key key) override;
  void rested() override;

 protected:
  void layout() override;
  bool outOfDate() const override;
  void handOver() override;
  void takeOver() override;
  void draw() override;
  void attached(vtkRenderWindow& window) override;
  void detached(vtkRenderWindow& window) override;

 private:
  struct Drawing;
  void frame();
  vtkCamera& aimed();
  /// Point under a display point, from the near plane (-1) to the far one (1).
  Vec3 along(DisplayPoint at, double depth);
  void clip();
  void structuresChanged();

  std::unique_ptr<Drawing> drawing_;
};

}  // namespace insonate::views
