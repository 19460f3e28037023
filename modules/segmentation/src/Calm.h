#pragma once

#include "Work.h"

#include <insonate/image/Volume.h>

namespace insonate::segmentation {

/// Standard deviation of the CT in the body (kSoftTissue) between voxels just far enough apart for their noise to be
/// independent: noise, and some ten HU of anatomy.
double noiseInBody_HU(const CtVolume& ct, const LabelMap& body, Work& work);

/// Tells whether calmed() removes most of the noise: along two axes or more, voxels are not wider than the scanner's
/// blur.
bool canBeCalmed(const VolumeGeometry& geometry);

/// Smoothed a little along each axis whose voxels are not wider than the scanner's blur, so that little is lost.
CtVolume calmed(const CtVolume& ct, Work& work);

}  // namespace insonate::segmentation
