#pragma once

#include "CastVolume.h"

#include <insonate/views/SceneOptions.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::views {

/// Geometry of the rays, and the depth of the scene at which each ray ends.
struct CastView {
  /// Row-major matrix from normalized device coordinates (-1 to 1, OpenGL) to the patient.
  std::array<double, 16> patientFromSeen{};
  /// The camera's directions right, up and toward the viewer, in the patient's frame.
  std::array<Vec3, 3> patientFromCamera{};
  std::optional<ClippingPlane> clipping;
  int width = 0, height = 0;  ///< columns and rows of `depth`
  /// Depth of the objects that are already drawn: 0 at the near plane, 1 at the far plane; rows from bottom to top, as
  /// in OpenGL.
  std::vector<float> depth;

  bool operator==(const CastView& other) const;
};

/// Constant description of a frame to cast.
struct CastTask {
  std::shared_ptr<const CastLook> look;
  CastView view;
  int across = 0, up = 0;  ///< number of rays per row, number of rows
  bool coarse = false;     ///< true: rays use the copy of the CT at low resolution

  /// Tells whether both tasks show the same image, whatever their numbers of rays.
  bool showsAs(const CastTask& other) const { return look == other.look && view == other.view; }
};

/// Casts a task's rays, row by row. Several threads may cast rows at the same time. The lamps are those of the scene
/// (SceneLights.h).
class RayCaster {
 public:
  /// The task must outlive the caster.
  explicit RayCaster(const CastTask& task);

  /// Writes red, green, blue and opacity of each ray in this row, 0 to up-1 from the bottom; colors are premultiplied
  /// by opacity.
  void castRow(int row, std::uint8_t* rgba) const;

 private:
  struct Ray;
  std::optional<Ray> ray(double across, double up, float depth) const;
  std::array<float, 4> cast(const Ray& ray) const;
  std::array<float, 3> shade(const CastLook::Entry& entry, const float at[3]) const;
  float sample(float i, float j, float k) const;
  Vec3 patient(double x, double y, double z) const;

  const CastTask& task_;
  const CastGrid& grid_;
  const CastLook::Level& level_;
  std::array<Vec3, 2> light_;  ///< unit vectors toward the lamps, in the patient's frame
  Mat3 normal_;                ///< converts gradients in the grid to gradients in the patient's frame
};

/// Casts all rows on the caller's thread and TBB's threads.
void castAll(const CastTask& task, std::vector<std::uint8_t>& rgba);

}  // namespace insonate::views
