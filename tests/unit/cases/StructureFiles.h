#pragma once

#include "CaseSamples.h"
#include "DicomFiles.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace insonate::test {

using Contour = std::vector<Vec3>;

/// A structure as a planning system would send it.
struct SentStructure {
  std::string name;
  std::vector<Contour> contours;
  std::string type = "ORGAN", geometry = "CLOSED_PLANAR";
};

inline std::string coordinates(const Contour& contour) {
  std::string text;
  char number[64];
  for (const Vec3 p : contour) {
    std::snprintf(number, sizeof number, "%s%.4f\\%.4f\\%.4f", text.empty() ? "" : "\\", p.x, p.y, p.z);
    text += number;
  }
  return text;
}

inline gdcm::DataSet sentContour(const Contour& contour, const std::string& geometry) {
  gdcm::DataSet item;
  setText(item, gdcm::Tag(0x3006, 0x0042), gdcm::VR::CS, geometry);
  setText(item, gdcm::Tag(0x3006, 0x0046), gdcm::VR::IS, std::to_string(contour.size()));
  setText(item, gdcm::Tag(0x3006, 0x0050), gdcm::VR::DS, coordinates(contour));
  return item;
}

/// Writes an RT Structure Set; structure n has the number n + 1. `edit` may damage it.
inline void writeStructureSet(const std::filesystem::path& file, const std::vector<SentStructure>& structures,
                              const std::function<void(gdcm::DataSet&)>& edit = {}) {
  using gdcm::DataSet;
  using gdcm::Tag;
  using gdcm::VR;
  gdcm::Writer writer;
  DataSet& data = writer.GetFile().GetDataSet();
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ImplicitVRLittleEndian);
  setText(data, Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.481.3");
  setText(data, Tag(0x0008, 0x0018), VR::UI, "1.2.3.481");
  setText(data, Tag(0x0008, 0x0060), VR::CS, "RTSTRUCT");
  std::vector<DataSet> rois, contours, observations;
  for (std::size_t n = 0; n < structures.size(); ++n) {
    const std::string number = std::to_string(n + 1);
    DataSet roi, drawn, observation;
    setText(roi, Tag(0x3006, 0x0022), VR::IS, number);
    setText(roi, Tag(0x3006, 0x0026), VR::LO, structures[n].name);
    setText(roi, Tag(0x3006, 0x0036), VR::CS, "MANUAL");
    setText(drawn, Tag(0x3006, 0x002a), VR::IS, "10\\200\\30");
    setText(drawn, Tag(0x3006, 0x0084), VR::IS, number);
    std::vector<DataSet> items;
    for (const Contour& contour : structures[n].contours) items.push_back(sentContour(contour, structures[n].geometry));
    setSequence(drawn, Tag(0x3006, 0x0040), items);
    setText(observation, Tag(0x3006, 0x0084), VR::IS, number);
    setText(observation, Tag(0x3006, 0x00a4), VR::CS, structures[n].type);
    rois.push_back(roi);
    contours.push_back(drawn);
    observations.push_back(observation);
  }
  setSequence(data, Tag(0x3006, 0x0020), rois);
  setSequence(data, Tag(0x3006, 0x0039), contours);
  setSequence(data, Tag(0x3006, 0x0080), observations);
  if (edit) edit(data);
  writer.SetFileName(file.c_str());
  if (!writer.Write()) throw std::runtime_error("unwritable " + file.string());
}

/// Regular polygon around an axis along z; its area is that of the circle.
inline Contour circle(Vec3 center_mm, double radius_mm, int corners = 180) {
  const double step = 2 * std::numbers::pi / corners;
  const double corner_mm = radius_mm * std::sqrt(step / std::sin(step));
  Contour contour;
  for (int n = 0; n < corners; ++n)
    contour.push_back(center_mm + corner_mm * Vec3{std::cos(n * step), std::sin(n * step), 0});
  return contour;
}

inline std::vector<Contour> ball(Vec3 center_mm, double radius_mm, const std::vector<double>& z_mm) {
  std::vector<Contour> contours;
  for (const double z : z_mm)
    if (const double away_mm = z - center_mm.z; std::abs(away_mm) < radius_mm)
      contours.push_back(circle({center_mm.x, center_mm.y, z}, std::sqrt(radius_mm * radius_mm - away_mm * away_mm)));
  return contours;
}

}  // namespace insonate::test
