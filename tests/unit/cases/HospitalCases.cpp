#include "HospitalCases.h"

#include "HospitalSlices.h"

#include <insonate/cases/DicomSegmentation.h>

#include <numbers>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;

std::vector<HospitalSlice> plain(int count = 6) {
  return axial(levels(count, 2));
}

void editAll(const fs::path& folder, const std::function<void(DataSet&)>& edit) {
  for (const auto& entry : fs::directory_iterator(folder)) editDicom(entry.path(), edit);
}

/// The gantry leans; the table moves along z. The tag says that nothing leans, as some scanners' do.
void tilted(const fs::path& folder, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  auto slices = plain();
  for (HospitalSlice& s : slices) s.orientation[1] = {0, std::cos(angle), std::sin(angle)};
  writeSlices(folder, slices);
  editAll(folder, [](DataSet& data) { setText(data, Tag(0x0018, 0x1120), VR::DS, "0"); });
}

void tiltedWithGap(const fs::path& folder) {
  tilted(folder, 15);
  fs::remove(folder / "i1-1-3");
}

void withThickness(const fs::path& folder, const char* thickness, const char* between) {
  auto slices = plain();
  for (HospitalSlice& s : slices) s.thickness = thickness;
  writeSlices(folder, slices);
  editAll(folder, [&](DataSet& data) { setText(data, Tag(0x0018, 0x0088), VR::DS, between); });
}

void withRescale(const fs::path& folder, double slope, double intercept, bool isSigned) {
  auto slices = plain();
  for (HospitalSlice& s : slices) s.slope = slope, s.intercept = intercept, s.isSigned = isSigned;
  writeSlices(folder, slices);
}

void mixedFolder(const fs::path& folder) {
  writeSlices(folder / "ct", plain());
  const auto stray = [&](const char* name, Tag tag, VR::VRType vr, const char* value) {
    writeSlice(folder / name, plain().front());
    editDicom(folder / name, [&](DataSet& data) { setText(data, tag, vr, value); });
  };
  stray("scout", Tag(0x0008, 0x0008), VR::CS, "ORIGINAL\\PRIMARY\\LOCALIZER");
  stray("capture", Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.7");
  stray("report", Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.88.22");
  stray("DICOMDIR", Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.1.3.10");
  stray("plan", Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.481.3");
  stray("acr-nema", Tag(0x0008, 0x0010), VR::UN, "NONE");
  PatientCase labeled = noiseCase(grid({8, 8, 2}));
  if (auto ok = writeDicomSegmentation(labeled, folder / "seg.dcm"); !ok) throw std::runtime_error(ok.error().message);
  writeText(folder / "README.TXT", "Viewer on this disk");
  writeText(folder / "study.zip", std::string("PK\3\4", 4) + "and so on");
  writeText(folder / "slice.dcm.gz", "\x1f\x8b and so on");
  writeText(folder / "broken.dcm", "not DICOM");
}

void duplicates(const fs::path& folder, bool explained) {
  writeSlices(folder, plain());
  HospitalSlice again = plain()[2];
  again.instanceUid = explained ? "1.2.3.1.1.3" : "1.2.3.9";
  writeSlice(folder / "again", again);
}

void oneInstanceUid(const fs::path& folder) {
  auto slices = plain();
  for (HospitalSlice& s : slices) s.instanceUid = "1.2.3.9";
  writeSlices(folder, slices);
}

/// The same slices once more under the same numbers; their names on the disk are in another order.
/// As in public collections: the program that removed the identity gave each slice its own Frame of Reference UID.
void frameOfEachSlice(const fs::path& folder, int slices) {
  writeSlices(folder, plain(slices));
  int frame = 0;
  editAll(folder,
          [&](DataSet& data) { setText(data, Tag(0x0020, 0x0052), VR::UI, "1.2.3.4." + std::to_string(++frame)); });
}

/// Between the slices of the first scan lie those of a second one, which have one frame of reference.
void frameOfEachSliceAndAnotherScan(const fs::path& folder) {
  frameOfEachSlice(folder / "a", 30);
  auto second = axial(levels(12, 3));
  for (HospitalSlice& s : second) s.position_mm.z += 0.7, s.acquisition = 2;
  writeSlices(folder / "b", second);
}

void reconstructedTwice(const fs::path& folder, bool named) {
  for (const bool sharp : {false, true}) {
    auto slices = plain();
    fs::create_directories(folder);
    for (HospitalSlice& s : slices) {
      s.instanceUid = (sharp ? "1.2.3.8." : "1.2.3.7.") + std::to_string(s.instance);
      if (sharp) s.intercept = -1024;
      const fs::path file = folder / (std::to_string(s.instance) + (sharp == (s.instance % 2 == 0) ? "a" : "b"));
      writeSlice(file, s);
      if (named)
        editDicom(file, [&](DataSet& data) { setText(data, Tag(0x0018, 0x1210), VR::SH, sharp ? "B70f" : "B30f"); });
    }
  }
}

void sharperAbove(const fs::path& folder) {
  writeSlices(folder, plain());
  for (const char* name : {"i1-1-5", "i1-1-6"})
    editDicom(folder / name, [](DataSet& data) { setText(data, Tag(0x0018, 0x1210), VR::SH, "B70f"); });
}

void twoSeriesOneNumber(const fs::path& folder) {
  writeSlices(folder / "a", plain());
  auto other = axial(levels(4, 3));
  for (HospitalSlice& s : other) s.series = "1.2.3.2", s.position_mm.x = 40;
  writeSlices(folder / "b", other);
}

void interleaved(const fs::path& folder) {
  auto slices = plain(8);
  for (std::size_t n = 0; n < slices.size(); ++n) slices[n].acquisition = 1 + static_cast<int>(n % 2);
  writeSlices(folder, slices);
}

void unsortedNames(const fs::path& folder) {
  fs::create_directories(folder);
  const auto slices = plain();
  const char* names[] = {"IM10", "IM2", "a", "IM1", "z.dcm", "0"};
  for (std::size_t n = 0; n < slices.size(); ++n) writeSlice(folder / names[n], slices[n]);
}

void orientationNoise(const fs::path& folder) {
  auto slices = plain();
  for (std::size_t n = 0; n < slices.size(); ++n) slices[n].orientation[0].y = n % 2 ? 2e-5 : -2e-5;
  writeSlices(folder, slices);
}

/// As around the discs of a spine.
void twoDegreeSteps(const fs::path& folder) {
  auto slices = plain(9);
  for (std::size_t n = 0; n < slices.size(); ++n) {
    const double angle = static_cast<double>(n / 3) * 2 * std::numbers::pi / 180;
    slices[n].orientation[1] = {0, std::cos(angle), std::sin(angle)};
    slices[n].position_mm =
        Vec3{-10, -20, 50} + 2.0 * static_cast<double>(n) * cross({1, 0, 0}, slices[n].orientation[1]);
  }
  writeSlices(folder, slices);
}

void sagittalLeftHanded(const fs::path& folder) {
  std::vector<HospitalSlice> slices;
  for (int n = 0; n < 5; ++n) {
    // Rows run back, columns down; slices are numbered against the normal.
    slices.push_back({{-10.0 + 3 * n, -20, 60}, {Vec3{0, 1, 0}, Vec3{0, 0, -1}}});
    slices.back().instance = n + 1;
  }
  writeSlices(folder, slices);
}

void feetFirst(const fs::path& folder) {
  auto slices = axial({60, 58, 56, 54, 52});
  for (HospitalSlice& s : slices) s.orientation = {Vec3{-1, 0, 0}, Vec3{0, 1, 0}}, s.position_mm.x = 10;
  writeSlices(folder, slices);
  editAll(folder, [](DataSet& data) { setText(data, Tag(0x0018, 0x5100), VR::CS, "FFS"); });
}

void padded(const fs::path& folder) {
  writeSlices(folder, plain());
  editAll(folder, [](DataSet& data) {
    std::string bytes(data.GetDataElement(Tag(0x7fe0, 0x0010)).GetByteValue()->GetPointer(), 20 * 16 * 2);
    const std::int16_t padding = -3024;
    std::memcpy(bytes.data(), &padding, sizeof padding);
    gdcm::DataElement pixels(Tag(0x7fe0, 0x0010));
    pixels.SetVR(VR::OW);
    pixels.SetByteValue(bytes.data(), gdcm::VL(std::uint32_t(bytes.size())));
    data.Replace(pixels);
  });
}

void slopeOfEachSlice(const fs::path& folder) {
  auto slices = plain();
  for (std::size_t n = 0; n < slices.size(); ++n) {
    slices[n].slope = 0.25 * static_cast<double>(n + 1);
    slices[n].intercept = -100.0 * static_cast<double>(n);
  }
  writeSlices(folder, slices);
}

void withoutRescaleInOne(const fs::path& folder) {
  withRescale(folder, 1, -1024, false);
  editDicom(folder / "i1-1-2", [](DataSet& data) { data.Remove(Tag(0x0028, 0x1052)); });
}

void otherScaleInOne(const fs::path& folder) {
  auto slices = plain();
  for (HospitalSlice& s : slices) s.slope = 1, s.intercept = -1024, s.isSigned = false;
  slices[2].slope = 2, slices[2].intercept = -1000;
  writeSlices(folder, slices);
}

void withSlopeOfZero(const fs::path& folder) {
  writeSlices(folder, plain());
  editAll(folder, [](DataSet& data) { setText(data, Tag(0x0028, 0x1053), VR::DS, "0"); });
}

void withLookupTable(const fs::path& folder) {
  writeSlices(folder, plain());
  editAll(folder, [](DataSet& data) {
    DataSet table;
    setText(table, Tag(0x0028, 0x3004), VR::LO, "HU");
    setSequence(data, Tag(0x0028, 0x3000), {table});
  });
}

void withoutPixelSpacing(const fs::path& folder) {
  writeSlices(folder, plain());
  editAll(folder, [](DataSet& data) {
    data.Remove(Tag(0x0028, 0x0030));
    setText(data, Tag(0x0018, 0x1164), VR::DS, "1\\1");  // at the detector, not in the patient
  });
}

void nonSquare(const fs::path& folder) {
  auto slices = plain();
  for (HospitalSlice& s : slices) s.betweenRows_mm = 0.6, s.betweenColumns_mm = 0.9;
  writeSlices(folder, slices);
}

void truncated(const fs::path& folder) {
  writeSlices(folder, plain());
  const fs::path file = folder / "i1-1-4";
  const std::string whole = contentOf(file);
  writeText(file, whole.substr(0, whole.size() - 101));
}

void lossyInOtherUnits(const fs::path& folder) {
  writeSlices(folder, plain());
  editAll(folder, [](DataSet& data) {
    setText(data, Tag(0x0028, 0x2110), VR::CS, "01");
    setText(data, Tag(0x0028, 0x1054), VR::LO, "US");
  });
}

}  // namespace

const std::vector<HospitalCase>& hospitalCases() {
  static const std::vector<HospitalCase> kCases{
      {"tilt-plus-15", [](const fs::path& f) { tilted(f, 15); }},
      {"tilt-minus-15", [](const fs::path& f) { tilted(f, -15); }},
      {"tilt-and-gap", tiltedWithGap},
      {"variable-spacing",
       [](const fs::path& f) {
         writeSlices(f, axial({0, 3, 6, 9, 10.3, 11.6, 12.9}));
       }},
      {"missing-slices",
       [](const fs::path& f) {
         writeSlices(f, axial({0, 2, 4, 8, 10, 14, 16}));
       }},
      {"large-gap",
       [](const fs::path& f) {
         writeSlices(f, axial({0, 2, 4, 6, 20, 22, 24}));
       }},
      {"thicker-than-spacing", [](const fs::path& f) { withThickness(f, "5", "2"); }},
      {"thinner-than-spacing", [](const fs::path& f) { withThickness(f, "0.6", "2"); }},
      {"negative-spacing-between-slices", [](const fs::path& f) { withThickness(f, "2", "-2"); }},
      {"two-series-one-number", twoSeriesOneNumber},
      {"mixed-folder", mixedFolder},
      {"copied-slice", [](const fs::path& f) { duplicates(f, true); }},
      {"unexplained-duplicate", [](const fs::path& f) { duplicates(f, false); }},
      {"one-instance-uid", oneInstanceUid},
      {"frame-of-each-slice", [](const fs::path& f) { frameOfEachSlice(f, 275); }},
      {"frame-of-each-slice-and-another-scan", frameOfEachSliceAndAnotherScan},
      {"kernels-under-one-uid", [](const fs::path& f) { reconstructedTwice(f, true); }},
      {"numbers-twice", [](const fs::path& f) { reconstructedTwice(f, false); }},
      {"kernel-changes-within", sharperAbove},
      {"interleaved-blocks", interleaved},
      {"unsorted-names", unsortedNames},
      {"one-slice", [](const fs::path& f) { writeSlices(f, plain(1)); }},
      {"two-slices", [](const fs::path& f) { writeSlices(f, plain(2)); }},
      {"orientation-noise", orientationNoise},
      {"two-degree-steps", twoDegreeSteps},
      {"sagittal-left-handed", sagittalLeftHanded},
      {"feet-first", feetFirst},
      {"intercept-minus-1000", [](const fs::path& f) { withRescale(f, 1, -1000, false); }},
      {"intercept-minus-1024", [](const fs::path& f) { withRescale(f, 1, -1024, false); }},
      {"padding-minus-3024", padded},
      {"slope-of-each-slice", slopeOfEachSlice},
      {"other-scale-in-one", otherScaleInOne},
      {"rescale-missing-in-one", withoutRescaleInOne},
      {"slope-of-zero", withSlopeOfZero},
      {"lookup-table", withLookupTable},
      {"no-pixel-spacing", withoutPixelSpacing},
      {"non-square-pixels", nonSquare},
      {"non-ascii-path", [](const fs::path& f) { writeSlices(f / "Größe 患者 ёж", plain()); }},
      {"truncated-pixels", truncated},
      {"lossy-in-other-units", lossyInOtherUnits},
  };
  return kCases;
}

}  // namespace insonate::test
