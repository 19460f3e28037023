#pragma once

#include "CaseSamples.h"
#include "DicomFiles.h"
#include "support/TestData.h"

#include <insonate/cases/DicomSegmentation.h>
#include <insonate/cases/LabelFile.h>

#include <gmock/gmock.h>

namespace insonate::test {

inline const gdcm::Tag kFrames(0x5200, 0x9230), kShared(0x5200, 0x9229), kPixels(0x7fe0, 0x0010),
    kSegments(0x0062, 0x0002);

inline std::vector<gdcm::DataSet> items(const gdcm::DataSet& data, gdcm::Tag tag) {
  std::vector<gdcm::DataSet> found;
  const auto sequence = data.GetDataElement(tag).GetValueAsSQ();
  for (std::size_t n = 1; n <= sequence->GetNumberOfItems(); ++n)
    found.push_back(sequence->GetItem(n).GetNestedDataSet());
  return found;
}

inline void setBytes(gdcm::DataSet& data, gdcm::Tag tag, gdcm::VR::VRType vr, const std::string& bytes) {
  gdcm::DataElement element(tag);
  element.SetVR(vr);
  element.SetByteValue(bytes.data(), gdcm::VL(static_cast<std::uint32_t>(bytes.size())));
  data.Replace(element);
}

inline std::string bytesIn(const gdcm::DataSet& data, gdcm::Tag tag) {
  const gdcm::ByteValue* value = data.GetDataElement(tag).GetByteValue();
  return {value->GetPointer(), value->GetLength()};
}

/// 8x8 pixels, so that frames are whole bytes: a vein in slices 1 and 2, an artery in slice 3 of five.
inline PatientCase twoVessels() {
  PatientCase patient;
  patient.ct = CtVolume(grid({8, 8, 5}, {0.5, 0.75, 2}, {10, -20, 30}), 40);
  patient.labels = LabelMap(patient.ct.geometry);
  for (const int k : {1, 2}) patient.labels.at(2, 3, k) = kVein;
  patient.labels.at(3, 3, 2) = kVein;
  patient.labels.at(5, 6, 3) = kArtery;
  return patient;
}

/// A segmentation that is written, edited and read back.
class DicomSegmentation : public testing::Test {
 protected:
  void write(PatientCase made) {
    patient = std::move(made);
    const auto written = writeDicomSegmentation(patient, file);
    ASSERT_TRUE(written) << written.error().message;
  }
  LabelReadResult read() {
    auto result = importLabels(patient, file);
    EXPECT_TRUE(result) << result.error().message;
    return result ? std::move(*result) : LabelReadResult{};
  }
  std::string refusal() {
    const auto result = importLabels(patient, file);
    EXPECT_FALSE(result);
    return result ? "" : result.error().message;
  }
  /// Changes the items of a sequence.
  void editItems(gdcm::Tag tag, const std::function<void(std::vector<gdcm::DataSet>&)>& edit) {
    editDicom(file, [&](gdcm::DataSet& data) {
      std::vector<gdcm::DataSet> all = items(data, tag);
      edit(all);
      setSequence(data, tag, all);
    });
  }
  TemporaryFolder folder;
  const std::filesystem::path file = folder / "labels.dcm";
  PatientCase patient;
};

}  // namespace insonate::test
