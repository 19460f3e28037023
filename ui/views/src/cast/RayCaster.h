#pragma once

#include "CastVolume.h"

#include <insonate/views/SceneOptions.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::views {

/// Origins and ends of rays.
struct CastView {
  /// Row by row; from what OpenGL calls normalised device coordinates, -1..1.
  std::array<double, 16> patientFromSeen{};
  std::array<Vec3, 3> patientFromCamera{};  ///< right, up and toward the viewer
  std::optional<ClippingPlane> clipping;
  int width = 0, height = 0;  ///< of `depth`
  /// Depth of what is drawn already: 0 at the near plane, 1 at the far one; from below, as OpenGL counts.
  std::vector<float> depth;

  bool operator==(const CastView& other) const;
};

/// Constant description of a frame.
struct CastTask {
  std::shared_ptr<const CastLook> look;
  CastView view;
  int across = 0, up = 0;  ///< rays
  bool coarse = false;     ///< through the copy of few voxels

  /// Tells whether it shows the same, with any number of rays.
  bool showsAs(const CastTask& other) const { return look == other.look && view == other.view; }
};

/// Casts a task's rays, row by row; rows may be cast on several threads at once. Light comes as in the scene.
class RayCaster {
 public:
  /// The task outlives the caster.
  explicit RayCaster(const CastTask& task);

  /// Red, green, blue and opacity of each ray in row 0..up-1 from below, colors multiplied by opacity.
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
  std::array<Vec3, 2> light_;  ///< unit, patient space, toward the lamp
  Mat3 normal_;                ///< gradients in the grid to those in patient space
};

/// All rows on the caller's thread and TBB's.
void castAll(const CastTask& task, std::vector<std::uint8_t>& rgba);

}  // namespace insonate::views
