#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/deformation/TissuePlane.h>
#include <insonate/image/PlaneDisplacement.h>
#include <insonate/tissue/MechanicalTable.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// The probe's face in the image plane. The middle of the face is at z = 0, with the tissue at larger z; the ends of
/// the face are rounded.
struct ProbeFace {
  double width_mm = 38;      ///< along the chord of a curved face
  double radius_mm = 0;      ///< of a curved face; 0 is flat
  double footprint_mm = 10;  ///< width of the housing across the image plane; a force in N is spread over it
  bool sticking = false;     ///< tissue under the face does not slide along it
};

/// Present blood pressure, kPa above atmospheric. The CT shows the vessels under MechanicalTissue::pressure_kPa.
struct BloodPressure {
  double artery_kPa = 0, vein_kPa = 0;
};

/// Input of one solution: tissue, face and pressures.
struct DeformationInput {
  const TissuePlane* plane = nullptr;
  ProbeFace face;
  BloodPressure pressure;
  /// Pose of the tissue plane in the patient. The model uses it to start from the last solution after the probe has
  /// moved. Without it, every solution starts from rest.
  std::optional<Transform> patientFromProbe;
  /// Force of the face. If above 0, the face is moved along z until it presses with this force; else it stays at z = 0.
  double force_N = 0;
};

struct LumenArea {
  std::uint8_t label = 0;
  double area_mm2 = 0, rest_mm2 = 0;  ///< area in the plane, now and in the CT
};

/// A node of the model's mesh, for display.
struct MeshNode {
  float restX_mm = 0, restZ_mm = 0, x_mm = 0, z_mm = 0;
};

/// Result of one solution.
struct Deformation {
  PlaneDisplacement displacement;
  double force_N = 0;             ///< force of the tissue on the face
  double faceShift_mm = 0;        ///< distance by which the face was moved along z to reach the required force
  std::vector<LumenArea> lumens;  ///< one for each vessel label in the plane
  int iterations = 0;             ///< iterations of the solver
  bool converged = true;          ///< the solution is within the model's tolerance
  bool moved = false;             ///< false if nothing was solved: no contact, blood pressure as in the CT

  int meshColumns = 0, meshRows = 0;
  std::vector<MeshNode> mesh;       ///< [row][column]
  std::vector<float> pressure_kPa;  ///< of each cell of the mesh, (columns-1) x (rows-1); above 0 under compression
};

/// Resolution of a model, and depth of the part of the plane that it covers.
struct DeformationSettings {
  double mesh_mm = 0.5;     ///< edge of the cells near vessels and face; 0.1..4
  double depth_mm = 50;     ///< depth below the face at which tissue does not move; 10..200
  int mostIterations = 60;  ///< maximum per solution; live images use few, and the next image continues
  double tolerance_mm = 0;  ///< 0 for the model's default
  /// If above 0: while the probe moves, a solution is accepted once its step is shorter than this; the next image
  /// continues from it.
  double enough_mm = 0;
};

/// Computes the displacement of tissue from the contact of the probe. One object must not be used concurrently.
class DeformationModel {
 public:
  virtual ~DeformationModel() = default;
  virtual std::string_view name() const = 0;

  /// Computes a solution. Allocates nothing once `answer` has its sizes and the mesh is not larger than before. The
  /// result is always finite and one-to-one; `converged` tells whether it is within tolerance.
  virtual void solve(const DeformationInput& input, Deformation& answer) = 0;

  /// Discards the last solution, so that the next solution starts from rest.
  virtual void reset() = 0;
};

/// Returns the names of the models: `elastic` (the default), `column`, `reference`.
std::vector<std::string> deformationModelNames();
Result<std::unique_ptr<DeformationModel>> makeDeformationModel(std::string_view name, const MechanicalTable& tissues,
                                                               const DeformationSettings& settings = {});

}  // namespace insonate
