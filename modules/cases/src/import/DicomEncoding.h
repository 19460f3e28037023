#pragma once

#include <insonate/cases/DicomWriter.h>

#include <gdcmDataSet.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace insonate {

inline constexpr const char* kCtImageStorage = "1.2.840.10008.5.1.4.1.1.2";

/// UIDs of a written CT series. Objects that refer to the series use the same UIDs.
struct SeriesUids {
  std::string study, series, frameOfReference;
};
SeriesUids uidsOf(const DicomSeriesIdentity& identity);
std::string sliceUid(const SeriesUids& uids, int k);

/// Sets an element's text, padded to even length.
void put(gdcm::DataSet& data, gdcm::Tag tag, gdcm::VR::VRType vr, std::string text);
void putShorts(gdcm::DataSet& data, gdcm::Tag tag, std::initializer_list<std::uint16_t> values);
/// Sets an element to bytes in little endian order.
void putBinary(gdcm::DataSet& data, gdcm::Tag tag, gdcm::VR::VRType vr, const void* bytes, std::size_t size);
/// Sets a sequence with one item for each data set.
void putSequence(gdcm::DataSet& data, gdcm::Tag tag, const std::vector<gdcm::DataSet>& items);

/// Returns the most exact text of numbers within the 16 characters of a decimal string (DICOM PS3.5, VR DS).
std::string decimalStrings(std::initializer_list<double> values);

/// Sets date and time of the series and of the content to the present time, UTC.
void putTimeOfWriting(gdcm::DataSet& data);

/// Sets the patient and study modules (DICOM PS3.3 A.3); type 2 attributes are empty.
void putPatientAndStudy(gdcm::DataSet& data, const DicomSeriesIdentity& identity, const SeriesUids& uids);

}  // namespace insonate
