#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/tissue/AcousticTable.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace insonate {

/// A periodic block of fine tissue structure that a CT does not resolve. Axes: u (along fibers), v, and w (thin,
/// perpendicular to sheets). Values are -127 to 127 for -1 to 1, and are multiplied by a tissue's texture strength in
/// dB. Sizes are powers of two, so that a position can be wrapped with a mask.
struct TextureTile {
  /// Number of padding voxels after each row along w and each plane of rows. The padding repeats the row's beginning,
  /// so that a voxel and the next voxels can be loaded as one word. The padding also avoids cache conflicts between
  /// rows, whose length is a power of two.
  static constexpr int kGap = 64;

  std::array<int, 3> size{};
  Vec3 voxel_mm;
  /// Values of the voxels, [v][u][w] with padding; w is fastest, since beams most often run along w.
  std::vector<std::int8_t> value;

  /// stepU() and stepV() return the offset in `value` from a voxel to the next voxel along u and along v.
  int stepU() const { return size[2] + kGap; }
  int stepV() const { return size[0] * stepU() + kGap; }
  std::int8_t at(int u, int v, int w) const {
    return value[std::size_t(v & (size[1] - 1)) * stepV() + std::size_t(u & (size[0] - 1)) * stepU() +
                 (w & (size[2] - 1))];
  }
  /// Returns the value at a point given in voxels. A point exactly between two voxels, such as on a plane through the
  /// patient's origin, belongs to the higher voxel in every engine, whatever the rounding.
  std::int8_t at(Vec3 voxels) const {
    const auto index = [](double x) { return static_cast<int>(std::floor(x + kRounding_voxels)); };
    return at(index(voxels.x), index(voxels.y), index(voxels.z));
  }
  static constexpr double kRounding_voxels = 1e-3;

  /// Returns the value interpolated between the eight voxels around a point given in voxels. The result is continuous,
  /// so that engines with different rounding agree.
  double between(Vec3 voxels) const {
    const auto whole = [](double x) { return static_cast<int>(std::floor(x)); };
    const int u = whole(voxels.x), v = whole(voxels.y), w = whole(voxels.z);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const auto share = [&](double x, int low, int bit) { return corner >> bit & 1 ? x - low : 1 - (x - low); };
      sum += share(voxels.x, u, 0) * share(voxels.y, v, 1) * share(voxels.z, w, 2) *
             at(u + (corner & 1), v + (corner >> 1 & 1), w + (corner >> 2));
    }
    return sum;
  }
};

inline constexpr int kTextureKinds = 6;

/// Returns the tile of a kind of texture, which is made once per process and is always the same. The tile of
/// Texture::None has a single zero voxel.
const TextureTile& textureTile(Texture kind);

/// Returns a tile of smooth noise for the variation of echoes along boundaries. The noise has SD 1; the integer 32
/// represents the value 1.
const TextureTile& patchTile();

}  // namespace insonate
