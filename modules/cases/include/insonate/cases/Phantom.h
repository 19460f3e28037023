#pragma once

#include <insonate/cases/CtSynthesis.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace insonate {

/// Region of the body that a built-in case shows.
enum class PhantomRegion {
  kNeck,   ///< both sides of the neck from hyoid to manubrium
  kChest,  ///< below the right clavicle
  kArm,    ///< middle third of the right upper arm
  kGroin   ///< right femoral triangle
};

/// A built-in case: a synthetic region of the body.
struct PhantomVariant {
  PhantomRegion region = PhantomRegion::kNeck;
  std::string_view name;        ///< name for the command line, e.g. "small-vein"
  std::string_view title;       ///< title of the case for a list, one line
  std::string_view difficulty;  ///< difficulty of the puncture: "easy", "moderate" or "hard"
  std::string_view description;
};

/// Returns all variants, by region, and in a region easiest first; the first is the default.
std::span<const PhantomVariant> phantomVariants();
/// Returns the variant with this name or title; null if there is none.
const PhantomVariant* phantomVariant(std::string_view nameOrTitle);

/// Builds a case: labels from an analytic model, a CT synthesized from the labels, targets in the veins of the
/// variant's procedure, and start poses from which the targets are found. Uses all cores. The same variant, seed and
/// contrast give identical bytes on any number of threads. Fails on an unknown variant (the error lists the known ones)
/// and when cancelled.
Result<PatientCase> makePhantom(std::string_view variant, std::uint32_t seed, const Progress& progress = {},
                                CtContrast contrast = CtContrast::kNative);

/// Labels of a built-in case on a grid of the caller's choice, and its named vessels.
struct PhantomLabels {
  LabelMap labels;
  std::vector<NamedVessel> vessels;
};

/// Computes the labels of a built-in case at the voxel centers of a grid whose axes are the patient's axes. The labels
/// of the variant's own structures are those of their tissues. Fails like makePhantom(), and on an invalid grid.
Result<PhantomLabels> phantomLabels(std::string_view variant, std::uint32_t seed, const VolumeGeometry& grid,
                                    const Progress& progress = {});

}  // namespace insonate
