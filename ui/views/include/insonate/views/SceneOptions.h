#pragma once

#include <insonate/core/Transform.h>
#include <insonate/views/Theme.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace insonate::views {

/// A closed surface in the patient's frame (LPS, mm): x, y, z of each point; unit normals that point outward, or no
/// normals; three point indices for each triangle.
struct Surface {
  std::span<const float> points_mm, normals;
  std::span<const std::uint32_t> triangles;
};

/// A polyline in the scene, in the patient's frame (LPS); with less than two points it is not visible.
struct ScenePath {
  std::vector<Vec3> points_mm;
  Colour colour = theme::kText;
};

/// Side of the patient that the camera sees.
enum class Viewpoint { Anterior, Posterior, Left, Right, Superior, Inferior };

/// Stereo mode. LeftEye and RightEye show the image of one eye only. QuadBuffer needs a window created for shutter
/// glasses.
enum class Stereo { Off, Anaglyph, SideBySide, Interlaced, Checkerboard, LeftEye, RightEye, QuadBuffer };

/// Clipping plane in the patient's frame (LPS, mm); the side to which the normal points stays visible.
struct ClippingPlane {
  Vec3 point_mm, normal{0, 0, 1};
};

enum class ClippingKind { Off, Axial, Coronal, Sagittal, ImagePlane, Free };

/// Settings of a scene's clipping plane. Its normal points toward the patient's head (axial), back (coronal) or left
/// (sagittal), along the probe's elevation (image plane; the plane moves with the probe), or along `direction` (free).
/// The side to which the normal points stays visible.
struct Clipping {
  ClippingKind kind = ClippingKind::Off;
  double offset_mm = 0;  ///< along the normal, from the center of the CT or from the image plane
  bool flipped = false;  ///< the other side stays visible
  Vec3 direction{0, 0, 1};
  bool operator==(const Clipping&) const = default;
};

/// Head-coupled view: a physical screen placed in the patient's space, and the eye in front of it. Screen frame:
/// millimeters, origin at the center of the view's area on the screen, x right, y up, z toward the viewer.
struct HeadCoupling {
  /// Pose of the screen: rigid, or scaled to show the patient larger or smaller. Empty: the screen is at the default
  /// camera's focal point, perpendicular to its direction and as large as the camera's view there, so that turning,
  /// panning and zooming still work.
  std::optional<Transform> patientFromScreen;
  double width_mm = 520;
  double height_mm = 0;         ///< 0: as the view's aspect ratio requires
  Vec3 eye_mm{0, 0, 600};       ///< midpoint between the eyes; z above 1
  double eyeSeparation_mm = 0;  ///< along the screen's x; used for stereo
  bool operator==(const HeadCoupling&) const = default;
};

struct ScenePick {
  Vec3 position_mm;  ///< patient's frame (LPS)
  std::uint8_t label = 0;
};

}  // namespace insonate::views
