#include "SegmentationFiles.h"
#include "StructureFiles.h"
#include "VolumeFiles.h"

#include <insonate/cases/Import.h>
#include <insonate/cases/PatientCase.h>

#include <random>

namespace insonate {
namespace {

namespace fs = std::filesystem;

/// A file that is whole, and who reads it: the sentence that is said, or nothing where it was read.
struct Format {
  const char* name;
  std::string whole;
  std::size_t header;  ///< bytes of it, where changes tell most
  std::function<std::string(const fs::path& file)> read;
};

template <class T>
std::string findingText(const Result<T>& result) {
  if (result) return {};
  return result.error().message.empty() ? "no sentence at all" : result.error().message;
}

class ReaderFuzz : public testing::Test {
 protected:
  void SetUp() override {
    patient_.ct.geometry.origin_mm = patient_.labels.geometry.origin_mm = {-10, 20, 30};
    ASSERT_TRUE(writeCase(patient_, folder_ / "case"));
    ASSERT_TRUE(writeDicomSegmentation(patient_, folder_ / "seg.dcm"));
    test::writeText(folder_ / "plain.nii", test::niftiOf(patient_.ct, test::kRas, 1, 0));
  }
  std::string asLabels(const fs::path& file, const fs::path& names = {}) const {
    return findingText(importLabels(patient_, file, {.names = names}));
  }
  std::string asCt(const fs::path& file) const { return findingText(importSeries(file)); }
  std::string asManifest(const fs::path& file) const {
    fs::copy_file(file, folder_ / "case/case.json", fs::copy_options::overwrite_existing);
    return findingText(readCase(folder_ / "case"));
  }

  /// Bytes, numbers of 2 and 4 bytes that lengths and sizes overflow on, numbers in texts, and what is cut or left out.
  std::string changed(const Format& format) {
    std::string bytes = format.whole;
    const auto below = [&](std::size_t end) { return static_cast<std::size_t>(random_() % end); };
    switch (below(5)) {
      case 0:
        bytes.resize(below(bytes.size()));
        break;
      case 1:
        bytes.erase(below(bytes.size()), below(20));
        break;
      case 2: {
        constexpr std::array<std::uint32_t, 8> kHostile{0xffffffff, 0x7fffffff, 0x80000000, 0x7fc00000,
                                                        0x7f800000, 0,          0xffff,     0xbf800000};
        const std::uint32_t value = kHostile[below(kHostile.size())];
        std::memcpy(&bytes[below(format.header - 4) & ~std::size_t{1}], &value, below(2) ? 4 : 2);
        break;
      }
      case 3: {
        const std::size_t digit = bytes.find_first_of("0123456789", below(format.header));
        constexpr std::array<const char*, 8> kNumbers{"99999999999", "-1",         "nan", "inf",
                                                      "1e308",       "2147483647", "",    "65535"};
        if (digit < format.header) bytes.replace(digit, 1, kNumbers[below(kNumbers.size())]);
        break;
      }
      default:
        for (std::size_t n = 1 + below(8); n > 0; --n) bytes[below(bytes.size())] = static_cast<char>(random_());
    }
    return bytes;
  }

  /// Whatever is in a file: it is read, or a sentence names what is wrong. Sanitizers watch.
  void expectSentences(const Format& format, const std::string& file) {
    test::writeText(folder_ / file, format.whole);
    EXPECT_EQ(format.read(folder_ / file), "") << format.name << " as it was";
    int refused = 0;
    for (int n = 0; n < 300; ++n) {
      test::writeText(folder_ / file, changed(format));
      const std::string sentence = format.read(folder_ / file);
      refused += !sentence.empty();
      for (const char* raw : {"std::", "bad_alloc", "0x", "no sentence"})
        EXPECT_EQ(sentence.find(raw), std::string::npos) << format.name << ": " << sentence;
    }
    EXPECT_GT(refused, 50) << format.name;
  }

  std::string written(const char* file) const { return test::contentOf(folder_ / file); }

  test::TemporaryFolder folder_;
  PatientCase patient_ = test::twoVessels();
  std::mt19937 random_{1};
};

TEST_F(ReaderFuzz, ChangedVolumesAreReadOrRefused) {
  const auto read = [this](const fs::path& file) {
    const std::string ct = asCt(file);
    return asLabels(file).empty() ? std::string() : ct;
  };
  const CtVolume& ct = patient_.ct;
  expectSentences({"NIfTI", test::niftiOf(ct, test::kRas, 1, 0), 352, read}, "a.nii");
  expectSentences({"NIfTI-2", test::secondNiftiOf(ct, test::kRas), 544, read}, "b.nii");
  const std::string nrrd = written("case/ct.nrrd"), meta = test::metaImage(ct, "1 0 0 0 1 0 0 0 1");
  expectSentences({"NRRD", nrrd, nrrd.find("\n\n"), read}, "c.nrrd");
  expectSentences({"MetaImage", meta, meta.find("LOCAL"), read}, "d.mha");
}

TEST_F(ReaderFuzz, ChangedSegmentationsAreReadOrRefused) {
  const auto read = [this](const fs::path& file) { return asLabels(file); };
  const std::string slicer = written("case/labels.seg.nrrd"), dicom = written("seg.dcm");
  expectSentences({"3D Slicer", slicer, slicer.find("\n\n"), read}, "a.seg.nrrd");
  expectSentences({"DICOM", dicom, dicom.size(), read}, "b.dcm");
}

TEST_F(ReaderFuzz, ChangedStructureSetsAreReadOrRefused) {
  test::writeStructureSet(folder_ / "rs.dcm", {{"Vein", test::ball({-8, 22, 33}, 3, {31, 33, 35})},
                                               {"Artery", {test::circle({-9, 22, 33}, 1, 8)}}});
  const std::string whole = written("rs.dcm");
  expectSentences({"RT Structure Set", whole, whole.size(), [this](const fs::path& file) { return asLabels(file); }},
                  "c.dcm");
}

TEST_F(ReaderFuzz, ChangedDescriptionsAreReadOrRefused) {
  const std::string names = written("case/labels.label.txt");
  expectSentences(
      {"ITK-SNAP", names, names.size(), [this](const fs::path& file) { return asLabels(folder_ / "plain.nii", file); }},
      "a.txt");
  const std::string manifest = written("case/case.json");
  expectSentences({"case.json", manifest, manifest.size(), [this](const fs::path& file) { return asManifest(file); }},
                  "b.json");
}

TEST_F(ReaderFuzz, AHeaderAloneGetsNoMemoryAndNoPatience) {
  const std::string nrrd = written("case/ct.nrrd");
  const auto instead = [](std::string text, const std::string& what, const std::string& with) {
    EXPECT_NE(text.find(what), std::string::npos);
    return text.replace(text.find(what), what.size(), with);
  };
  test::writeText(folder_ / "large.nrrd", instead(nrrd, "sizes: 8 8 5", "sizes: 1500 1500 1500"));
  EXPECT_THAT(asLabels(folder_ / "large.nrrd"),
              testing::HasSubstr("its header states 6750000000 bytes, but it contains 640"));
  const std::string meta = test::metaImage(patient_.ct, "1 0 0 0 1 0 0 0 1");
  for (const char* dimensions : {"100000", "-1", "many"}) {
    test::writeText(folder_ / "deep.mha", instead(meta, "NDims = 3", std::string("NDims = ") + dimensions));
    EXPECT_THAT(asCt(folder_ / "deep.mha"), testing::HasSubstr(std::string("'") + dimensions + "' dimensions (NDims)"));
  }
  test::writeText(folder_ / "cut.dcm", written("seg.dcm").substr(0, 900));
  EXPECT_THAT(asLabels(folder_ / "cut.dcm"),
              testing::HasSubstr("is not a complete DICOM file: it is cut off or damaged"));
}

}  // namespace
}  // namespace insonate
