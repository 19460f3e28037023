#pragma once

#include "CaseSamples.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

namespace insonate::test {

/// An sform for voxels of 0.5 x 0.75 x 2 mm at LPS (-10, 20, 30): LPS (x, y, z) is (-x, -y, z) in NIfTI's frame.
inline constexpr std::array<std::array<float, 4>, 3> kRas{{{-0.5F, 0, 0, 10}, {0, -0.75F, 0, -20}, {0, 0, 2, 30}}};

template <class T>
void putAt(std::string& bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

/// The smallest NIfTI-1: int16, with an sform in NIfTI's own right-anterior-superior frame.
inline std::string niftiOf(const CtVolume& ct, std::array<std::array<float, 4>, 3> sform, float slope,
                           float intercept) {
  std::string header(352, '\0');
  putAt<std::int32_t>(header, 0, 348);
  const auto& size = ct.geometry.size;
  const std::int16_t dim[8] = {3, std::int16_t(size[0]), std::int16_t(size[1]), std::int16_t(size[2]), 1, 1, 1, 1};
  std::memcpy(header.data() + 40, dim, sizeof dim);
  putAt<std::int16_t>(header, 70, 4);   // DT_INT16
  putAt<std::int16_t>(header, 72, 16);  // bits
  const Vec3 spacing = ct.geometry.spacing_mm;
  const float pixdim[4] = {1, float(spacing.x), float(spacing.y), float(spacing.z)};
  std::memcpy(header.data() + 76, pixdim, sizeof pixdim);
  putAt<float>(header, 108, 352);
  putAt<float>(header, 112, slope);
  putAt<float>(header, 116, intercept);
  putAt<char>(header, 123, 2);          // millimeters
  putAt<std::int16_t>(header, 254, 1);  // sform: scanner
  for (int row = 0; row < 3; ++row) std::memcpy(header.data() + 280 + 16 * row, sform[row].data(), 16);
  std::memcpy(header.data() + 344, "n+1", 4);
  return header + bytesOf(ct.voxels);
}

/// The same image as another machine writes it, in the other byte order.
inline std::string swappedNifti(std::string bytes) {
  const auto swap = [&](std::size_t from, std::size_t count, std::size_t width) {
    for (std::size_t n = 0; n < count; ++n)
      std::reverse(bytes.begin() + static_cast<long>(from + n * width),
                   bytes.begin() + static_cast<long>(from + (n + 1) * width));
  };
  swap(0, 1, 4);
  swap(40, 8, 2);
  swap(70, 2, 2);
  swap(76, 11, 4);  // pixdim, vox_offset, slope, intercept
  swap(252, 2, 2);
  swap(256, 18, 4);
  swap(352, (bytes.size() - 352) / 2, 2);
  return bytes;
}

/// NIfTI-2, with wider fields at other places.
inline std::string secondNiftiOf(const CtVolume& ct, const std::array<std::array<float, 4>, 3>& sform) {
  std::string header(544, '\0');
  putAt<std::int32_t>(header, 0, 540);
  std::memcpy(header.data() + 4, "n+2\0\r\n\x1a\n", 8);
  putAt<std::int16_t>(header, 12, 4);
  putAt<std::int16_t>(header, 14, 16);
  putAt<std::int64_t>(header, 16, 3);
  for (int n = 0; n < 3; ++n) putAt<std::int64_t>(header, 24 + 8 * static_cast<std::size_t>(n), ct.geometry.size[n]);
  putAt<std::int64_t>(header, 168, 544);
  putAt<std::int32_t>(header, 348, 1);
  for (std::size_t n = 0; n < 12; ++n) putAt<double>(header, 400 + 8 * n, sform[n / 4][n % 4]);
  putAt<std::int32_t>(header, 500, 2);
  return header + bytesOf(ct.voxels);
}

/// A MetaImage's header but for its last line, ElementDataFile.
inline std::string metaHeader(const VolumeGeometry& g, const std::string& matrix, const std::string& type = "MET_SHORT",
                              const std::string& compression = "CompressedData = False\n") {
  std::string text = "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" +
                     compression + "TransformMatrix = " + matrix + "\nOffset =";
  for (int a = 0; a < 3; ++a) text += " " + std::to_string(g.origin_mm[a]);
  text += "\nElementSpacing =";
  for (int a = 0; a < 3; ++a) text += " " + std::to_string(g.spacing_mm[a]);
  text += "\nDimSize =";
  for (int n : g.size) text += " " + std::to_string(n);
  return text + "\nElementType = " + type + "\n";
}

inline std::string metaImage(const CtVolume& ct, const std::string& matrix, const std::string& type = "MET_SHORT") {
  return metaHeader(ct.geometry, matrix, type) + "ElementDataFile = LOCAL\n" + bytesOf(ct.voxels);
}

}  // namespace insonate::test
