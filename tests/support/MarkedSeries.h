#pragma once

#include "unit/cases/HospitalSlices.h"

#include <gdcmDict.h>
#include <gdcmDicts.h>
#include <gdcmGlobal.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace insonate::test {

/// Marks planted in every place that could name a patient; no part of them occurs by itself.
inline const std::vector<std::string> kMarks{"ZQXMARK", "19470311", "031417.25", "1.2.999.31337", "-77.123456"};

/// False for what the geometry and the pixels of a slice are read from, and for what makes it no DICOM.
inline bool mayBeMarked(gdcm::Tag tag) {
  if (tag.GetGroup() < 8 || tag.GetGroup() % 2 || tag.GetGroup() == 0x0028 || tag.GetGroup() >= 0x7000) return false;
  if (tag.GetGroup() == 0xfffe || tag.GetElement() == 0) return false;
  for (const gdcm::Tag& needed :
       {gdcm::Tag(0x0008, 0x0001), gdcm::Tag(0x0008, 0x0010), gdcm::Tag(0x0008, 0x0005), gdcm::Tag(0x0008, 0x0008),
        gdcm::Tag(0x0008, 0x0016), gdcm::Tag(0x0008, 0x0018), gdcm::Tag(0x0008, 0x0060), gdcm::Tag(0x0018, 0x0050),
        gdcm::Tag(0x0020, 0x0012), gdcm::Tag(0x0020, 0x0013), gdcm::Tag(0x0020, 0x0032), gdcm::Tag(0x0020, 0x0037),
        gdcm::Tag(0x5200, 0x9230)})
    if (tag == needed) return false;
  return true;
}

/// The mark of a representation of values; empty for binary numbers.
inline std::string markFor(gdcm::VR vr, gdcm::Tag tag) {
  const std::string place = std::to_string(tag.GetElementTag());
  switch (static_cast<gdcm::VR::VRType>(vr)) {
    case gdcm::VR::DA:
      return "19470311";
    case gdcm::VR::TM:
      return "031417.25";
    case gdcm::VR::DT:
      return "19470311031417.25";
    case gdcm::VR::UI:
      return "1.2.999.31337." + place;
    case gdcm::VR::DS:
      return "-77.123456";
    case gdcm::VR::PN:
      return "ZQXMARK^" + place;
    case gdcm::VR::AE:
    case gdcm::VR::CS:
    case gdcm::VR::SH:
      return "ZQXMARK" + place.substr(0, 8);
    case gdcm::VR::IS:
      return "819470311";
    case gdcm::VR::OB:
    case gdcm::VR::OB_OW:
    case gdcm::VR::OW:
    case gdcm::VR::UN:
    case gdcm::VR::LO:
    case gdcm::VR::LT:
    case gdcm::VR::ST:
    case gdcm::VR::UT:
    case gdcm::VR::UC:
    case gdcm::VR::UR:
      return "ZQXMARK " + place;
    default:
      return {};
  }
}

/// Every text, date and number of the dictionary, private elements, overlays, and sequences that hold the same again:
/// more than the basic profile of DICOM PS3.15 Annex E names. Returns how many were planted.
inline int plantMarks(gdcm::DataSet& data) {
  using gdcm::Tag;
  using gdcm::VR;
  gdcm::DataSet nested;
  setText(nested, Tag(0x0010, 0x0010), VR::PN, "ZQXMARK^NESTED");
  setText(nested, Tag(0x0020, 0x9158), VR::LT, "ZQXMARK frame comment");
  setText(nested, Tag(0x0018, 0x9074), VR::DT, "19470311031417.25");
  int planted = 0;
  const gdcm::Dict& dictionary = gdcm::Global::GetInstance().GetDicts().GetPublicDict();
  for (auto entry = dictionary.Begin(); entry != dictionary.End(); ++entry) {
    const auto& [tag, what] = *entry;
    if (!mayBeMarked(tag)) continue;
    if (what.GetVR() == VR::SQ) {
      setSequence(data, tag, {nested});
      ++planted;
    } else if (const std::string mark = markFor(what.GetVR(), tag); !mark.empty()) {
      setText(data, tag, what.GetVR(), mark);
      ++planted;
    }
  }
  setText(data, Tag(0x0009, 0x0010), VR::LO, "ZQXMARK PRIVATE");
  setText(data, Tag(0x0009, 0x1001), VR::UT, "ZQXMARK private text");
  setText(data, Tag(0x0028, 0x1055), VR::LO, "ZQXMARK window");
  gdcm::DataSet lut;
  setText(lut, Tag(0x0028, 0x3003), VR::LO, "ZQXMARK lookup table");
  setSequence(data, Tag(0x0028, 0x3010), {lut});
  setText(data, Tag(0xfffc, 0xfffc), VR::OB, "ZQXMARK padding");
  setText(data, Tag(0x6000, 0x0022), VR::LO, "ZQXMARK overlay");
  setText(data, Tag(0x6000, 0x1500), VR::LO, "ZQXMARK overlay label");
  gdcm::DataSet functional = nested;
  setSequence(functional, Tag(0x0020, 0x9111), {nested});
  setSequence(data, Tag(0x5200, 0x9229), {functional});
  return planted;
}

/// A series whose every attribute, file and folder names a patient.
inline int writeMarkedSeries(const std::filesystem::path& folder, std::vector<HospitalSlice> slices) {
  const std::filesystem::path named = folder / "ZQXMARK^Jane 19470311";
  std::filesystem::create_directories(named);
  int planted = 0;
  for (std::size_t n = 0; n < slices.size(); ++n) {
    slices[n].instanceUid = "1.2.999.31337.8." + std::to_string(n + 1);
    slices[n].instance = static_cast<int>(n) + 1;
    const std::filesystem::path file = named / ("ZQXMARK slice " + std::to_string(n) + ".dcm");
    writeSlice(file, slices[n]);
    editDicom(file, [&](gdcm::DataSet& data) { planted = plantMarks(data); });
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary) << "ZQXMARK in the preamble";
  }
  return planted;
}

inline int writeMarkedSeries(const std::filesystem::path& folder, int count) {
  return writeMarkedSeries(folder, axial(levels(count, 2)));
}

}  // namespace insonate::test
