#pragma once

#include "CaseSamples.h"

#include <insonate/image/Volume.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <utility>

namespace insonate::test {

/// Writes NIfTI-1 with one byte for each voxel, as other programs write masks and label maps. `extension` is the
/// content of a header extension.
inline void writeNiftiMask(const std::filesystem::path& file, const LabelMap& map, const std::string& extension = {}) {
  const VolumeGeometry& g = map.geometry;
  std::string bytes(352 + (extension.empty() ? 0 : 8 + extension.size()), '\0');
  const auto put = [&bytes](std::size_t at, auto value) { std::memcpy(bytes.data() + at, &value, sizeof value); };
  put(0, std::int32_t{348});
  put(40, std::int16_t{3});
  for (int a = 0; a < 3; ++a) {
    put(42 + 2 * a, static_cast<std::int16_t>(g.size[a]));
    put(80 + 4 * a, static_cast<float>(g.spacing_mm[a]));
    const double sign = a < 2 ? -1 : 1;  // NIfTI's frame is right-anterior-superior
    for (int column = 0; column < 3; ++column)
      put(280 + 16 * a + 4 * column, static_cast<float>(sign * g.direction.column[column][a] * g.spacing_mm[column]));
    put(280 + 16 * a + 12, static_cast<float>(sign * g.origin_mm[a]));
  }
  put(70, std::int16_t{2}), put(72, std::int16_t{8});
  put(108, static_cast<float>(bytes.size()));
  put(254, std::int16_t{1});
  bytes.replace(344, 4, std::string("n+1\0", 4));
  if (!extension.empty()) {
    bytes[348] = 1;
    put(352, static_cast<std::int32_t>(8 + extension.size()));
    bytes.replace(360, extension.size(), extension);
  }
  writeText(file, bytes + bytesOf(map.voxels));
}

/// The voxels with this label, as a mask.
inline LabelMap maskOf(const LabelMap& labels, std::uint8_t label) {
  LabelMap mask(labels.geometry);
  for (std::size_t v = 0; v < mask.voxels.size(); ++v) mask.voxels[v] = labels.voxels[v] == label;
  return mask;
}

/// An upright rod with the axis at (x, y), patient LPS.
inline LabelMap rod(const VolumeGeometry& g, double x_mm, double y_mm, double radius_mm) {
  LabelMap mask(g);
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Vec3 at = g.patientFromIndex() * Vec3{double(i), double(j), double(k)};
        mask.at(i, j, k) = std::hypot(at.x - x_mm, at.y - y_mm) <= radius_mm;
      }
  return mask;
}

/// The label table that TotalSegmentator adds to a header.
inline std::string labelTableOf(const std::vector<std::pair<int, std::string>>& names) {
  std::string text = "<CaretExtension><VolumeInformation Index=\"0\"><LabelTable>";
  for (const auto& [number, name] : names)
    text += "<Label Key=\"" + std::to_string(number) + "\" Red=\"1\"><![CDATA[" + name + "]]></Label>";
  return text + "</LabelTable></VolumeInformation></CaretExtension>";
}

}  // namespace insonate::test
