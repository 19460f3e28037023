#include "scene/CaseFacts.h"

#include <insonate/core/Hash.h>
#include <insonate/core/Transform.h>
#include <insonate/core/Vec3.h>
#include <insonate/image/Volume.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace insonate {
namespace {

/// Direction in which a structure is longest on one side of the midline (first principal axis of its voxels), unit,
/// patient LPS, pointing headward. Cranio-caudal where the structure is missing.
Vec3 fibreAxis(const LabelMap& labels, std::uint8_t label, double midline_mm, bool rightSide) {
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  const auto& size = labels.geometry.size;
  std::vector<Vec3> points;
  Vec3 mean;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; j += 2)
      for (int i = 0; i < size[0]; i += 2) {
        if (labels.at(i, j, k) != label) continue;
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        if ((p.x < midline_mm) != rightSide) continue;
        points.push_back(p);
        mean = mean + p;
      }
  if (points.size() < 20) return {0, 0, 1};
  mean = mean / static_cast<double>(points.size());
  Mat3 covariance{{Vec3{}, Vec3{}, Vec3{}}};
  for (const Vec3& p : points) {
    const Vec3 d = p - mean;
    for (int a = 0; a < 3; ++a) covariance.column[a] = covariance.column[a] + d * d[a];
  }
  // Power iteration: the long axis of a muscle stands out, a few steps settle it.
  Vec3 axis = normalized({0.1, 0.1, 1});
  for (int step = 0; step < 60; ++step) axis = normalized(covariance * axis);
  return axis.z < 0 ? -axis : axis;
}

/// Sums over a slab of the case, added up in the slabs' order, so that threads change nothing.
struct Sums {
  std::array<std::int64_t, kLabelCount> hu{}, count{};
  std::array<bool, 256> seen{};
  struct Middle {
    std::array<std::int64_t, 3> index{};
    std::int64_t count = 0;

    void add(int x, int y, int z) {
      index[0] += x, index[1] += y, index[2] += z;
      ++count;
    }
  };
  Middle all;      ///< airway, lung, larynx and bone
  Middle trachea;  ///< airway that is not lung, and larynx

  void add(const Sums& other) {
    for (int l = 0; l < kLabelCount; ++l) hu[l] += other.hu[l], count[l] += other.count[l];
    for (int l = 0; l < 256; ++l) seen[l] = seen[l] || other.seen[l];
    for (const auto& [mine, others] : {std::pair(&all, &other.all), std::pair(&trachea, &other.trachea)}) {
      for (int a = 0; a < 3; ++a) mine->index[a] += others->index[a];
      mine->count += others->count;
    }
  }
};

/// Airway, spine and larynx are in the midline.
bool isMiddle(int label) {
  return label == kAirway || label == kCartilage || label == kBone;
}

/// Greatest width of a trachea. The lung has the same label, and may be in the case on one side only.
constexpr double kTrachea_mm = 26;

void addRow(const CtVolume& ct, const LabelMap& labels, int j, int k, Sums& sums, std::uint32_t* blocks) {
  const std::size_t row = labels.geometry.offset(0, j, k);
  const std::uint8_t* label = labels.voxels.data() + row;
  const std::int16_t* hu = ct.voxels.data() + row;
  const int size = labels.geometry.size[0];
  for (int i = 0; i < size;) {
    // Long runs have the same label.
    const int first = i;
    std::int64_t sum = 0;
    for (const std::uint8_t here = label[i]; i < size && label[i] == here; ++i) sum += hu[i];
    const int known = knownLabel(label[first]);
    sums.seen[label[first]] = true;
    sums.hu[known] += sum;
    sums.count[known] += i - first;
    for (int b = first / CaseFacts::kBlock; b <= (i - 1) / CaseFacts::kBlock; ++b) blocks[b] |= 1U << known;
    if (!isMiddle(label[first]) || j % 2 || k % 2) continue;
    const bool isTrachea = label[first] == kCartilage ||
                           (label[first] == kAirway && (i - first) * labels.geometry.spacing_mm.x <= kTrachea_mm);
    for (int x = first + first % 2; x < i; x += 2) {
      sums.all.add(x, j, k);
      if (isTrachea) sums.trachea.add(x, j, k);
    }
  }
}

std::uint32_t hashOf(const CtVolume& ct) {
  constexpr std::size_t kSamples = 4096;
  const std::size_t step = std::max<std::size_t>(ct.voxels.size() / kSamples, 1);
  std::uint32_t hash = 0;
  for (std::size_t n = 0; n < ct.voxels.size(); n += step)
    hash = hash32(hash ^ static_cast<std::uint16_t>(ct.voxels[n]));
  return hash;
}

/// Mean x of voxels, patient space; that of the middle of the volume without voxels.
double middleOf(const Sums::Middle& middle, const VolumeGeometry& geometry) {
  if (middle.count == 0) return geometry.center_mm().x;
  const auto count = static_cast<double>(middle.count);
  const Vec3 mean{static_cast<double>(middle.index[0]) / count, static_cast<double>(middle.index[1]) / count,
                  static_cast<double>(middle.index[2]) / count};
  return (geometry.patientFromIndex() * mean).x;
}

}  // namespace

CaseFacts::CaseFacts(const CtVolume& ct, const LabelMap& labels) {
  patient = hashOf(ct);
  const auto& size = labels.geometry.size;
  blocks_ = cubesOf({{}, size}, kBlock).size;
  labelsOfBlock_.resize(std::size_t(blocks_[0]) * blocks_[1] * blocks_[2]);
  std::vector<Sums> slabs(blocks_[2]);
  tbb::parallel_for(0, blocks_[2], [&](int slab) {
    for (int k = slab * kBlock; k < std::min((slab + 1) * kBlock, size[2]); ++k)
      for (int j = 0; j < size[1]; ++j)
        addRow(ct, labels, j, k, slabs[slab],
               labelsOfBlock_.data() + (std::size_t(slab) * blocks_[1] + j / kBlock) * blocks_[0]);
  });
  Sums all;
  for (const Sums& slab : slabs) all.add(slab);

  for (int l = 0; l < kLabelCount; ++l)
    mean_HU[l] = all.count[l] ? static_cast<double>(all.hu[l]) / static_cast<double>(all.count[l]) : 0;
  for (int label = kLabelCount; label < 256; ++label)
    if (all.seen[label])
      warnings.push_back("Label " + std::to_string(label) + " is not known; it is shown as soft tissue.");
  midline_mm = middleOf(all.all, labels.geometry);
  trachea_mm = all.trachea.count > 0 ? middleOf(all.trachea, labels.geometry) : midline_mm;
  const bool hasMuscle = all.count[kSternocleidomastoid] > 0;
  tbb::parallel_for(0, 2, [&](int side) {
    muscleFibre[side] = hasMuscle ? fibreAxis(labels, kSternocleidomastoid, midline_mm, side == 0) : Vec3{0, 0, 1};
  });
}

std::uint32_t CaseFacts::labelsNear(const NodeBox& voxels) const {
  const NodeBox touched = cubesOf(voxels, kBlock);
  std::uint32_t found = 0;
  for (int k = touched.low[2]; k < touched.high(2); ++k)
    for (int j = touched.low[1]; j < touched.high(1); ++j)
      for (int i = touched.low[0]; i < touched.high(0); ++i)
        found |= labelsOfBlock_[(std::size_t(k) * blocks_[1] + j) * blocks_[0] + i];
  return found;
}

}  // namespace insonate
