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

/// The face of the probe's housing in the image plane, probe frame. The middle of the face is at z = 0; the tissue is
/// at larger z. The ends of the face are rounded; the array may be narrower.
struct ProbeFace {
  double width_mm = 38;  ///< width of the face; along the chord if the face is curved
  double radius_mm = 0;  ///< radius of a curved face; 0 for a flat face
  /// Width of the probe's housing perpendicular to the image plane, over which the force is distributed.
  double footprint_mm = 10;
  bool sticking = false;  ///< true if tissue under the face does not slide along the face
};

/// Present blood pressure above atmospheric pressure. In the CT, the vessels are under MechanicalTissue::pressure_kPa.
struct BloodPressure {
  double artery_kPa = 0, vein_kPa = 0;
};

/// Input of DeformationModel::solve(): tissue, face of the probe and blood pressures.
struct DeformationInput {
  const TissuePlane* plane = nullptr;
  ProbeFace face;
  BloodPressure pressure;
  /// Pose of the tissue plane in the patient. With a pose, the iteration starts from the last solution even after the
  /// probe has moved; without a pose, the iteration starts from undeformed tissue.
  std::optional<Transform> patientFromProbe;
  /// Required contact force. If above 0, the face is moved along z until the contact force has this value; else the
  /// face stays at z = 0.
  double force_N = 0;
};

struct LumenArea {
  std::uint8_t label = 0;
  /// Area of the vessel's lumen in the image plane: area_mm2 at present, rest_mm2 in the CT. The area includes lumens
  /// up to 4 mm beside the face, and at least up to 24 mm from its middle.
  double area_mm2 = 0, rest_mm2 = 0;
};

/// A node of the model's mesh, for display: its undeformed position (restX_mm, restZ_mm) and its present position in
/// the probe frame.
struct MeshNode {
  float restX_mm = 0, restZ_mm = 0, x_mm = 0, z_mm = 0;
};

/// Result of DeformationModel::solve(): displacement, force, lumens and mesh.
struct Deformation {
  PlaneDisplacement displacement;
  double force_N = 0;             ///< contact force of the tissue on the face
  double faceShift_mm = 0;        ///< distance by which the face was moved along z to reach the required force
  std::vector<LumenArea> lumens;  ///< areas of lumens, one entry for each vessel label in the plane
  int iterations = 0;             ///< number of iterations of the solver
  bool converged = true;          ///< true if the solution is within the model's tolerance
  /// false: no solution was necessary, since there is no contact and the blood pressure is that in the CT
  bool moved = false;

  int meshColumns = 0, meshRows = 0;
  std::vector<MeshNode> mesh;  ///< nodes of the mesh, index [row][column]
  /// Pressure in each cell of the mesh, (columns-1) x (rows-1) values; above 0 under compression.
  std::vector<float> pressure_kPa;
};

/// Resolution and tolerances of a model, and the depth to which it computes the tissue.
struct DeformationSettings {
  double mesh_mm = 0.5;  ///< edge of the mesh's cells near vessels and face; 0.1 to 4
  double depth_mm = 50;  ///< depth below the face at which tissue does not move; 10 to 200
  /// maximum number of iterations per solution; live imaging uses a small number and continues the solution with the
  /// next image
  int maxIterations = 60;
  /// Maximum movement of a node in the last iteration of a converged solution; 0: the model's default.
  double tolerance_mm = 0;
  /// Tolerance for a solution that continues an earlier solution, as while the probe moves. The solution is accepted
  /// once an iteration moves no node by more than this tolerance, and the next image continues the solution. 0: not
  /// used.
  double movingTolerance_mm = 0;
};

/// Computes the displacement of tissue by the contact of the probe. One object must not be used concurrently.
class DeformationModel {
 public:
  virtual ~DeformationModel() = default;
  virtual std::string_view name() const = 0;

  /// Computes a solution. Allocates nothing if the vectors of `answer` are large enough and the mesh is not larger than
  /// before. The displacement is always finite and one-to-one; `answer.converged` tells whether the solution is within
  /// tolerance.
  virtual void solve(const DeformationInput& input, Deformation& answer) = 0;

  /// Discards the last solution, so that the next solution starts from rest.
  virtual void reset() = 0;
};

/// Returns the names of the models: `elastic` (the default), `column`, `reference`.
std::vector<std::string> deformationModelNames();
Result<std::unique_ptr<DeformationModel>> makeDeformationModel(std::string_view name, const MechanicalTable& tissues,
                                                               const DeformationSettings& settings = {});

}  // namespace insonate
