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

/// The probe's face in its plane, seen from the tissue: z = 0 in its middle,
/// ends rounded off.
struct ProbeFace {
  double width_mm = 38;      ///< along the chord
  double radius_mm = 0;      ///< of a curved face; 0 is flat
  double footprint_mm = 10;  ///< of the housing across the slice: a force in N is spread over it
  bool sticking = false;     ///< tissue under the face does not slide along it
};

/// Blood pressure now, kPa above the air's; where the CT shows the vessels
/// under MechanicalTissue::pressure_kPa.
struct BloodPressure {
  double artery_kPa = 0, vein_kPa = 0;
};

/// One question to a model.
struct DeformationInput {
  const TissuePlane* plane = nullptr;
  ProbeFace face;
  BloodPressure pressure;
  /// Pose of the tissue plane in the patient; it carries the last solution over to this one after the probe has moved.
  /// Without it every question is solved from rest.
  std::optional<Transform> patientFromProbe;
  /// Force of the face, if above 0: the face is moved along z until it presses with it; else it stays at z = 0.
  double force_N = 0;
};

struct LumenArea {
  std::uint8_t label = 0;
  double area_mm2 = 0, rest_mm2 = 0;  ///< in the plane, now and in the CT
};

/// A node of the model's mesh, for showing.
struct MeshNode {
  float restX_mm = 0, restZ_mm = 0, x_mm = 0, z_mm = 0;
};

/// The answer.
struct Deformation {
  PlaneDisplacement displacement;
  double force_N = 0;             ///< with which the tissue presses back on the face
  double faceShift_mm = 0;        ///< how far the face was moved along z for the force
  std::vector<LumenArea> lumens;  ///< one for each vessel label in the plane
  int iterations = 0;             ///< of the solver
  bool converged = true;          ///< to the model's own tolerance
  bool moved = false;             ///< false: nothing touches, nothing pulses, and nothing was solved

  int meshColumns = 0, meshRows = 0;
  std::vector<MeshNode> mesh;       ///< [row][column]
  std::vector<float> pressure_kPa;  ///< of each cell of the mesh, (columns-1) x
                                    ///< (rows-1); above 0 where squeezed
};

/// Resolution of a model, and the part of the plane that it covers.
struct DeformationSettings {
  double mesh_mm = 0.5;     ///< cells near vessels and face; 0.1..4
  double depth_mm = 50;     ///< below the face; the tissue there does not move. 10..200
  int mostIterations = 60;  ///< of one solve; a live image takes few, and goes on with the next
  double tolerance_mm = 0;  ///< 0: the model's own
  /// Step length below which a solution is accepted while the probe moves, if above 0; the next frame continues from
  /// it.
  double enough_mm = 0;
};

/// Contact to displacement. Not for concurrent use of one object.
class DeformationModel {
 public:
  virtual ~DeformationModel() = default;
  virtual std::string_view name() const = 0;

  /// Solves; allocates nothing once `answer` has its sizes and the mesh is not larger than it has been. Always gives an
  /// answer that is finite and one-to-one; `converged` says how good.
  virtual void solve(const DeformationInput& input, Deformation& answer) = 0;

  /// Discards the last solution, so that the next starts from rest.
  virtual void reset() = 0;
};

/// `elastic` (the default), `column`, `reference`.
std::vector<std::string> deformationModelNames();
Result<std::unique_ptr<DeformationModel>> makeDeformationModel(std::string_view name, const MechanicalTable& tissues,
                                                               const DeformationSettings& settings = {});

}  // namespace insonate
