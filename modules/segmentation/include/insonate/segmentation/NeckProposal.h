#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/CenterLine.h>
#include <insonate/segmentation/Region.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Structures that proposeNeck() finds. The sides are the patient's.
enum class NeckStructure {
  RightCarotid,
  LeftCarotid,
  RightJugular,
  LeftJugular,
  Thyroid,
  RightSternocleidomastoid,
  LeftSternocleidomastoid
};
inline constexpr std::size_t kNeckStructures = 7, kNeckVessels = 4;  ///< the vessels are the first structures

/// Returns the structure's name, e.g. "right internal jugular vein"; vessels are named as in simulator/VesselNaming.h.
std::string_view nameOf(NeckStructure structure);
/// Returns the structure's label.
std::uint8_t labelOf(NeckStructure structure);

/// A neck whose structures are known.
struct AtlasNeck {
  struct VesselPoint {
    Vec3 position_mm;
    double radius_mm = 0;
  };
  LabelMap labels;  ///< voxels of 1 to 3 mm on a grid whose axes are the patient's axes
  /// Course of each vessel of NeckStructure, from its lower end upward, patient space of the neck.
  std::array<std::vector<VesselPoint>, kNeckVessels> vessels;
};

/// A structure that was found in a CT.
struct ProposedStructure {
  NeckStructure structure = NeckStructure::Thyroid;
  Selection voxels;  ///< voxels of the structure; empty if it was not found
  CenterLine line;   ///< center line of a vessel, from its lower end upward
  /// Estimated probability that the structure was found at its true place, 0 to 1. Calibrated on built-in necks that
  /// the atlas does not contain; bench/results/segmentation.md compares it with the results.
  double confidence = 0;
  /// The question that settles a low confidence, e.g. "Click the right internal jugular vein in this slice."; empty at
  /// high confidence.
  std::string question;
  Vec3 ask_mm;  ///< the place at which the question should be asked: the slice through it shows the doubtful part
};

/// At least this confidence counts as high: nine of ten structures are right.
inline constexpr double kHighConfidence = 0.9;

/// Proposes the large vessels, the thyroid and the sternocleidomastoids of a neck. The necks of the atlas are fitted to
/// the CT: first linearly by bone, airway, skin and fat, then by a smooth displacement. The necks that fit best predict
/// where each structure lies. A search in the CT around the prediction finds the vessels, and vessel and tube tracking
/// find their walls. Veins and arteries never touch: at least one voxel of other tissue lies between them.
///
/// `automatic` are the labels of autoLabel() for this CT. The order of the result is that of NeckStructure; a structure
/// beyond the CT has no voxels. Fails with a sentence if the CT does not show a neck, or if the atlas is empty; fails
/// when cancelled. The same CT and atlas give the same result on any number of threads.
Result<std::vector<ProposedStructure>> proposeNeck(const CtVolume& ct, const LabelMap& automatic,
                                                   std::span<const AtlasNeck> atlas, const Progress& progress = {});

}  // namespace insonate
