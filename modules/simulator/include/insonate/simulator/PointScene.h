#pragma once

#include <insonate/simulator/Imager.h>

#include <vector>

namespace insonate {

/// makeScene() with point targets among the patient's tissue, to measure the point spread by.
Result<std::shared_ptr<const AcousticScene>> makePointScene(const CaseView& patient, const ImagingSetup& setup,
                                                            const Region& region, std::vector<PointTarget> points,
                                                            const Progress& progress = {});

}  // namespace insonate
