#pragma once

#include <insonate/bench/UltrasoundBench.h>

namespace insonate::bench {

/// Returns the table with every tissue's echogenicity raised by an amount of up to 0.03 dB that differs between labels.
/// The change is invisible, but reveals the label of each sample in a frame that is rendered with scattering alone.
AcousticTable withMarks(AcousticTable table);

/// Renders an image, measures its realism on patches that are found from the labels, and adds both to `bench`. The
/// scene must have the setup's tissues changed by withMarks().
void measureRealism(const AcousticScene& scene, const ImagingSetup& setup, const Transform& patientFromProbe,
                    const std::string& variant, const std::string& view, UltrasoundBench& bench);

}  // namespace insonate::bench
