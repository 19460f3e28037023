#pragma once

#include <insonate/bench/UltrasoundBench.h>

namespace insonate::bench {

/// Returns the table with every tissue's echogenicity raised by up to 0.03 dB, by a different amount for each label.
/// The change is invisible, but reveals the label of each sample in a frame of scattering alone, after contact and
/// smooth boundaries.
AcousticTable withMarks(AcousticTable table);

/// Adds the image and its measures, on patches found from the labels. The scene must have the setup's tissues, with
/// marks (see withMarks()).
void measureRealism(const AcousticScene& scene, const ImagingSetup& setup, const Transform& patientFromProbe,
                    const std::string& variant, const std::string& view, UltrasoundBench& bench);

}  // namespace insonate::bench
