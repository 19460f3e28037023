#pragma once

#include <insonate/simulator/UltrasoundBench.h>

namespace insonate::bench {

/// The table with every tissue's echogenicity raised by up to 0.03 dB, differently for each label: nothing to see, but
/// a frame of scattering alone then tells which label each sample shows, after contact and smooth boundaries.
AcousticTable withMarks(AcousticTable table);

/// Measures one displayed picture with patches found from the labels. The scene must be of the setup's tissues, and
/// those marked.
std::vector<RealismRow> measureRealism(const AcousticScene& scene, const ImagingSetup& setup,
                                       const Transform& patientFromProbe, const std::string& variant,
                                       const std::string& view);

}  // namespace insonate::bench
