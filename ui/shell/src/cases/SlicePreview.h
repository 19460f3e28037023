#pragma once

#include <insonate/image/Volume.h>

#include <QImage>

namespace insonate::ui {

/// The middle slice across k in a soft tissue window, not larger than `side` pixels, `shift_HU` added to its values,
/// with the patient's left on the right where i or j run that way. For any thread.
QImage slicePreview(const CtVolume& ct, int side, int shift_HU = 0);

}  // namespace insonate::ui
