#include "SegmentationFiles.h"

#include <gdcmSequenceOfFragments.h>

#include <algorithm>

namespace insonate {
namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;
using test::bytesIn;
using test::items;
using test::kFrames;
using test::kPixels;
using test::kSegments;
using test::setBytes;
using testing::HasSubstr;

using LabelMapSegmentation = test::DicomSegmentation;

/// The vessels as a label map (PS3.3 C.8.20.2.3.3): a frame a slice, in which pixels are segments' numbers; artery 1,
/// vein 2.
void makeLabelMap(DataSet& data, const LabelMap& labels, int bytesEach) {
  std::vector<DataSet> frames;
  std::string pixels;
  for (int k = 0; k < labels.geometry.size[2]; ++k) {
    const Vec3 p = labels.geometry.patientFromIndex() * Vec3{0, 0, double(k)};
    DataSet position, groups;
    test::setText(position, Tag(0x0020, 0x0032), VR::DS,
                  std::to_string(p.x) + "\\" + std::to_string(p.y) + "\\" + std::to_string(p.z));
    test::setSequence(groups, Tag(0x0020, 0x9113), {position});
    frames.push_back(groups);
    for (int n = 0; n < 64; ++n) {
      const std::uint8_t label = labels.at(n % 8, n / 8, k);
      pixels += label == kArtery ? '\1' : label == kVein ? '\2' : '\0';
      pixels.append(static_cast<std::size_t>(bytesEach - 1), '\0');
    }
  }
  test::setText(data, Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.66.7");
  test::setText(data, Tag(0x0062, 0x0001), VR::CS, "LABELMAP");
  test::setText(data, Tag(0x0028, 0x0008), VR::IS, std::to_string(frames.size()));
  test::setSequence(data, kFrames, frames);
  for (const std::uint16_t element : {0x0100, 0x0101})
    test::setShort(data, Tag(0x0028, element), VR::US, static_cast<std::int16_t>(8 * bytesEach));
  test::setShort(data, Tag(0x0028, 0x0102), VR::US, static_cast<std::int16_t>(8 * bytesEach - 1));
  setBytes(data, kPixels, bytesEach == 1 ? VR::OB : VR::OW, pixels);
}

TEST_F(LabelMapSegmentation, LabelMapsAreRead) {
  for (const int bytesEach : {1, 2}) {
    write(test::twoVessels());
    test::editDicom(file, [&](DataSet& data) { makeLabelMap(data, patient.labels, bytesEach); });
    const LabelReadResult back = read();
    EXPECT_EQ(back.labels.voxels, patient.labels.voxels) << bytesEach;
    EXPECT_EQ(back.notes.size(), 2U) << "one a segment";
  }
}

TEST_F(LabelMapSegmentation, WhatIsNoSegmentInALabelMap) {
  write(test::twoVessels());
  test::editDicom(file, [&](DataSet& data) {
    makeLabelMap(data, patient.labels, 1);
    std::string pixels = bytesIn(data, kPixels);
    std::ranges::replace(pixels, '\0', '\x9');  // the padding value
    pixels[0] = '\0';
    pixels[1] = '\x7';  // described as background
    pixels[2] = '\x4d';
    setBytes(data, kPixels, VR::OB, pixels);
    test::setShort(data, Tag(0x0028, 0x0120), VR::US, 9);
    DataSet code, background;
    test::setText(code, Tag(0x0008, 0x0100), VR::SH, "125040");
    test::setText(code, Tag(0x0008, 0x0102), VR::SH, "DCM");
    test::setSequence(background, Tag(0x0062, 0x000f), {code});
    test::setShort(background, Tag(0x0062, 0x0004), VR::US, 7);
    std::vector<DataSet> segments = items(data, kSegments);
    segments.push_back(background);
    test::setSequence(data, kSegments, segments);
  });
  const LabelReadResult back = read();
  EXPECT_EQ(back.labels.voxels, patient.labels.voxels);
  EXPECT_THAT(back.notes, testing::UnorderedElementsAre(HasSubstr("artery"), HasSubstr("vein"),
                                                        HasSubstr("The number 77 in the file belongs to no segment")));
}

/// A frame of 64 pixels in DICOM's run lengths (PS3.5 G): one segment, one literal run.
gdcm::Fragment runLengthFrame(const std::string& pixels) {
  std::string bytes(64, '\0');
  bytes[0] = 1;
  bytes[4] = 64;
  bytes += '\x3f' + pixels + '\0';
  gdcm::Fragment fragment;
  fragment.SetByteValue(bytes.data(), gdcm::VL(static_cast<std::uint32_t>(bytes.size())));
  return fragment;
}

TEST_F(LabelMapSegmentation, CompressedLabelMapsAreReadAndCutOnesRefused) {
  for (const bool whole : {true, false}) {
    write(test::twoVessels());
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    ASSERT_TRUE(reader.Read());
    DataSet& data = reader.GetFile().GetDataSet();
    makeLabelMap(data, patient.labels, 1);
    const std::string pixels = bytesIn(data, kPixels);
    const auto fragments = gdcm::SequenceOfFragments::New();
    for (int k = 0; k < (whole ? 5 : 4); ++k) fragments->AddFragment(runLengthFrame(pixels.substr(64 * k, 64)));
    gdcm::DataElement element(kPixels);
    element.SetVR(VR::OB);
    element.SetValue(*fragments);
    data.Replace(element);
    gdcm::Writer writer;
    reader.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::RLELossless);
    writer.SetFile(reader.GetFile());
    writer.SetFileName(file.c_str());
    ASSERT_TRUE(writer.Write());
    if (whole)
      EXPECT_EQ(read().labels.voxels, patient.labels.voxels);
    else
      EXPECT_THAT(refusal(), HasSubstr("fewer pixels"));
  }
}

}  // namespace
}  // namespace insonate
