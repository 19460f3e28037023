#pragma once

#include "Work.h"

#include <insonate/image/Volume.h>

namespace insonate::segmentation {

/// Returns the standard deviation of the CT in the body (kSoftTissue), from differences of voxels just far enough apart
/// that their noise is independent. The result includes the noise and some ten HU of anatomical variation.
double noiseInBody_HU(const CtVolume& ct, const LabelMap& body, Work& work);

/// Tells whether the slight smoothing of calmed() removes most of the noise: true if the voxels are no wider than the
/// scanner's blur along at least two axes.
bool canBeCalmed(const VolumeGeometry& geometry);

/// Returns the CT slightly smoothed along each axis whose voxels are no wider than the scanner's blur, so that little
/// detail is lost.
CtVolume calmed(const CtVolume& ct, Work& work);

}  // namespace insonate::segmentation
