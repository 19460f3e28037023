#pragma once

#include <insonate/cases/PatientCase.h>

#include <array>
#include <cstdint>

namespace insonate {

/// L*, a*, b* as DICOM stores them (PS3.3 C.10.7.1.1), white point D50: 0 to 65535 stands for L* of 0 to 100, and for
/// a* and b* of -128 to 127.
using DicomLab = std::array<std::uint16_t, 3>;

DicomLab dicomLabOf(const LabelColor& color);
LabelColor colorOfDicomLab(const DicomLab& lab);

}  // namespace insonate
