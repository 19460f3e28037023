#pragma once

#include <insonate/cases/PatientCase.h>

#include <array>
#include <cstdint>

namespace insonate {

/// L*, a*, b* as DICOM stores them (PS3.3 C.10.7.1.1): 0 to 65535 for 0 to 100 and for -128 to 127, white point D50.
using DicomLab = std::array<std::uint16_t, 3>;

DicomLab dicomLabOf(const LabelColour& colour);
LabelColour colourOfDicomLab(const DicomLab& lab);

}  // namespace insonate
