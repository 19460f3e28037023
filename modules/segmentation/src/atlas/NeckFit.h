#pragma once

#include "Registration.h"
#include "VesselSearch.h"

#include <insonate/segmentation/NeckProposal.h>

#include <span>

namespace insonate::segmentation {

/// Returns the median of values, of which there must be at least one.
double medianOf(std::vector<double> values);

/// An atlas neck that was fitted to a CT.
struct FittedNeck {
  const AtlasNeck* neck = nullptr;
  NeckMap map;  ///< from the patient space of the neck to that of the CT
};

/// Fits the necks of an atlas to a CT; returns those that fit best. Empty if none fits.
std::vector<FittedNeck> fittedNecks(const CtVolume& ct, const LabelMap& automatic, std::span<const AtlasNeck> atlas,
                                    Work& work);

/// Returns the expected course of a vessel in the CT: at each level the median of the fitted necks, from the lower end
/// upward. Levels that fewer than half of the necks have, or that the CT does not show, are left out.
std::vector<VesselStation> expectedCourse(const std::vector<FittedNeck>& necks, NeckStructure vessel,
                                          const VolumeGeometry& ct);

/// Share of the fitted necks that have a structure at each point of a coarse grid, for Thyroid and the muscles.
struct StructureShares {
  VolumeGeometry geometry;
  std::array<std::vector<float>, kNeckStructures - kNeckVessels> share;

  /// Returns the interpolated share of a structure at a point in the CT.
  double at(NeckStructure structure, Vec3 patient_mm) const;
};
StructureShares structureShares(const std::vector<FittedNeck>& necks, Work& work);

/// Finds the structures in a CT to which necks were fitted.
std::vector<ProposedStructure> proposalsFrom(const CtVolume& ct, const std::vector<FittedNeck>& necks, Work& work);

}  // namespace insonate::segmentation
