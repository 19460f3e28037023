#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Hash.h>
#include <insonate/tissue/Labels.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

namespace insonate::test {

/// Rotation about a slanted axis: no component is 0 or 1.
inline Mat3 obliqueDirection() {
  const Vec3 u = normalized({1, 2, 3});
  const double c = std::cos(0.4), s = std::sin(0.4);
  Mat3 m;
  for (int col = 0; col < 3; ++col) {
    Vec3 e;
    e[col] = 1;
    m.column[col] = c * e + s * cross(u, e) + (1 - c) * dot(u, e) * u;
  }
  return m;
}

inline VolumeGeometry grid(std::array<int, 3> size, Vec3 spacing_mm = {1, 1, 1}, Vec3 origin_mm = {}) {
  VolumeGeometry g;
  g.size = size;
  g.spacing_mm = spacing_mm;
  g.origin_mm = origin_mm;
  return g;
}

inline CtVolume noiseCt(const VolumeGeometry& g) {
  CtVolume ct(g);
  for (std::size_t v = 0; v < ct.voxels.size(); ++v)
    ct.voxels[v] = static_cast<std::int16_t>(hash32(static_cast<std::uint32_t>(v)) % 4000 - 1024);
  return ct;
}

inline PatientCase noiseCase(const VolumeGeometry& g) {
  PatientCase patient;
  patient.ct = noiseCt(g);
  patient.labels = LabelMap(g);
  for (std::size_t v = 0; v < patient.labels.voxels.size(); ++v)
    patient.labels.voxels[v] = static_cast<std::uint8_t>(hash32(static_cast<std::uint32_t>(v) + 7) % kLabelCount);
  return patient;
}

/// An upright cylinder of muscle in skin with a spine, an airway and two vessels, in air: everything a check wants.
/// 1 mm voxels, patient LPS, axis at x = y = 0.
inline PatientCase cylinderNeck() {
  PatientCase patient;
  patient.ct = CtVolume(grid({121, 121, 61}, {1, 1, 1}, {-60, -60, -30}), -1000);
  patient.labels = LabelMap(patient.ct.geometry);
  struct Rod {
    double x, y, radius;
    std::uint8_t label;
    std::int16_t hu;
  };
  const Rod rods[] = {{0, 0, 50, kSkin, 20},       {0, 0, 48, kMuscle, 55},    {0, 25, 12, kBone, 600},
                      {0, -25, 8, kAirway, -1000}, {-16, -20, 4, kArtery, 45}, {-30, -22, 7, kVein, 45}};
  for (int k = 0; k < 61; ++k)
    for (int j = 0; j < 121; ++j)
      for (int i = 0; i < 121; ++i)
        for (const Rod& rod : rods)
          if (std::hypot(i - 60 - rod.x, j - 60 - rod.y) <= rod.radius) {
            patient.labels.at(i, j, k) = rod.label;
            patient.ct.at(i, j, k) = rod.hu;
          }
  patient.manifest.targets = {{"right internal jugular vein", kVein, {-30, -22, 0}}};
  patient.manifest.startPoses = {{"front", {0, -50, 0}, {0, 1, 0}, {1, 0, 0}}};
  patient.manifest.vessels = {{"right internal jugular vein", kVein, {{{-30, -22, -20}, 6}, {{-30, -22, 20}, 6}}}};
  patient.manifest.difficulty = "easy";
  patient.manifest.landmarks = {{"puncture_site", "puncture site", {-30, -40, 0}},
                                {"cricoid", "cricoid", {0, -34, 0}},
                                {"clavicle_right", "clavicle", {-20, -30, -29}}};
  return patient;
}

inline std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void writeText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// A raw NRRD as any program might write it: `fields` are the header's lines after the magic number.
inline void writeRawNrrd(const std::filesystem::path& file, const std::string& fields, const std::string& bytes) {
  writeText(file, "NRRD0004\n" + fields + "encoding: raw\nendian: little\n\n" + bytes);
}

template <class T>
std::string bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace insonate::test
