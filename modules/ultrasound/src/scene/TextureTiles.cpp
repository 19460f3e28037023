#include "scene/TextureTiles.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/Textures.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

std::size_t count(const std::array<int, 3>& size) {
  return std::size_t(size[0]) * size[1] * size[2];
}

/// Roughly normal noise, independent from node to node.
std::vector<float> whiteNoise(const std::array<int, 3>& size, std::uint32_t seed) {
  std::vector<float> noise(count(size));
  for (std::size_t n = 0; n < noise.size(); ++n) {
    const std::uint32_t h = hashNode(static_cast<std::int32_t>(n), 0, 0, seed);
    noise[n] = static_cast<float>((h & 255) + (h >> 8 & 255) + (h >> 16 & 255) + (h >> 24)) - 510.0F;
  }
  return noise;
}

/// Periodic Gaussian smoothing along one axis; whole rows along x at a time, so that it vectorises.
void smoothAxis(std::vector<float>& values, const std::array<int, 3>& size, int axis, double sd) {
  const int radius = std::min(static_cast<int>(std::ceil(3 * sd)), size[axis] / 2);
  std::vector<float> weight(2 * radius + 1);
  for (int o = -radius; o <= radius; ++o) weight[o + radius] = static_cast<float>(std::exp(-0.5 * o * o / (sd * sd)));
  std::vector<float> out(values.size(), 0);
  const auto row = [&](int y, int z) { return (std::size_t(z) * size[1] + y) * size[0]; };
  tbb::parallel_for(0, size[2], [&](int z) {
    std::vector<float> wrapped(size[0] + 2 * radius);
    for (int y = 0; y < size[1]; ++y) {
      if (axis == 0)
        for (int x = 0; x < size[0] + 2 * radius; ++x)
          wrapped[x] = values[row(y, z) + (x - radius + size[0]) % size[0]];
      float* sum = out.data() + row(y, z);
      for (int o = -radius; o <= radius; ++o) {
        const auto there = [&](int at) { return (at + o + size[axis]) % size[axis]; };
        const float* in = axis == 0   ? wrapped.data() + o + radius
                          : axis == 1 ? values.data() + row(there(y), z)
                                      : values.data() + row(y, there(z));
        for (int x = 0; x < size[0]; ++x) sum[x] += weight[o + radius] * in[x];
      }
    }
  });
  values.swap(out);
}

void normalise(std::vector<float>& values) {
  double sum = 0, sum2 = 0;
  for (const float v : values) sum += v, sum2 += double(v) * v;
  const double n = static_cast<double>(values.size());
  const double mean = sum / n, sd = std::sqrt(sum2 / n - mean * mean);
  for (float& v : values) v = static_cast<float>((v - mean) / sd);
}

/// Gaussian field of unit variance with the given SDs of its smoothing kernel.
std::vector<float> gaussianField(const std::array<int, 3>& size, Vec3 voxel_mm, Vec3 sd_mm, std::uint32_t seed) {
  std::vector<float> field = whiteNoise(size, seed);
  for (int axis = 0; axis < 3; ++axis)
    if (sd_mm[axis] > 0) smoothAxis(field, size, axis, sd_mm[axis] / voxel_mm[axis]);
  normalise(field);
  return field;
}

float smoothstep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

std::int8_t toByte(float value) {
  return static_cast<std::int8_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 127));
}

/// The fields above have u fastest; a tile has w fastest.
TextureTile transposed(TextureTile tile) {
  const std::vector<std::int8_t> planes = std::move(tile.value);
  tile.value.resize(planes.size() + TextureTile::kPadding);
  std::size_t n = 0;
  for (int v = 0; v < tile.size[1]; ++v)
    for (int u = 0; u < tile.size[0]; ++u)
      for (int w = 0; w < tile.size[2]; ++w)
        tile.value[n++] = planes[(std::size_t(w) * tile.size[1] + v) * tile.size[0] + u];
  return tile;
}

TextureTile emptyTile(std::array<int, 3> size, Vec3 voxel_mm) {
  return {size, voxel_mm, std::vector<std::int8_t>(count(size))};
}

/// Perimysium: bright sheets along the fibres, a few long ones among many short ones, none in line with another.
/// Gaussian fields, long along the fibre and thin across, of which only the peaks are kept; a slow shear turns them
/// unlike ways. Between them lie the fascicles: fine lines along the fibers, dots across them.
TextureTile makeSepta() {
  TextureTile tile = emptyTile({64, 64, 256}, {0.5, 0.4, 0.07});
  const std::vector<float> longSheets = gaussianField(tile.size, tile.voxel_mm, {3.5, 1.5, 0.11}, 0x5e97a001U);
  const std::vector<float> shortSheets = gaussianField(tile.size, tile.voxel_mm, {1.8, 0.5, 0.08}, 0x5e97a003U);
  const std::vector<float> fascicles = gaussianField(tile.size, tile.voxel_mm, {2.5, 0.3, 0.12}, 0x5e97a004U);
  const std::vector<float> slow = gaussianField(tile.size, tile.voxel_mm, {6, 3, 1.4}, 0x5e97a002U);
  for (int w = 0; w < tile.size[2]; ++w)
    for (int v = 0; v < tile.size[1]; ++v)
      for (int u = 0; u < tile.size[0]; ++u) {
        const std::size_t n = (std::size_t(w) * tile.size[1] + v) * tile.size[0] + u;
        const int shift = static_cast<int>(std::lround(slow[n] * 1.1 / tile.voxel_mm.z));
        const int sheared = (w + shift + 4 * tile.size[2]) % tile.size[2];
        const std::size_t m = (std::size_t(sheared) * tile.size[1] + v) * tile.size[0] + u;
        const float sheet = std::max(smoothstep(1.4F, 2.5F, longSheets[m] + 0.4F * slow[n]),
                                     0.8F * smoothstep(1.5F, 2.8F, shortSheets[m]));
        tile.value[n] = toByte(sheet + (1 - sheet) * 0.16F * fascicles[m] + 0.08F * slow[n]);
      }
  return transposed(std::move(tile));
}

struct Cells {
  std::array<int, 3> counts;
  Vec3 cell_mm;
  std::uint32_t seed;

  Vec3 point(int i, int j, int k) const {
    const auto wrap = [](int a, int n) { return (a % n + n) % n; };
    const int x = wrap(i, counts[0]), y = wrap(j, counts[1]), z = wrap(k, counts[2]);
    const auto jitter = [&](std::uint32_t which) { return 0.15 + 0.7 * unitInterval(hashNode(x, y, z, seed + which)); };
    return {(i + jitter(0)) * cell_mm.x, (j + jitter(1)) * cell_mm.y, (k + jitter(2)) * cell_mm.z};
  }
  double tone(int i, int j, int k) const {
    const auto wrap = [](int a, int n) { return (a % n + n) % n; };
    return unitInterval(hashNode(wrap(i, counts[0]), wrap(j, counts[1]), wrap(k, counts[2]), seed + 3)) - 0.5;
  }
};

struct Nearest {
  double first = 1e30, second = 1e30;
  Vec3 firstPoint, secondPoint;
  double tone = 0;
};

/// The two nearest cell centres, in units of cells.
Nearest nearestCells(const Cells& cells, Vec3 p_mm) {
  Nearest best;
  const int ci = static_cast<int>(std::floor(p_mm.x / cells.cell_mm.x));
  const int cj = static_cast<int>(std::floor(p_mm.y / cells.cell_mm.y));
  const int ck = static_cast<int>(std::floor(p_mm.z / cells.cell_mm.z));
  for (int k = ck - 1; k <= ck + 1; ++k)
    for (int j = cj - 1; j <= cj + 1; ++j)
      for (int i = ci - 1; i <= ci + 1; ++i) {
        const Vec3 c = cells.point(i, j, k);
        const Vec3 d{(c.x - p_mm.x) / cells.cell_mm.x, (c.y - p_mm.y) / cells.cell_mm.y,
                     (c.z - p_mm.z) / cells.cell_mm.z};
        const double r = norm(d);
        if (r < best.first) {
          best.second = best.first, best.secondPoint = best.firstPoint;
          best.first = r, best.firstPoint = c, best.tone = cells.tone(i, j, k);
        } else if (r < best.second) {
          best.second = r, best.secondPoint = c;
        }
      }
  return best;
}

/// Fat lobules: bent cells of unlike tone. Their thin walls are brightest where they lie across the beam (normal along
/// w), and come and go.
TextureTile makeLobules() {
  TextureTile tile = emptyTile({64, 64, 128}, {0.5, 0.5, 0.13125});
  const Cells cells{{6, 7, 6}, {32.0 / 6, 32.0 / 7, 16.8 / 6}, 0x10b01e00U};
  const std::vector<float> bendU = gaussianField(tile.size, tile.voxel_mm, {2.5, 2.5, 1.6}, 0x10b01e10U);
  const std::vector<float> bendW = gaussianField(tile.size, tile.voxel_mm, {2.5, 2.5, 2.0}, 0x10b01e11U);
  const std::vector<float> patch = gaussianField(tile.size, tile.voxel_mm, {1.8, 1.8, 0.8}, 0x10b01e12U);
  tbb::parallel_for(0, tile.size[2], [&](int w) {
    for (int v = 0; v < tile.size[1]; ++v)
      for (int u = 0; u < tile.size[0]; ++u) {
        const std::size_t n = (std::size_t(w) * tile.size[1] + v) * tile.size[0] + u;
        const Vec3 p{u * tile.voxel_mm.x + 0.9 * bendU[n], v * tile.voxel_mm.y - 0.9 * bendU[n],
                     w * tile.voxel_mm.z + bendW[n]};
        const Nearest near = nearestCells(cells, p);
        const Vec3 across = near.secondPoint - near.firstPoint;
        const double facing = std::abs(across.z) / std::max(norm(across), 1e-6);
        const float wall = 1 - smoothstep(0.02F, 0.17F, static_cast<float>(near.second - near.first));
        const auto square = static_cast<float>(0.35 + 0.65 * facing * facing);
        const float seen = 0.4F + 0.6F * smoothstep(-1.0F, 1.0F, patch[n]);
        tile.value[n] = toByte(wall * square * seen + 0.25F * static_cast<float>(near.tone));
      }
  });
  return transposed(std::move(tile));
}

/// Loose connective tissue: patchy, wavy sheets.
TextureTile makeSheets() {
  TextureTile tile = emptyTile({64, 64, 256}, {0.4, 0.4, 0.08});
  const std::vector<float> wave = gaussianField(tile.size, tile.voxel_mm, {4, 4, 1.2}, 0x54ee7001U);
  const std::vector<float> patch = gaussianField(tile.size, tile.voxel_mm, {2.5, 2.5, 0.5}, 0x54ee7002U);
  const std::vector<float> thin = gaussianField(tile.size, tile.voxel_mm, {2.2, 2.2, 0.1}, 0x54ee7003U);
  for (int w = 0; w < tile.size[2]; ++w)
    for (int v = 0; v < tile.size[1]; ++v)
      for (int u = 0; u < tile.size[0]; ++u) {
        const std::size_t n = (std::size_t(w) * tile.size[1] + v) * tile.size[0] + u;
        const int shift = static_cast<int>(std::lround(wave[n] * 0.7 / tile.voxel_mm.z));
        const int warped = (w + shift + 4 * tile.size[2]) % tile.size[2];
        const float sheet = smoothstep(0.7F, 2.2F, thin[(std::size_t(warped) * tile.size[1] + v) * tile.size[0] + u]);
        tile.value[n] = toByte(0.9F * sheet * smoothstep(-1.0F, 1.0F, patch[n]) + 0.36F * patch[n] + 0.12F * wave[n]);
      }
  return transposed(std::move(tile));
}

/// Even parenchyma with slow, faint variation.
TextureTile makeFine() {
  TextureTile tile = emptyTile({64, 64, 64}, {0.4, 0.4, 0.4});
  const std::vector<float> coarse = gaussianField(tile.size, tile.voxel_mm, {1.5, 1.5, 1.5}, 0xf14e0001U);
  const std::vector<float> fine = gaussianField(tile.size, tile.voxel_mm, {0.5, 0.5, 0.4}, 0xf14e0002U);
  for (std::size_t n = 0; n < tile.value.size(); ++n) tile.value[n] = toByte(0.25F * coarse[n] + 0.3F * fine[n]);
  return transposed(std::move(tile));
}

TextureTile makePatches() {
  TextureTile tile = emptyTile({64, 64, 64}, {0.5, 0.5, 0.5});
  const std::vector<float> coarse = gaussianField(tile.size, tile.voxel_mm, {3.0, 3.0, 3.0}, 0x9a7c0001U);
  const std::vector<float> medium = gaussianField(tile.size, tile.voxel_mm, {0.8, 0.8, 0.8}, 0x9a7c0002U);
  const std::vector<float> fine = gaussianField(tile.size, tile.voxel_mm, {0.3, 0.3, 0.3}, 0x9a7c0003U);
  for (std::size_t n = 0; n < tile.value.size(); ++n)
    tile.value[n] = toByte((0.62F * coarse[n] + 0.56F * medium[n] + 0.55F * fine[n]) * (32.0F / 127.0F));
  return transposed(std::move(tile));
}

}  // namespace

const TextureTile& textureTile(Texture kind) {
  static const std::array<TextureTile, kTextureKinds> tiles{emptyTile({1, 1, 1}, {1, 1, 1}), makeSepta(), makeLobules(),
                                                            makeSheets(), makeFine()};
  return tiles[static_cast<std::size_t>(kind)];
}

void prepareTextures() {
  textureTile(Texture::None);
  patchTile();
}

const TextureTile& patchTile() {
  static const TextureTile tile = makePatches();
  return tile;
}

}  // namespace insonate
