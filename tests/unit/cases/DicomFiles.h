#pragma once

#include <gdcmReader.h>
#include <gdcmWriter.h>

#include <filesystem>
#include <functional>
#include <string>

namespace insonate::test {

/// Replaces an element's text, padded to even length.
inline void setText(gdcm::DataSet& data, gdcm::Tag tag, gdcm::VR::VRType vr, std::string text) {
  if (text.size() % 2) text += vr == gdcm::VR::UI ? '\0' : ' ';
  gdcm::DataElement element(tag);
  element.SetVR(vr);
  element.SetByteValue(text.data(), gdcm::VL(static_cast<std::uint32_t>(text.size())));
  data.Replace(element);
}

inline void setShort(gdcm::DataSet& data, gdcm::Tag tag, gdcm::VR::VRType vr, std::int16_t value) {
  gdcm::DataElement element(tag);
  element.SetVR(vr);
  element.SetByteValue(reinterpret_cast<const char*>(&value), gdcm::VL(2));
  data.Replace(element);
}

inline void setSequence(gdcm::DataSet& data, gdcm::Tag tag, const std::vector<gdcm::DataSet>& items) {
  auto sequence = gdcm::SequenceOfItems::New();
  sequence->SetLengthToUndefined();
  for (const gdcm::DataSet& content : items) {
    gdcm::Item item;
    item.SetVLToUndefined();
    item.SetNestedDataSet(content);
    sequence->AddItem(item);
  }
  gdcm::DataElement element(tag);
  element.SetVR(gdcm::VR::SQ);
  element.SetValue(*sequence);
  element.SetVLToUndefined();
  data.Replace(element);
}

/// Reads a file, lets `edit` change its elements, and writes it back.
inline void editDicom(const std::filesystem::path& file, const std::function<void(gdcm::DataSet&)>& edit) {
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) throw std::runtime_error("unreadable " + file.string());
  edit(reader.GetFile().GetDataSet());
  gdcm::Writer writer;
  writer.SetFile(reader.GetFile());
  writer.SetFileName((file.string() + ".new").c_str());
  if (!writer.Write()) throw std::runtime_error("unwritable " + file.string());
  std::filesystem::rename(file.string() + ".new", file);
}

}  // namespace insonate::test
