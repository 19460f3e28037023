#include "CaseSamples.h"
#include "DicomFiles.h"
#include "import/DicomLayout.h"
#include "support/TestData.h"

#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/Import.h>

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
