#pragma once

#include <insonate/core/Transform.h>
#include <insonate/views/Theme.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace insonate::views {

/// A closed surface in patient space (LPS, mm): x, y, z of each point; unit normals that point outward, or no normals;
/// three point indices for each triangle.
struct Surface {
  std::span<const float> points_mm, normals;
  std::span<const std::uint32_t> triangles;
};

/// A polyline in the scene, patient space (LPS), drawn as a tube. With fewer than two points it is not visible.
struct ScenePath {
  std::vector<Vec3> points_mm;
  Color color = theme::kText;
  double radius_mm = 0.8;  ///< radius of the tube; default: slightly thicker than a needle of 18 G, which lies in it
};

/// Side of the patient that the camera sees.
enum class Viewpoint { Anterior, Posterior, Left, Right, Superior, Inferior };

/// Stereo mode. LeftEye and RightEye show the image of one eye only. QuadBuffer requires a window that was created for
/// shutter glasses.
enum class Stereo { Off, Anaglyph, SideBySide, Interlaced, Checkerboard, LeftEye, RightEye, QuadBuffer };

/// Clipping plane in patient space (LPS, mm); the side to which the normal points stays visible.
struct ClippingPlane {
  Vec3 point_mm, normal{0, 0, 1};
};

enum class ClippingKind { Off, Axial, Coronal, Sagittal, ImagePlane, Free };

/// Settings of a scene's clipping plane. Its normal points toward the patient's head (axial), back (coronal) or left
/// (sagittal), along the probe's elevation (image plane; the plane moves with the probe), or along `direction` (free).
/// The side to which the normal points stays visible.
struct Clipping {
  ClippingKind kind = ClippingKind::Off;
  double offset_mm = 0;  ///< position along the normal, measured from the center of the CT or from the image plane
  bool flipped = false;  ///< true: the other side stays visible
  Vec3 direction{0, 0, 1};
  bool operator==(const Clipping&) const = default;
};

/// Head-coupled view: the physical screen, placed in patient space, and the eye in front of the screen. Screen frame:
/// millimeters, origin at the center of the view's area on the screen, x right, y up, z toward the viewer.
struct HeadCoupling {
  /// Pose of the screen in patient space: rigid, or with a scale to show the patient larger or smaller. Empty: the
  /// center of the screen is the focal point of the default camera; the screen is perpendicular to the camera's
  /// direction and as large as its view at the focal point. Turning, panning and zooming then work as usual.
  std::optional<Transform> patientFromScreen;
  double width_mm = 520;
  double height_mm = 0;    ///< height of the screen area; 0: computed from the width and the aspect ratio of the view
  Vec3 eye_mm{0, 0, 600};  ///< midpoint between the eyes; z above 1
  double eyeSeparation_mm = 0;  ///< distance between the eyes along the screen's x axis, for stereo
  bool operator==(const HeadCoupling&) const = default;
};

struct ScenePick {
  Vec3 position_mm;  ///< patient space (LPS)
  std::uint8_t label = 0;
};

}  // namespace insonate::views
