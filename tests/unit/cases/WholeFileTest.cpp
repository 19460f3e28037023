#include "CaseSamples.h"
#include "VolumeFiles.h"
#include "support/TestData.h"

#include <insonate/cases/Import.h>

#include <gmock/gmock.h>
#include <zlib.h>

namespace insonate {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

const VolumeGeometry kLargeGrid = test::grid({20, 15, 12}, {0.5, 0.75, 2}, {-10, 20, 30});

std::string gzipped(const std::string& bytes, int windowBits) {
  z_stream stream{};
  EXPECT_EQ(::deflateInit2(&stream, 6, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string out(::deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(::deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  ::deflateEnd(&stream);
  return out;
}
std::string gzip(const std::string& bytes) {
  return gzipped(bytes, 31);
}
std::string zlibbed(const std::string& bytes) {
  return gzipped(bytes, 15);
}

class WholeFile : public testing::Test {
 protected:
  /// Imports `name` whole, then without its last bytes, and expects that to be refused with nothing else said.
  void expectCutIsNoticed(const std::string& name, const std::string& whole, const std::string& cutName = {}) {
    const std::string& target = cutName.empty() ? name : cutName;
    test::writeText(folder / target, whole);
    const auto imported = importSeries(folder / name);
    ASSERT_TRUE(imported) << name << ": " << imported.error().message;
    EXPECT_EQ(imported->ct.voxels, ct.voxels) << name;
    for (const std::size_t lost : {std::size_t{2}, whole.size() / 4, whole.size() / 2}) {
      test::writeText(folder / target, whole.substr(0, whole.size() - lost));
      CaptureStderr();
      const auto cut = importSeries(folder / name);
      EXPECT_EQ(GetCapturedStderr(), "") << name << ": libraries have no say";
      ASSERT_FALSE(cut) << name << " without " << lost << " bytes";
      EXPECT_THAT(cut.error().message, AllOf(HasSubstr(name), HasSubstr("cut off"), HasSubstr("again"))) << lost;
    }
  }
  test::TemporaryFolder folder;
  const CtVolume ct = test::noiseCt(kLargeGrid);
  const std::string meta = test::metaHeader(kLargeGrid, "1 0 0 0 1 0 0 0 1");
  const std::string voxels = test::bytesOf(ct.voxels);
};

TEST_F(WholeFile, Nifti) {
  expectCutIsNoticed("a.nii", test::niftiOf(ct, test::kRas, 1, 0));
}

TEST_F(WholeFile, CompressedNifti) {
  expectCutIsNoticed("a.nii.gz", gzip(test::niftiOf(ct, test::kRas, 1, 0)));
}

TEST_F(WholeFile, ACompressedNiftiOfACutNifti) {
  const std::string whole = test::niftiOf(ct, test::kRas, 1, 0);
  test::writeText(folder / "a.nii.gz", gzip(whole.substr(0, whole.size() - 10)));
  EXPECT_THAT(importSeries(folder / "a.nii.gz").error().message, HasSubstr("its header states"));
}

TEST_F(WholeFile, ANiftiThatPromisesMoreThanAnyMachineHolds) {
  std::string absurd = test::niftiOf(ct, test::kRas, 1, 0);
  for (const int n : {42, 44, 46}) absurd[n] = '\xff', absurd[n + 1] = '\x7f';
  test::writeText(folder / "a.nii", absurd);
  EXPECT_THAT(importSeries(folder / "a.nii").error().message, HasSubstr("a.nii"));
}

TEST_F(WholeFile, OfADamagedNrrdTheInnermostReasonIsTold) {
  const std::string header =
      "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 20 15 12\nencoding: gzip\n"
      "endian: little\nspace directions: (0.5,0,0) (0,0.75,0) (0,0,2)\nspace origin: (-10,20,30)\n\n";
  const std::string data = gzip(voxels);
  test::writeText(folder / "a.nrrd", header + data.substr(0, data.size() / 2));
  const auto cut = importSeries(folder / "a.nrrd");
  ASSERT_FALSE(cut);
  EXPECT_THAT(cut.error().message, AllOf(HasSubstr("a.nrrd"), HasSubstr("header states 7200 bytes")));
  test::writeText(folder / "a.nrrd", "NRRD0004\ntype: sort" + header.substr(header.find("\ndim")) + data);
  const auto damaged = importSeries(folder / "a.nrrd");
  ASSERT_FALSE(damaged);
  EXPECT_THAT(damaged.error().message, AllOf(HasSubstr("a.nrrd"), HasSubstr("couldn't parse type \"sort\"")));
  EXPECT_THAT(damaged.error().message, Not(AnyOf(HasSubstr("0x"), HasSubstr("[nrrd]"), HasSubstr("ERROR"))));
}

TEST_F(WholeFile, MetaImageInOneFile) {
  expectCutIsNoticed("a.mha", meta + "ElementDataFile = LOCAL\n" + voxels);
}

TEST_F(WholeFile, MetaImageInTwoFiles) {
  test::writeText(folder / "a.mhd", meta + "ElementDataFile = a.raw\n");
  expectCutIsNoticed("a.mhd", voxels, "a.raw");
  std::filesystem::remove(folder / "a.raw");
  EXPECT_THAT(importSeries(folder / "a.mhd").error().message, AllOf(HasSubstr("no file"), HasSubstr("a.raw")));
}

TEST_F(WholeFile, CompressedMetaImage) {
  const std::string compressed = zlibbed(voxels);
  const std::string size = "CompressedData = True\nCompressedDataSize = " + std::to_string(compressed.size()) + "\n";
  const std::string header = test::metaHeader(kLargeGrid, "1 0 0 0 1 0 0 0 1", "MET_SHORT", size);
  expectCutIsNoticed("a.mha", header + "ElementDataFile = LOCAL\n" + compressed);
  test::writeText(folder / "b.mhd", header + "ElementDataFile = b.zraw\n");
  expectCutIsNoticed("b.mhd", compressed, "b.zraw");
}

TEST_F(WholeFile, MetaImageInAListOfFiles) {
  std::string list = meta + "ElementDataFile = LIST\n";
  const std::size_t slice = voxels.size() / 12;
  for (int k = 0; k < 12; ++k) {
    const std::string name = "s" + std::to_string(k) + ".raw";
    test::writeText(folder / name, voxels.substr(k * slice, slice));
    list += name + "\n";
  }
  test::writeText(folder / "a.mhd", list);
  const auto imported = importSeries(folder / "a.mhd");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->ct.voxels, ct.voxels);
  test::writeText(folder / "s7.raw", voxels.substr(0, 10));
  EXPECT_THAT(importSeries(folder / "a.mhd").error().message, HasSubstr("cut off"));
}

TEST_F(WholeFile, NiftiWithoutAFrameIsNoted) {
  std::string unplaced = test::niftiOf(ct, test::kRas, 1, 0);
  unplaced[254] = 0;
  test::writeText(folder / "a.nii", unplaced);
  const auto imported = importSeries(folder / "a.nii");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_THAT(imported->series.warnings, testing::Contains(HasSubstr("does not state its orientation")));
  test::writeText(folder / "b.nii", test::niftiOf(ct, test::kRas, 1, 0));
  EXPECT_THAT(importSeries(folder / "b.nii")->series.warnings,
              testing::Each(testing::Not(HasSubstr("its orientation"))));
}

TEST_F(WholeFile, VoxelsThatNoScannerMakesAreRefusedBeforeTheyAreRead) {
  // The voxels are missing: were they read first, that would be the reason.
  VolumeGeometry metres = kLargeGrid;
  metres.spacing_mm = {0.5, 0.0015, 2};
  test::writeText(folder / "a.mha", test::metaHeader(metres, "1 0 0 0 1 0 0 0 1") + "ElementDataFile = LOCAL\n");
  EXPECT_THAT(importSeries(folder / "a.mha").error().message, AllOf(HasSubstr("0.0015 mm"), HasSubstr("meters?")));
}

TEST_F(WholeFile, ALabelMapIsNoCt) {
  CtVolume labels(kLargeGrid);
  for (std::size_t v = 0; v < labels.voxels.size(); ++v) labels.voxels[v] = static_cast<std::int16_t>(v % 120);
  test::writeText(folder / "a.nii", test::niftiOf(labels, test::kRas, 1, 0));
  EXPECT_THAT(importSeries(folder / "a.nii").error().message, AllOf(HasSubstr("120"), HasSubstr("label map")));
  labels.voxels[5] = -900;
  test::writeText(folder / "a.nii", test::niftiOf(labels, test::kRas, 1, 0));
  EXPECT_TRUE(importSeries(folder / "a.nii"));
}

}  // namespace
}  // namespace insonate
