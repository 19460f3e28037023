#pragma once

#include <insonate/simulator/Imager.h>

#include <vector>

namespace insonate {

/// Makes an acoustic scene like makeScene(), with added point reflectors in the tissue, for measuring the point spread
/// function.
Result<std::shared_ptr<const AcousticScene>> makePointScene(const CaseView& patient, const ImagingSetup& setup,
                                                            const Region& region, std::vector<PointTarget> points,
                                                            const Progress& progress = {});

}  // namespace insonate
