#pragma once

#include <insonate/ultrasound/Frames.h>
#include <insonate/ultrasound/ImagingSettings.h>
#include <insonate/views/Theme.h>
#include <insonate/views/View.h>
#include <insonate/views/VtkCase.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace insonate::views {

/// A closed surface in patient LPS mm: x, y, z of each point; unit normals pointing outward, or none; three point
/// numbers a triangle.
struct Surface {
  std::span<const float> points_mm, normals;
  std::span<const std::uint32_t> triangles;
};

/// Which side of the patient the camera sees.
enum class Viewpoint { Anterior, Posterior, Left, Right, Superior, Inferior };

enum class CtLook { Off, Bone, SoftTissue };

enum class Stereo { Off, Anaglyph, SideBySide, Interlaced, Checkerboard, QuadBuffer };

/// Keeps the side that the normal points to. Patient LPS mm.
struct ClippingPlane {
  Vec3 point_mm, normal{0, 0, 1};
};

/// A physical screen standing in the patient's space, and the eye before it. Screen frame: millimetres, origin at the
/// middle of the screen, x right, y up, z toward the viewer. Rigid, or scaled to show the patient larger or smaller.
struct HeadCoupling {
  Transform patientFromScreen;
  double width_mm = 520, height_mm = 325;
  Vec3 eye_mm{0, 0, 600};       ///< between the eyes, screen frame; z above 0
  double eyeSeparation_mm = 0;  ///< along the screen's x; used in stereo
};

struct ScenePick {
  Vec3 position_mm;  ///< patient LPS
  std::uint8_t label = 0;
};

/// Patient, probe and image plane in three dimensions; the world is patient LPS mm. Left drag turns, middle drag (or
/// left with shift) pans, right drag and wheel come nearer, r looks from the front again.
class SceneView final : public View {
 public:
  SceneView();
  ~SceneView() override;

  /// For CT rendering and picking; may be null.
  void setCase(std::shared_ptr<const VtkCase> patient);

  /// Copies the surface of a label; an empty one removes it. Colour and opacity stay what they are set to (at first the
  /// label table's, opaque but for the skin). `coarse` is drawn while things move; without one, surfaces over 12 000
  /// triangles get one made, which is quick and rough.
  void setSurface(std::uint8_t label, const Surface& surface, const Surface& coarse = {});
  void setColour(std::uint8_t label, Colour colour);
  void setOpacity(std::uint8_t label, double opacity);
  void setVisible(std::uint8_t label, bool visible);
  void setSkinOpacity(double opacity);

  void setCtLook(CtLook look);
  void setClipping(std::optional<ClippingPlane> plane);

  /// Shape of transducer and image plane. None hides both.
  void setProbe(std::optional<Probe> probe, const ImagingSettings& settings = {});
  void setProbePose(const Transform& patientFromProbe);
  void setProbeVisible(bool visible);
  void setImagePlaneVisible(bool visible);
  /// The live picture of the current probe; copied. It shows within the field of view only.
  void setImage(const BModeImage& image);

  /// A straight needle from hub to tip; none for none.
  struct Needle {
    Vec3 hub_mm, tip_mm;
    double diameter_mm = 1.2;
    Colour colour = theme::kText;
  };
  void setNeedle(std::optional<Needle> needle);

  /// Looks from this side at all surfaces, hidden ones too, so that hiding one does not move the camera.
  void look(Viewpoint from);
  /// Turns about what is looked at, in degrees: to the right and up.
  void orbit(double across_deg, double up_deg);
  void pan(double across_px, double down_px);
  void zoom(double factor);

  /// While the scene moves it is drawn coarser; dragging in the view does this by itself.
  void setMoving(bool moving);

  void setStereo(Stereo stereo);
  /// None, or an eye nearer than 1 mm to the screen, for the usual camera, which is kept meanwhile.
  void setHeadCoupling(std::optional<HeadCoupling> coupling);

  /// The first visible labelled voxel of the case under a display point; nothing is rendered for it.
  std::optional<ScenePick> pick(DisplayPoint at);
  DisplayPoint displayFromPatient(Vec3 point_mm);

  bool pressed(const Pointer& pointer) override;
  bool moved(const Pointer& pointer) override;
  bool released(const Pointer& pointer) override;
  bool wheel(const Pointer& pointer, double notches) override;
  bool key(Key key) override;

 protected:
  void layout() override;
  bool outOfDate() const override;
  void attached(vtkRenderWindow& window) override;
  void detached(vtkRenderWindow& window) override;

 private:
  struct Drawing;
  void frame();
  void aim();

  std::unique_ptr<Drawing> drawing_;
};

}  // namespace insonate::views
