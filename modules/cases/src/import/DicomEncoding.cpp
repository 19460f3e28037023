#include "DicomEncoding.h"

#include "DerivedUid.h"

#include <gdcmItem.h>
#include <gdcmSequenceOfItems.h>

#include <array>
#include <cstdio>
#include <ctime>
#include <string_view>
#include <utility>

namespace insonate {
namespace {

using gdcm::Tag;
using gdcm::VR;

std::string decimalString(double value) {
  std::array<char, 40> text;
  for (int digits = 17; digits > 0; --digits) {
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    if (std::string_view(text.data()).size() <= 16) break;
  }
  return text.data();
}

}  // namespace

SeriesUids uidsOf(const DicomSeriesIdentity& identity) {
  return {derivedUid(identity.seed + "/study"), derivedUid(identity.seed + "/series"),
          derivedUid(identity.seed + "/frame of reference")};
}

std::string sliceUid(const SeriesUids& uids, int k) {
  return derivedUid(uids.series + "/" + std::to_string(k));
}

void put(gdcm::DataSet& data, Tag tag, VR::VRType vr, std::string text) {
  if (text.size() % 2 != 0) text += vr == VR::UI ? '\0' : ' ';
  gdcm::DataElement element(tag);
  element.SetVR(vr);
  element.SetByteValue(text.data(), gdcm::VL(static_cast<std::uint32_t>(text.size())));
  data.Replace(element);
}

void putBinary(gdcm::DataSet& data, Tag tag, VR::VRType vr, const void* bytes, std::size_t size) {
  gdcm::DataElement element(tag);
  element.SetVR(vr);
  element.SetByteValue(static_cast<const char*>(bytes), gdcm::VL(static_cast<std::uint32_t>(size)));
  data.Replace(element);
}

void putShorts(gdcm::DataSet& data, Tag tag, std::initializer_list<std::uint16_t> values) {
  putBinary(data, tag, VR::US, values.begin(), values.size() * sizeof(std::uint16_t));
}

void putSequence(gdcm::DataSet& data, Tag tag, const std::vector<gdcm::DataSet>& items) {
  auto sequence = gdcm::SequenceOfItems::New();
  sequence->SetLengthToUndefined();
  for (const gdcm::DataSet& content : items) {
    gdcm::Item item;
    item.SetVLToUndefined();
    item.SetNestedDataSet(content);
    sequence->AddItem(item);
  }
  gdcm::DataElement element(tag);
  element.SetVR(VR::SQ);
  element.SetValue(*sequence);
  element.SetVLToUndefined();
  data.Replace(element);
}

std::string decimalStrings(std::initializer_list<double> values) {
  std::string text;
  for (double v : values) text += (text.empty() ? "" : "\\") + decimalString(v);
  return text;
}

void putTimeOfWriting(gdcm::DataSet& data) {
  std::array<char, 16> day, time;
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  std::strftime(day.data(), day.size(), "%Y%m%d", &utc);
  std::strftime(time.data(), time.size(), "%H%M%S", &utc);
  for (const std::uint16_t element : {0x0021, 0x0023}) put(data, Tag(0x0008, element), VR::DA, day.data());
  for (const std::uint16_t element : {0x0031, 0x0033}) put(data, Tag(0x0008, element), VR::TM, time.data());
}

void putPatientAndStudy(gdcm::DataSet& data, const DicomSeriesIdentity& identity, const SeriesUids& uids) {
  put(data, Tag(0x0010, 0x0010), VR::PN, identity.patientName);
  put(data, Tag(0x0010, 0x0020), VR::LO, identity.patientId);
  put(data, Tag(0x0010, 0x0030), VR::DA, "");
  put(data, Tag(0x0010, 0x0040), VR::CS, "O");
  put(data, Tag(0x0020, 0x000d), VR::UI, uids.study);
  for (const auto& [element, vr] : {std::pair{0x0020, VR::DA}, {0x0030, VR::TM}, {0x0050, VR::SH}, {0x0090, VR::PN}})
    put(data, Tag(0x0008, static_cast<std::uint16_t>(element)), vr, "");
  put(data, Tag(0x0020, 0x0010), VR::SH, "1");
}

}  // namespace insonate
