#pragma once

#include "CoarseImage.h"

#include <optional>

namespace insonate::segmentation {

/// Maps the patient space of an atlas neck to that of a CT: a linear map, and a displacement on the atlas neck's grid.
struct NeckMap {
  Transform linear;
  VolumeGeometry grid;             ///< grid of the displacement; the axes are those of the atlas neck
  std::vector<Vec3> displacement;  ///< added to the linear map, mm, in the CT; empty: none
  double mismatch = 0;             ///< root mean square difference of the two images after the registration

  Vec3 operator()(Vec3 atlas_mm) const;
};

/// Finds the linear map from an atlas neck to a CT, without a start, from translations over the whole CT. Images are
/// coarse (5 mm). Fails (empty) if the CT contains too little of the atlas neck.
std::optional<NeckMap> placeNeck(const CoarseImage& ct, const CoarseImage& neck, Work& work);

/// Refines the linear map with finer images.
void fitLinear(const CoarseImage& ct, const CoarseImage& neck, NeckMap& map, int rounds);

/// Refines the map with a smooth displacement (demons: J.-P. Thirion, Med Image Anal 2, 1998, with the symmetric force
/// of T. Vercauteren et al., NeuroImage 45, 2009). `rounds` iterations; the displacement is smoothed with `sigma_mm`.
void fitDisplacement(const CoarseImage& ct, const CoarseImage& neck, NeckMap& map, int rounds, double sigma_mm,
                     Work& work);

}  // namespace insonate::segmentation
