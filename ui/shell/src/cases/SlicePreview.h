#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/image/Volume.h>

#include <QImage>

namespace insonate::ui {

/// Returns the middle slice perpendicular to k, in a soft-tissue window with `shift_HU` added to the values, at most
/// `side` pixels wide and high. The patient's left is on the right if i or j runs along that direction. May be called
/// on any thread.
QImage slicePreview(const CtVolume& ct, int side, int shift_HU = 0);

/// Does the same for the slice with the most labeled voxels, and draws the labels in their colors. `labels` has the
/// grid of `ct`.
QImage labelPreview(const CtVolume& ct, const LabelMap& labels, const LabelColors& colors, int side);

}  // namespace insonate::ui
