#pragma once

#include <insonate/bench/UltrasoundBench.h>

namespace insonate::bench {

/// The table with every tissue's echogenicity raised by up to 0.03 dB, differently for each label: invisible, but a
/// frame of scattering alone then reveals the label of each sample, after contact and smooth boundaries.
AcousticTable withMarks(AcousticTable table);

/// Adds the measures of one displayed image, on patches found from the labels, and the picture. The scene must be of
/// the setup's tissues, and those marked.
void measureRealism(const AcousticScene& scene, const ImagingSetup& setup, const Transform& patientFromProbe,
                    const std::string& variant, const std::string& view, UltrasoundBench& bench);

}  // namespace insonate::bench
