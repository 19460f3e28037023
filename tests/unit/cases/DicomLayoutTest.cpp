#include "CaseSamples.h"
#include "DicomFiles.h"
#include "import/DicomLayout.h"
#include "support/TestData.h"

#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/Import.h>

#include <random>

namespace insonate {
namespace {

TEST(DicomLayout, EveryCutIsNoticed) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeDicomSeries(test::noiseCt(test::grid({5, 4, 1})), folder / "s", {.seed = "s"}));
  const auto file = folder / "s/slice00001.dcm";
  test::editDicom(file, [](gdcm::DataSet& data) {
    gdcm::DataSet item;
    test::setText(item, gdcm::Tag(0x0008, 0x0100), gdcm::VR::SH, "code");
    test::setSequence(data, gdcm::Tag(0x0008, 0x2218), {item, item});
  });
  const std::string whole = test::contentOf(file);
  ASSERT_EQ(layoutOf(file), DicomLayout::kWhole);
  const std::size_t pixels = whole.size() - 5 * 4 * 2;
  for (std::size_t length = 132; length < whole.size(); ++length) {
    test::writeText(file, whole.substr(0, length));
    const DicomLayout layout = layoutOf(file);
    if (length >= pixels)
      ASSERT_EQ(layout, DicomLayout::kCutInPixels) << "cut at " << length << " of " << whole.size();
    else  // a cut between two elements leaves a valid file without pixels
      ASSERT_NE(layout, DicomLayout::kNotDicom) << "cut at " << length;
    ASSERT_FALSE(importSeries(file));
  }
}

std::string littleEndian(std::uint32_t value, int bytes) {
  std::string text;
  for (int n = 0; n < bytes; ++n) text += static_cast<char>(value >> (8 * n));
  return text;
}

/// A sequence of one item, which some writers give lengths and others delimiters.
std::string sequenceOf(const std::string& item, bool withLengths) {
  const std::string head = littleEndian(0x0040, 2) + littleEndian(0xa730, 2) + "SQ" + littleEndian(0, 2);
  const std::string itemTag = littleEndian(0xfffe, 2) + littleEndian(0xe000, 2);
  const auto length = [withLengths](std::size_t bytes) {
    return littleEndian(withLengths ? static_cast<std::uint32_t>(bytes) : 0xffffffff, 4);
  };
  const auto end = [withLengths](std::uint32_t element) {
    return withLengths ? "" : littleEndian(0xfffe, 2) + littleEndian(element, 2) + littleEndian(0, 4);
  };
  return head + length(item.size() + 8) + itemTag + length(item.size()) + item + end(0xe00d) + end(0xe0dd);
}

/// GDCM 3.0 ends the program on broken headers, as those of items whose elements do not fill them.
TEST(DicomLayout, ChangedBytesEndNoProgram) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeDicomSeries(test::noiseCt(test::grid({5, 4, 1})), folder / "s", {.seed = "s"}));
  const auto file = folder / "s/slice00001.dcm";
  const std::string plain = test::contentOf(file);
  const std::size_t pixels = plain.size() - 5 * 4 * 2 - 12;
  const std::string code = littleEndian(0x0008, 2) + littleEndian(0x0100, 2) + "SH" + littleEndian(4, 2) + "code";
  for (const bool withLengths : {true, false}) {
    const std::string inner = sequenceOf(code + code, withLengths);
    const std::string sequence = sequenceOf(code + inner, withLengths);
    const std::string whole = plain.substr(0, pixels) + sequence + plain.substr(pixels);
    test::writeText(file, whole);
    ASSERT_EQ(layoutOf(file), DicomLayout::kWhole);
    const std::size_t modality = whole.find("CS\2", 132);
    ASSERT_LT(modality, pixels);
    std::mt19937 random(1);
    const auto somewhere = [&](std::size_t from, std::size_t to) { return from + random() % (to - from); };
    for (int n = 0; n < 1000; ++n) {
      std::string changed = whole;
      for (int changes = 1 << (n % 5); changes > 0; --changes)
        changed[somewhere(132, changed.size())] = static_cast<char>(random());
      // Sequences are short, and rarely hit otherwise.
      if (n % 2) changed[somewhere(pixels, pixels + sequence.size())] = static_cast<char>(random());
      if (n % 3 == 0) changed[modality] = 'v';
      test::writeText(folder / "changed.dcm", changed);
      (void)importSeries(folder / "changed.dcm");
    }
  }
}

/// GDCM's reader of images ends the program where what describes an image is given in another way than the
/// dictionary's, and on curves and overlays that it does not know.
TEST(DicomLayout, WhatDescribesThePictureEndsNoProgram) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeDicomSeries(test::noiseCt(test::grid({5, 4, 1})), folder / "s", {.seed = "s"}));
  const auto file = folder / "s/slice00001.dcm";
  const std::string whole = test::contentOf(file);
  using gdcm::VR;
  const std::string ones(16, '\1');
  for (const std::uint16_t element : {0x0002, 0x0004, 0x0006, 0x0008, 0x0009, 0x0010, 0x0011, 0x0030, 0x0100, 0x0101,
                                      0x0102, 0x0103, 0x0120, 0x1052, 0x1053, 0x1101, 0x2110})
    for (const VR::VRType vr : {VR::AE, VR::AT, VR::DS, VR::FD, VR::IS, VR::LO, VR::OB, VR::SS, VR::UN, VR::US})
      for (const std::string& value : {std::string(), std::string("1"), ones}) {
        test::writeText(file, whole);
        test::editDicom(file, [&](gdcm::DataSet& data) { test::setText(data, gdcm::Tag(0x0028, element), vr, value); });
        (void)importSeries(file);
      }
  for (const std::uint16_t group : {0x5000, 0x6000})
    for (const std::uint16_t element : {0x0005, 0x0010, 0x0022, 0x0040, 0x0100, 0x0103, 0x0112, 0x2500, 0x3000}) {
      test::writeText(file, whole);
      test::editDicom(file,
                      [&](gdcm::DataSet& data) { test::setText(data, gdcm::Tag(group, element), VR::LO, "a text"); });
      EXPECT_TRUE(importSeries(file)) << group << ' ' << element << ": neither curves nor overlays are of interest";
    }
}

TEST(DicomLayout, OtherFilesAreNoDicom) {
  test::TemporaryFolder folder;
  for (const std::string& text :
       {std::string(), std::string("text"), std::string(5000, 'x'), std::string(5000, '\0')}) {
    test::writeText(folder / "f", text);
    EXPECT_EQ(layoutOf(folder / "f"), DicomLayout::kNotDicom) << text.size() << " bytes";
  }
  EXPECT_EQ(layoutOf(folder / "missing"), DicomLayout::kNotDicom);
}

}  // namespace
}  // namespace insonate
