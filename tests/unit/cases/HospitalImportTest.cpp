#include "HospitalCases.h"
#include "HospitalSlices.h"
#include "support/TestData.h"

#include <insonate/cases/Import.h>

#include <gdcmFragment.h>
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmSequenceOfFragments.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <random>
#include <utility>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// Rounds to a millionth, without negative zeros.
json rounded(Vec3 v) {
  json list = json::array();
  for (int a = 0; a < 3; ++a) list.push_back(std::round(v[a] * 1e6) / 1e6 + 0.0);
  return list;
}

/// The planned import of a folder without identifiers: the numbers of DICOM series.
json dumpOf(const SeriesListing& listing) {
  json dump{{"series", json::array()}, {"set_aside", json::array()}};
  for (const SeriesInfo& s : listing.series) {
    json one{{"modality", s.modality}, {"size", s.geometry.size}};
    if (s.modality.empty()) one["file"] = s.uid;
    if (s.geometryKnown) {
      one["spacing_mm"] = rounded(s.geometry.spacing_mm);
      one["origin_mm"] = rounded(s.geometry.origin_mm);
      for (const Vec3 axis : s.geometry.direction.column) one["direction"].push_back(rounded(axis));
    }
    if (!s.warnings.empty()) one["warnings"] = s.warnings;
    if (!s.refusal.empty()) one["refusal"] = s.refusal;
    dump["series"].push_back(one);
  }
  for (const SkippedFile& s : listing.skippedFiles)
    dump["set_aside"].push_back({{"file", s.file.filename().string()}, {"reason", s.reason}});
  return dump;
}

/// Compares with tests/golden/import/NAME.json, or, with INSONATE_UPDATE_GOLDEN set, writes it to be looked at.
void expectDump(const std::string& name, const fs::path& input) {
  const auto listing = listSeries(input);
  ASSERT_TRUE(listing) << listing.error().message;
  const json dump = dumpOf(*listing);
  const fs::path golden = fs::path(INSONATE_SOURCE_DIR) / "tests/golden/import" / (name + ".json");
  if (std::getenv("INSONATE_UPDATE_GOLDEN")) test::writeText(golden, dump.dump(1) + "\n");
  ASSERT_TRUE(fs::exists(golden)) << dump.dump(1);
  EXPECT_EQ(json::parse(test::contentOf(golden)), dump) << dump.dump(1);
}

class Hospital : public testing::TestWithParam<test::HospitalCase> {};

TEST_P(Hospital, SendsWhatIsListedAsExpected) {
  test::TemporaryFolder folder;
  GetParam().write(folder.path());
  expectDump(GetParam().name, folder.path());
}

/// Whatever was tilted, missing, uneven or scaled: each voxel that was measured holds what lies at its place.
TEST_P(Hospital, SendsVoxelsThatComeToTheirPlace) {
  test::TemporaryFolder folder;
  GetParam().write(folder.path());
  const auto listing = listSeries(folder.path());
  ASSERT_TRUE(listing) << listing.error().message;
  for (const SeriesInfo& s : listing->series) {
    const auto imported = importSeries(folder.path(), s.uid);
    ASSERT_EQ(imported.has_value(), s.refusal.empty()) << (imported ? "" : imported.error().message);
    if (!imported) continue;
    const CtVolume& ct = imported->ct;
    EXPECT_EQ(ct.geometry, s.geometry) << "as listed";
    EXPECT_GT(determinant(ct.geometry.direction), 0.99);
    const Transform patientFromIndex = ct.geometry.patientFromIndex();
    std::size_t compared = 0;
    for (int k = 0; k < ct.geometry.size[2]; ++k)
      for (int j = 0; j < ct.geometry.size[1]; ++j)
        for (int i = 0; i < ct.geometry.size[0]; ++i) {
          if (ct.at(i, j, k) == -1024) continue;
          ++compared;
          const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
          ASSERT_NEAR(ct.at(i, j, k), test::rampHu(p), 1.01) << i << ' ' << j << ' ' << k;
        }
    EXPECT_GT(compared, ct.voxels.size() * 3 / 4);
  }
}

std::string caseName(const testing::TestParamInfo<test::HospitalCase>& shown) {
  std::string name = shown.param.name;
  std::erase(name, '-');
  return name;
}
INSTANTIATE_TEST_SUITE_P(, Hospital, testing::ValuesIn(test::hospitalCases()), caseName);

class SharedSet : public testing::TestWithParam<const char*> {};

TEST_P(SharedSet, IsListedAsExpected) {
  INSONATE_NEEDS_DATA(GetParam());
  expectDump(std::string("shared-") + GetParam(), test::testData(GetParam()));
}
std::string setName(const testing::TestParamInfo<const char*>& shown) {
  std::string name = shown.param;
  std::erase(name, '-');
  return name;
}
INSTANTIATE_TEST_SUITE_P(, SharedSet,
                         testing::Values("abdomen-ct-dicom", "chest-cta", "head-ct-dicom-small", "neck-atlas-labels",
                                         "neck-ct-dicom", "neck-ct-mixed", "seg-dicom", "tilted-ct-dicom",
                                         "transfer-syntaxes"),
                         setName);

class TransferSyntax : public testing::TestWithParam<std::pair<const char*, gdcm::TransferSyntax::TSType>> {
 protected:
  void encode(const fs::path& file) const {
    test::writeSlices(folder_ / "plain", test::axial({50}));
    gdcm::ImageReader reader;
    reader.SetFileName((folder_ / "plain/i1-1-1").c_str());
    ASSERT_TRUE(reader.Read());
    gdcm::ImageChangeTransferSyntax change;
    change.SetTransferSyntax(gdcm::TransferSyntax(GetParam().second));
    change.SetForce(true);
    change.SetInput(reader.GetImage());
    ASSERT_TRUE(change.Change());
    gdcm::ImageWriter writer;
    writer.SetFile(reader.GetFile());
    writer.SetImage(change.GetOutput());
    writer.SetFileName(file.c_str());
    ASSERT_TRUE(writer.Write());
  }
  test::TemporaryFolder folder_;
};

TEST_P(TransferSyntax, GivesTheSameVoxels) {
  encode(folder_ / "encoded.dcm");
  const auto plain = importSeries(folder_ / "plain"), other = importSeries(folder_ / "encoded.dcm");
  ASSERT_TRUE(plain) << plain.error().message;
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(other->ct.voxels, plain->ct.voxels);
  EXPECT_EQ(other->ct.geometry, plain->ct.geometry);
}

/// PS3.5 A.4: the stream of an image may fill several fragments, and the offset table may be empty.
TEST_P(TransferSyntax, InFragmentsGivesTheSameVoxels) {
  encode(folder_ / "encoded.dcm");
  gdcm::Reader reader;
  reader.SetFileName((folder_ / "encoded.dcm").c_str());
  ASSERT_TRUE(reader.Read());
  const gdcm::Tag tag(0x7fe0, 0x0010);
  const auto* whole = reader.GetFile().GetDataSet().GetDataElement(tag).GetSequenceOfFragments();
  if (!whole || GetParam().second == gdcm::TransferSyntax::RLELossless) return;
  const gdcm::ByteValue* bytes = whole->GetFragment(0).GetByteValue();
  auto fragments = gdcm::SequenceOfFragments::New();
  std::uint32_t each = 2;
  for (std::uint32_t at = 0; at < bytes->GetLength(); at += std::exchange(each, 50)) {
    gdcm::Fragment fragment;
    fragment.SetByteValue(bytes->GetPointer() + at,
                          gdcm::VL(std::min(each, static_cast<std::uint32_t>(bytes->GetLength()) - at)));
    fragments->AddFragment(fragment);
  }
  ASSERT_GT(fragments->GetNumberOfFragments(), 2U);
  gdcm::DataElement pixels(tag, 0, gdcm::VR::OB);
  pixels.SetValue(*fragments);
  reader.GetFile().GetDataSet().Replace(pixels);
  gdcm::Writer writer;
  writer.SetFile(reader.GetFile());
  writer.SetFileName((folder_ / "fragments.dcm").c_str());
  ASSERT_TRUE(writer.Write());
  fs::create_directory(folder_ / "apart");
  fs::rename(folder_ / "fragments.dcm", folder_ / "apart/slice.dcm");
  const auto plain = importSeries(folder_ / "plain"), other = importSeries(folder_ / "apart");
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(other->ct.voxels, plain->ct.voxels);
}

/// GDCM ends the program on some broken streams.
TEST_P(TransferSyntax, CutOrChangedIsReadOrRefused) {
  encode(folder_ / "encoded.dcm");
  const std::string whole = test::contentOf(folder_ / "encoded.dcm");
  const fs::path file = folder_ / "changed/slice.dcm";
  fs::create_directories(file.parent_path());
  for (std::size_t cut = 1; cut < whole.size() - 132; cut += 1 + cut / 50) {
    test::writeText(file, whole.substr(0, whole.size() - cut));
    // Some writers leave out the delimiter of eight bytes behind the last fragment.
    EXPECT_FALSE(importSeries(file).has_value() && cut > 16) << cut << " bytes less";
  }
  std::mt19937 random(1);
  for (int n = 0; n < 300; ++n) {
    std::string changed = whole;
    for (int changes = 1 << n % 4; changes > 0; --changes)
      changed[132 + random() % (changed.size() - 132)] = static_cast<char>(random());
    test::writeText(file, changed);
    (void)importSeries(file);
  }
}

using Syntax = gdcm::TransferSyntax;
std::string syntaxName(const testing::TestParamInfo<std::pair<const char*, Syntax::TSType>>& shown) {
  return shown.param.first;
}
INSTANTIATE_TEST_SUITE_P(, TransferSyntax,
                         testing::Values(std::pair{"ImplicitLittleEndian", Syntax::ImplicitVRLittleEndian},
                                         std::pair{"ExplicitLittleEndian", Syntax::ExplicitVRLittleEndian},
                                         std::pair{"Deflated", Syntax::DeflatedExplicitVRLittleEndian},
                                         std::pair{"Rle", Syntax::RLELossless},
                                         std::pair{"JpegLossless", Syntax::JPEGLosslessProcess14},
                                         std::pair{"JpegLosslessFirstOrder", Syntax::JPEGLosslessProcess14_1},
                                         std::pair{"JpegLs", Syntax::JPEGLSLossless},
                                         std::pair{"Jpeg2000", Syntax::JPEG2000Lossless}),
                         syntaxName);

/// Texts by which a series is recognized in a list; a case holds none of them.
TEST(SeriesText, IsReadAsALineOfUtf8) {
  test::TemporaryFolder folder;
  test::writeSlices(folder.path(), test::axial(test::levels(4, 2)));
  for (const auto& entry : fs::directory_iterator(folder.path()))
    test::editDicom(entry.path(), [](gdcm::DataSet& data) {
      using gdcm::Tag;
      test::setText(data, Tag(0x0008, 0x0005), gdcm::VR::CS, "ISO_IR 100");
      test::setText(data, Tag(0x0008, 0x103e), gdcm::VR::LO,
                    "Hals n\xfc"
                    "chtern\n1.0");
      test::setText(data, Tag(0x0018, 0x0015), gdcm::VR::CS, "NECK");
      test::setText(data, Tag(0x0008, 0x0021), gdcm::VR::DA, "20261124");
    });
  const auto listing = listSeries(folder.path());
  ASSERT_TRUE(listing) << listing.error().message;
  EXPECT_EQ(listing->series[0].description, "Hals n\u00fcchtern 1.0");
  EXPECT_EQ(listing->series[0].bodyPart, "NECK");
  EXPECT_EQ(listing->series[0].date, "2026-11-24");
  EXPECT_THAT(seriesListText(*listing), HasSubstr("2026-11-24  NECK  \"Hals n\u00fcchtern 1.0\""));
}

TEST(SeriesText, OfAnotherCharacterSetIsNoBrokenUtf8) {
  test::TemporaryFolder folder;
  test::writeSlices(folder.path(), test::axial(test::levels(2, 2)));
  for (const auto& entry : fs::directory_iterator(folder.path()))
    test::editDicom(entry.path(), [](gdcm::DataSet& data) {
      test::setText(data, gdcm::Tag(0x0008, 0x0005), gdcm::VR::CS, "ISO_IR 144");
      test::setText(data, gdcm::Tag(0x0008, 0x103e), gdcm::VR::LO, "\xc8\xd5\xef CT");
      test::setText(data, gdcm::Tag(0x0008, 0x0021), gdcm::VR::DA, "1.5.2020");
    });
  const auto listing = listSeries(folder.path());
  ASSERT_TRUE(listing) << listing.error().message;
  EXPECT_EQ(listing->series[0].description, "??? CT");
  EXPECT_EQ(listing->series[0].date, "");
}

TEST(Saturation, IsCounted) {
  test::TemporaryFolder folder;
  test::writeSlices(folder.path(), test::axial(test::levels(4, 2)));
  EXPECT_EQ(importSeries(folder.path())->saturatedVoxels, 0u);
  for (const auto& entry : fs::directory_iterator(folder.path()))
    test::editDicom(entry.path(),
                    [](gdcm::DataSet& data) { test::setText(data, gdcm::Tag(0x0028, 0x1053), gdcm::VR::DS, "100"); });
  const auto imported = importSeries(folder.path());
  ASSERT_TRUE(imported) << imported.error().message;
  const auto limited = std::size_t(std::ranges::count(imported->ct.voxels, 32767));
  EXPECT_GT(limited, 0u);
  EXPECT_EQ(imported->saturatedVoxels, limited);
  EXPECT_THAT(saturationText(*imported), HasSubstr(std::to_string(limited) + " voxels exceed 32767 HU"));
}

TEST(TransferSyntaxUnknown, IsNamedAsThat) {
  test::TemporaryFolder folder;
  test::writeSlices(folder / "ct", test::axial({50}));
  const fs::path file = folder / "ct/i1-1-1";
  std::string bytes = test::contentOf(file);
  const std::string known = "1.2.840.10008.1.2.1";
  bytes.replace(bytes.find(known), known.size(), "1.2.840.10008.1.2.8");
  test::writeText(file, bytes);
  const auto imported = importSeries(folder / "ct");
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().message, HasSubstr("encoding that Insonate cannot read (1.2.840.10008.1.2.8)"));
}

}  // namespace
}  // namespace insonate
