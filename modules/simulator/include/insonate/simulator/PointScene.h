#pragma once

#include <insonate/simulator/Imager.h>

#include <vector>

namespace insonate {

/// Makes a scene as makeScene() does, with point targets in the patient's tissue for measuring the point spread.
Result<std::shared_ptr<const AcousticScene>> makePointScene(const CaseView& patient, const ImagingSetup& setup,
                                                            const Region& region, std::vector<PointTarget> points,
                                                            const Progress& progress = {});

}  // namespace insonate
