#pragma once

#include <insonate/core/Transform.h>
#include <insonate/views/Theme.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace insonate::views {

/// A closed surface in patient LPS mm: x, y, z of each point; unit normals pointing outward, or none; three point
/// numbers a triangle.
struct Surface {
  std::span<const float> points_mm, normals;
  std::span<const std::uint32_t> triangles;
};

/// A line through the scene, patient LPS; of less than two points nothing is seen.
struct ScenePath {
  std::vector<Vec3> points_mm;
  Colour colour = theme::kText;
};

/// Side of the patient that the camera sees.
enum class Viewpoint { Anterior, Posterior, Left, Right, Superior, Inferior };

/// LeftEye and RightEye show the image of one eye alone. QuadBuffer needs a window that was made for shutter glasses.
enum class Stereo { Off, Anaglyph, SideBySide, Interlaced, Checkerboard, LeftEye, RightEye, QuadBuffer };

/// Clipping plane; keeps the side that the normal points to. Patient LPS mm.
struct ClippingPlane {
  Vec3 point_mm, normal{0, 0, 1};
};

enum class ClippingKind { Off, Axial, Coronal, Sagittal, ImagePlane, Free };

/// Clipping plane of a scene. Its normal is toward the patient's head (axial), back (coronal) or left (sagittal),
/// along the probe's elevation (image plane: the plane moves with the probe), or `direction` (free); the side that it
/// points to is kept.
struct Clipping {
  ClippingKind kind = ClippingKind::Off;
  double offset_mm = 0;  ///< along the normal; from the middle of the CT, or from the image plane
  bool flipped = false;  ///< keeps the other side
  Vec3 direction{0, 0, 1};
  bool operator==(const Clipping&) const = default;
};

/// A physical screen standing in the patient's space, and the eye before it: head-coupled view. Screen frame:
/// millimeters, origin at the middle of what the view fills of the screen, x right, y up, z toward the viewer.
struct HeadCoupling {
  /// Rigid, or scaled to show the patient larger or smaller. None: the screen stands at the default camera's focal
  /// point, perpendicular to its direction, as large as that camera's view there; so turning, panning and zooming
  /// still work.
  std::optional<Transform> patientFromScreen;
  double width_mm = 520;
  double height_mm = 0;         ///< 0 for the view's own shape
  Vec3 eye_mm{0, 0, 600};       ///< between the eyes; z above 1
  double eyeSeparation_mm = 0;  ///< along the screen's x; used in stereo
  bool operator==(const HeadCoupling&) const = default;
};

struct ScenePick {
  Vec3 position_mm;  ///< patient LPS
  std::uint8_t label = 0;
};

}  // namespace insonate::views
