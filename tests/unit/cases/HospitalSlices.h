#pragma once

#include "CaseSamples.h"
#include "DicomFiles.h"

#include <insonate/cases/DicomWriter.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate::test {

/// HU as a linear function of place in the patient: whatever an import does to the grid, linear interpolation keeps it.
inline double rampHu(Vec3 p_mm) {
  return 300 + 4 * p_mm.x - 3 * p_mm.y + 2 * p_mm.z;
}

/// One slice as a scanner would send it. Its pixels hold rampHu.
struct HospitalSlice {
  Vec3 position_mm;
  std::array<Vec3, 2> orientation{Vec3{1, 0, 0}, Vec3{0, 1, 0}};  ///< along a row, down a column
  int columns = 20, rows = 16;
  double betweenRows_mm = 1, betweenColumns_mm = 1;
  double slope = 1, intercept = 0;
  bool isSigned = true;
  int instance = 1, acquisition = 1, seriesNumber = 1;
  std::string series = "1.2.3.1", study = "1.2.3", instanceUid = {};
  std::string thickness = "2";
};

inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

inline std::vector<std::int16_t> storedRamp(const HospitalSlice& s) {
  std::vector<std::int16_t> stored;
  for (int j = 0; j < s.rows; ++j)
    for (int i = 0; i < s.columns; ++i) {
      const Vec3 place =
          s.position_mm + i * s.betweenColumns_mm * s.orientation[0] + j * s.betweenRows_mm * s.orientation[1];
      stored.push_back(static_cast<std::int16_t>(std::lround((rampHu(place) - s.intercept) / s.slope)));
    }
  return stored;
}

/// Replaces what the slice says by what `s` says.
inline void setSlice(gdcm::DataSet& data, const HospitalSlice& s) {
  using gdcm::Tag;
  using gdcm::VR;
  const auto joined = [](std::initializer_list<double> values) {
    std::string text;
    for (const double v : values) text += (text.empty() ? "" : "\\") + number(v);
    return text;
  };
  const auto& [i, j] = s.orientation;
  setText(data, Tag(0x0020, 0x000d), VR::UI, s.study);
  setText(data, Tag(0x0020, 0x000e), VR::UI, s.series);
  const std::string own = s.series + "." + std::to_string(s.acquisition) + "." + std::to_string(s.instance);
  setText(data, Tag(0x0008, 0x0018), VR::UI, s.instanceUid.empty() ? own : s.instanceUid);
  setText(data, Tag(0x0020, 0x0011), VR::IS, std::to_string(s.seriesNumber));
  setText(data, Tag(0x0020, 0x0012), VR::IS, std::to_string(s.acquisition));
  setText(data, Tag(0x0020, 0x0013), VR::IS, std::to_string(s.instance));
  setText(data, Tag(0x0020, 0x0032), VR::DS, joined({s.position_mm.x, s.position_mm.y, s.position_mm.z}));
  setText(data, Tag(0x0020, 0x0037), VR::DS, joined({i.x, i.y, i.z, j.x, j.y, j.z}));
  setText(data, Tag(0x0028, 0x0030), VR::DS, joined({s.betweenRows_mm, s.betweenColumns_mm}));
  setText(data, Tag(0x0028, 0x1052), VR::DS, number(s.intercept));
  setText(data, Tag(0x0028, 0x1053), VR::DS, number(s.slope));
  setText(data, Tag(0x0018, 0x0050), VR::DS, s.thickness);
  setShort(data, Tag(0x0028, 0x0103), VR::US, s.isSigned ? 1 : 0);
  const std::vector<std::int16_t> stored = storedRamp(s);
  gdcm::DataElement pixels(Tag(0x7fe0, 0x0010));
  pixels.SetVR(VR::OW);
  pixels.SetByteValue(reinterpret_cast<const char*>(stored.data()), gdcm::VL(std::uint32_t(stored.size() * 2)));
  data.Replace(pixels);
}

inline void writeSlice(const std::filesystem::path& file, const HospitalSlice& s) {
  const std::filesystem::path beside = file.string() + ".made";
  const auto made =
      writeDicomSeries(CtVolume(grid({s.columns, s.rows, 1})), beside, {.seed = "hospital", .description = {}});
  if (!made) throw std::runtime_error(made.error().message);
  std::filesystem::rename(beside / "slice00001.dcm", file);
  std::filesystem::remove(beside);
  editDicom(file, [&](gdcm::DataSet& data) { setSlice(data, s); });
}

/// Axial slices at these levels, numbered from 1 in this order.
inline std::vector<HospitalSlice> axial(const std::vector<double>& z_mm) {
  std::vector<HospitalSlice> slices;
  for (const double z : z_mm) {
    slices.push_back({{-10, -20, z}});
    slices.back().instance = static_cast<int>(slices.size());
  }
  return slices;
}

inline std::vector<double> levels(int count, double step_mm) {
  std::vector<double> z;
  for (int n = 0; n < count; ++n) z.push_back(50 + n * step_mm);
  return z;
}

inline void writeSlices(const std::filesystem::path& folder, const std::vector<HospitalSlice>& slices) {
  std::filesystem::create_directories(folder);
  for (const HospitalSlice& s : slices)
    writeSlice(folder / ("i" + std::to_string(s.seriesNumber) + "-" + std::to_string(s.acquisition) + "-" +
                         std::to_string(s.instance)),
               s);
}

}  // namespace insonate::test
