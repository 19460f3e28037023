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

/// Approximately normal noise, independent between nodes.
std::vector<float> whiteNoise(const std::array<int, 3>& size, std::uint32_t seed) {
  std::vector<float> noise(count(size));
  for (std::size_t n = 0; n < noise.size(); ++n) {
    const std::uint32_t h = hashNode(static_cast<std::int32_t>(n), 0, 0, seed);
    noise[n] = static_cast<float>((h & 255) + (h >> 8 & 255) + (h >> 16 & 255) + (h >> 24)) - 510.0F;
  }
  return noise;
}

/// Rows along x of a tile's values, by indices that wrap around.
class Rows {
 public:
  Rows(std::vector<float>& values, const std::array<int, 3>& size) : values_(values), size_(size) {}

  /// The row at `along` of `axis` (1 or 2) and `other` of the other of the two.
  float* at(int axis, int along, int other) const {
    const int wrapped = (along % size_[axis] + size_[axis]) % size_[axis];
    const int y = axis == 1 ? wrapped : other, z = axis == 1 ? other : wrapped;
    return values_.data() + (std::size_t(z) * size_[1] + y) * size_[0];
  }

 private:
  std::vector<float>& values_;
  std::array<int, 3> size_;
};

/// Periodic weighted mean of values at -radius to radius along x.
void convolveX(std::vector<float>& values, const std::array<int, 3>& size, const std::vector<float>& weight) {
  const int radius = static_cast<int>(weight.size() / 2);
  const Rows rows(values, size);
  tbb::parallel_for(0, size[2], [&](int z) {
    std::vector<float> wrapped(size[0] + 2 * radius);
    for (int y = 0; y < size[1]; ++y) {
      float* const row = rows.at(1, y, z);
      for (int x = 0; x < size[0] + 2 * radius; ++x) wrapped[x] = row[(x - radius + size[0]) % size[0]];
      std::fill_n(row, size[0], 0.0F);
      for (int o = 0; o <= 2 * radius; ++o)
        for (int x = 0; x < size[0]; ++x) row[x] += weight[o] * wrapped[x + o];
    }
  });
}

/// Periodic sum of values at -radius to radius along y or z: adds the value that enters and subtracts the one that
/// leaves, so that the cost does not depend on the radius.
void sumAlong(std::vector<float>& values, const std::array<int, 3>& size, int axis, int radius) {
  std::vector<float> out(values.size());
  const Rows from(values, size), to(out, size);
  const int columns = size[0];
  tbb::parallel_for(0, size[3 - axis], [&](int other) {
    std::vector<float> sum(columns, 0.0F);
    for (int o = -radius; o <= radius; ++o)
      for (int x = 0; x < columns; ++x) sum[x] += from.at(axis, o, other)[x];
    for (int along = 0; along < size[axis]; ++along) {
      std::copy_n(sum.data(), columns, to.at(axis, along, other));
      const float *enters = from.at(axis, along + radius + 1, other), *leaves = from.at(axis, along - radius, other);
      for (int x = 0; x < columns; ++x) sum[x] += enters[x] - leaves[x];
    }
  });
  values.swap(out);
}

/// Periodic smoothing along one axis, as a Gaussian up to a factor. Along y and z three running sums approximate it
/// (Wells, IEEE Trans Pattern Anal 1986;8:234): n boxes of width w have the variance n (w^2 - 1) / 12.
void smoothAxis(std::vector<float>& values, const std::array<int, 3>& size, int axis, double sd) {
  constexpr int kBoxes = 3;
  if (axis == 0) {
    const int radius = std::min(static_cast<int>(std::ceil(3 * sd)), size[0] / 2);
    std::vector<float> weight(2 * radius + 1);
    for (int o = -radius; o <= radius; ++o) weight[o + radius] = static_cast<float>(std::exp(-0.5 * o * o / (sd * sd)));
    return convolveX(values, size, weight);
  }
  // Widths are odd numbers; the number of boxes with the narrower of two widths is that with the closest variance.
  const int narrow = (static_cast<int>(std::sqrt(12 * sd * sd / kBoxes + 1)) - 1) / 2;
  const auto variance = [](int radius) { return ((2 * radius + 1) * (2 * radius + 1) - 1) / 12.0; };
  double left = sd * sd - kBoxes * variance(narrow);
  for (int n = 0; n < kBoxes; ++n) {
    const double wider = variance(narrow + 1) - variance(narrow);
    const bool isWide = left > wider / 2;
    if (isWide) left -= wider;
    if (narrow + isWide > 0) sumAlong(values, size, axis, narrow + isWide);
  }
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

/// Arranges voxels in the order of a tile, with its gaps. In the fields above, u is fastest.
TextureTile packed(TextureTile tile) {
  const std::vector<std::int8_t> planes = std::move(tile.value);
  const auto [us, vs, ws] = tile.size;
  tile.value.assign(std::size_t(vs) * tile.stepV(), 0);
  for (int v = 0; v < vs; ++v)
    for (int u = 0; u < us; ++u) {
      std::int8_t* const row = tile.value.data() + std::size_t(v) * tile.stepV() + std::size_t(u) * tile.stepU();
      for (int w = 0; w < tile.stepU(); ++w) row[w] = planes[(std::size_t(w % ws) * vs + v) * us + u];
    }
  return tile;
}

TextureTile emptyTile(std::array<int, 3> size, Vec3 voxel_mm) {
  return {size, voxel_mm, std::vector<std::int8_t>(count(size))};
}

/// Shape of sheets: curvature, visible share, and thickness.
struct SheetLook {
  Vec3 bend_mm;     ///< SDs of the smoothing of the field whose zeros are the sheets
  Vec3 stretch_mm;  ///< SDs of the smoothing of the field that interrupts them
  float share;      ///< visible share of their area
  double thick_mm;  ///< distance at which a sheet falls to 1/e, at its thickest place
};

/// Zeros of a smooth periodic field as sheets: 1 where the field is zero, decreasing within a given thickness. Where
/// sheets bend back they are steep and echo little.
class ZeroSheets {
 public:
  ZeroSheets(const TextureTile& tile, const std::vector<float>& field) : tile_(tile), field_(field) {}

  double at(int u, int v, int w, double thick_mm) const {
    const Vec3 slope{(value(u + 1, v, w) - value(u - 1, v, w)) / (2 * tile_.voxel_mm.x),
                     (value(u, v + 1, w) - value(u, v - 1, w)) / (2 * tile_.voxel_mm.y),
                     (value(u, v, w + 1) - value(u, v, w - 1)) / (2 * tile_.voxel_mm.z)};
    const double steepness = std::max(norm(slope), 1e-6), away = value(u, v, w) / steepness / thick_mm;
    const double flat = slope.z / steepness;
    return std::exp(-away * away) * flat * flat;
  }

 private:
  float value(int u, int v, int w) const {
    const auto& size = tile_.size;
    return field_[(std::size_t(w & (size[2] - 1)) * size[1] + (v & (size[1] - 1))) * size[0] + (u & (size[0] - 1))];
  }

  const TextureTile& tile_;
  const std::vector<float>& field_;
};

/// The value above which the stated share of a field lies.
float thresholdOf(std::vector<float> field, float share) {
  const auto cut = field.begin() + std::ptrdiff_t(float(field.size() - 1) * (1 - share));
  std::nth_element(field.begin(), cut, field.end());
  return *cut;
}

/// Thin bent sheets with interruptions: the zeros of a smooth field. Unlike its peaks, its zeros are long, and meet and
/// part at shallow angles, as connective tissue does. A second sheet runs with the first and leaves it in places, which
/// gives branches. Sheets become thin toward their ends, and their brightness varies along them. 0 to 1.
std::vector<float> sheetsOf(const TextureTile& tile, const SheetLook& look, std::uint32_t seed) {
  constexpr float kBranch = 0.9F, kUneven = 0.08F, kRagged = 0.35F;
  const auto& size = tile.size;
  const std::vector<float> field = gaussianField(size, tile.voxel_mm, look.bend_mm, seed);
  std::vector<float> presence = gaussianField(size, tile.voxel_mm, look.stretch_mm, seed + 1);
  const std::vector<float> ragged = gaussianField(size, tile.voxel_mm, look.stretch_mm * 0.4, seed + 2);
  const std::vector<float> detour = gaussianField(size, tile.voxel_mm, look.stretch_mm * 0.8, seed + 3);
  // Constant brightness through the thickness, since a place between two voxels would flicker otherwise.
  const Vec3 grain_mm{0.25 * look.stretch_mm.x, 0.25 * look.stretch_mm.y, look.stretch_mm.z};
  const std::vector<float> uneven = gaussianField(size, tile.voxel_mm, grain_mm, seed + 4);
  std::vector<float> branching(field.size());
  for (std::size_t n = 0; n < field.size(); ++n) {
    presence[n] += kRagged * ragged[n];
    branching[n] = field[n] + kBranch * std::max(detour[n] - 0.3F, 0.0F);
  }
  const float threshold = thresholdOf(presence, look.share);
  const ZeroSheets first(tile, field), second(tile, branching);
  std::vector<float> sheets(field.size());
  tbb::parallel_for(0, size[2], [&](int w) {
    for (int v = 0; v < size[1]; ++v)
      for (int u = 0; u < size[0]; ++u) {
        const std::size_t n = (std::size_t(w) * size[1] + v) * size[0] + u;
        const float there = smoothstep(threshold - 0.8F, threshold + 1.4F, presence[n]);
        if (there <= 0) continue;
        const double thick_mm = look.thick_mm * (0.7 + 0.3 * there);
        const double sheet = std::max(first.at(u, v, w, thick_mm), 0.85 * second.at(u, v, w, thick_mm));
        sheets[n] = static_cast<float>(sheet) * there * std::clamp(1 - kUneven * (uneven[n] + 1), 0.0F, 1.0F);
      }
  });
  return sheets;
}

/// Perimysium: bright sheets along the fibers, a few long ones among many short ones, none in line with another. The
/// fascicles between them are fine lines along the fibers, and dots in cross-section.
TextureTile makeSepta() {
  TextureTile tile = emptyTile({64, 64, 256}, {0.5, 0.4, 0.07});
  const std::vector<float> longSheets = sheetsOf(tile, {{9, 2.4, 0.7}, {6, 1.4, 0.4}, 0.36F, 0.16}, 0x5e97a001U);
  const std::vector<float> shortSheets = sheetsOf(tile, {{6, 1.3, 0.4}, {3, 1.0, 0.3}, 0.26F, 0.11}, 0x5e97a031U);
  const std::vector<float> fascicles = gaussianField(tile.size, tile.voxel_mm, {2.5, 0.3, 0.12}, 0x5e97a004U);
  const std::vector<float> slow = gaussianField(tile.size, tile.voxel_mm, {6, 3, 1.4}, 0x5e97a002U);
  for (std::size_t n = 0; n < tile.value.size(); ++n) {
    const float sheet = std::max(longSheets[n], 0.7F * shortSheets[n]);
    tile.value[n] = toByte(sheet + (1 - sheet) * (0.1F * fascicles[n] + 0.05F * slow[n]));
  }
  return packed(std::move(tile));
}

/// Fat: lobules of different echogenicity between thin septa, most of which are parallel to the skin.
TextureTile makeLobules() {
  TextureTile tile = emptyTile({64, 64, 256}, {0.5, 0.5, 0.065625});
  const std::vector<float> longSepta = sheetsOf(tile, {{4.5, 3.5, 0.8}, {2.5, 2, 0.6}, 0.52F, 0.15}, 0x10b01e01U);
  const std::vector<float> shortSepta = sheetsOf(tile, {{2.5, 2, 0.6}, {1.5, 1.2, 0.5}, 0.32F, 0.12}, 0x10b01e11U);
  const std::vector<float> tone = gaussianField(tile.size, tile.voxel_mm, {2, 2, 0.9}, 0x10b01e22U);
  const std::vector<float> grain = gaussianField(tile.size, tile.voxel_mm, {0.6, 0.6, 0.25}, 0x10b01e23U);
  for (std::size_t n = 0; n < tile.value.size(); ++n) {
    const float sheet = std::max(longSepta[n], 0.75F * shortSepta[n]);
    tile.value[n] = toByte(sheet + (1 - sheet) * (0.09F * tone[n] + 0.06F * grain[n]));
  }
  return packed(std::move(tile));
}

/// Loose connective tissue: wavy sheets that part and meet, with varying density.
TextureTile makeSheets() {
  TextureTile tile = emptyTile({64, 64, 512}, {0.4, 0.4, 0.04});
  const std::vector<float> longSheets = sheetsOf(tile, {{5, 4, 0.5}, {2.5, 2.2, 0.5}, 0.38F, 0.13}, 0x54ee7001U);
  const std::vector<float> shortSheets = sheetsOf(tile, {{2.5, 2, 0.35}, {1.2, 1.2, 0.4}, 0.16F, 0.11}, 0x54ee7011U);
  const std::vector<float> patch = gaussianField(tile.size, tile.voxel_mm, {2.5, 2.5, 0.6}, 0x54ee7002U);
  const std::vector<float> grain = gaussianField(tile.size, tile.voxel_mm, {0.6, 0.6, 0.2}, 0x54ee7003U);
  for (std::size_t n = 0; n < tile.value.size(); ++n) {
    const float sheet = std::max(longSheets[n], 0.8F * shortSheets[n]);
    tile.value[n] = toByte(sheet + (1 - sheet) * (0.14F * patch[n] + 0.06F * grain[n] - 0.1F));
  }
  return packed(std::move(tile));
}

/// Parenchyma: a texture that varies slowly within the organ, faint strands, and small vessels as hypoechoic lines and
/// dots.
TextureTile makeFine() {
  TextureTile tile = emptyTile({64, 64, 128}, {0.4, 0.4, 0.16});
  const std::vector<float> coarse = gaussianField(tile.size, tile.voxel_mm, {2.6, 2.6, 2.0}, 0xf14e0001U);
  const std::vector<float> fine = gaussianField(tile.size, tile.voxel_mm, {0.45, 0.45, 0.3}, 0xf14e0002U);
  const std::vector<float> strands = sheetsOf(tile, {{2.2, 2.2, 0.7}, {1.4, 1.4, 0.45}, 0.13F, 0.16}, 0xf14e0011U);
  const std::vector<float> vessels = gaussianField(tile.size, tile.voxel_mm, {2.5, 0.5, 0.35}, 0xf14e0021U);
  for (std::size_t n = 0; n < tile.value.size(); ++n)
    tile.value[n] =
        toByte(0.28F * coarse[n] + 0.05F * fine[n] + 0.7F * strands[n] - 0.9F * smoothstep(1.7F, 2.5F, vessels[n]));
  return packed(std::move(tile));
}

/// Nerve: hypoechoic fascicles, long in its long axis and round in its short axis, in hyperechoic connective tissue.
TextureTile makeBundles() {
  TextureTile tile = emptyTile({32, 64, 64}, {0.5, 0.1, 0.1});
  const std::vector<float> fascicles = gaussianField(tile.size, tile.voxel_mm, {4, 0.22, 0.22}, 0xb0d1e001U);
  for (std::size_t n = 0; n < tile.value.size(); ++n)
    tile.value[n] = toByte(0.6F - 1.4F * smoothstep(-0.3F, 0.6F, fascicles[n]));
  return packed(std::move(tile));
}

TextureTile makePatches() {
  TextureTile tile = emptyTile({64, 64, 64}, {0.5, 0.5, 0.5});
  const std::vector<float> coarse = gaussianField(tile.size, tile.voxel_mm, {3.0, 3.0, 3.0}, 0x9a7c0001U);
  const std::vector<float> medium = gaussianField(tile.size, tile.voxel_mm, {0.8, 0.8, 0.8}, 0x9a7c0002U);
  const std::vector<float> fine = gaussianField(tile.size, tile.voxel_mm, {0.3, 0.3, 0.3}, 0x9a7c0003U);
  for (std::size_t n = 0; n < tile.value.size(); ++n)
    tile.value[n] = toByte((0.62F * coarse[n] + 0.56F * medium[n] + 0.55F * fine[n]) * (32.0F / 127.0F));
  return packed(std::move(tile));
}

}  // namespace

const TextureTile& textureTile(Texture kind) {
  static const std::array<TextureTile, kTextureKinds> tiles{
      packed(emptyTile({1, 1, 1}, {1, 1, 1})), makeSepta(), makeLobules(), makeSheets(), makeFine(), makeBundles()};
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
