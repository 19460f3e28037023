#include "scene/FibreAxis.h"
#include "scene/SceneData.h"

#include <insonate/ultrasound/AcousticScene.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace insonate {
namespace {

std::vector<std::string> unknownLabelWarnings(const LabelMap& labels) {
  std::array<bool, 256> seen{};
  for (const std::uint8_t label : labels.voxels) seen[label] = true;
  std::vector<std::string> warnings;
  for (int label = kLabelCount; label < 256; ++label)
    if (seen[label])
      warnings.push_back("Label " + std::to_string(label) + " is not known; it is shown as soft tissue.");
  return warnings;
}

/// Airway, spine and larynx lie in the middle; without them, the middle of the volume has to do.
double midlineOf(const LabelMap& labels) {
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  double sum = 0;
  std::size_t count = 0;
  const auto& size = labels.geometry.size;
  for (int k = 0; k < size[2]; k += 2)
    for (int j = 0; j < size[1]; j += 2)
      for (int i = 0; i < size[0]; i += 2) {
        const int label = labels.at(i, j, k);
        if (label != kAirway && label != kCartilage && label != kBone) continue;
        sum += (patientFromIndex * Vec3{double(i), double(j), double(k)}).x;
        ++count;
      }
  return count ? sum / static_cast<double>(count) : labels.geometry.centre_mm().x;
}

/// Rows u, v, w scaled to tile voxels; w is the thin axis, as far as it can be across the fibre.
TextureFrame frameOf(const TextureTile& tile, Vec3 fibre, Vec3 thinHint) {
  const Vec3 u = normalized(fibre);
  const Vec3 w = normalized(thinHint - u * dot(u, thinHint));
  const Vec3 v = cross(w, u);
  const Vec3 s{1 / tile.voxel_mm.x, 1 / tile.voxel_mm.y, 1 / tile.voxel_mm.z};
  return {{{Vec3{u.x * s.x, v.x * s.y, w.x * s.z}, Vec3{u.y * s.x, v.y * s.y, w.y * s.z},
            Vec3{u.z * s.x, v.z * s.y, w.z * s.z}}},
          w};
}

}  // namespace

AcousticScene::AcousticScene(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
AcousticScene::~AcousticScene() = default;
const std::vector<std::string>& AcousticScene::warnings() const {
  return impl_->warnings;
}

Result<std::shared_ptr<const AcousticScene>> AcousticScene::make(const CtVolume& ct, const LabelMap& labels,
                                                                 const AcousticTable& table, const Region& region,
                                                                 const Progress& progress,
                                                                 std::vector<PointTarget> points, double detail_mm) {
  if (!sameGrid(ct.geometry, labels.geometry))
    return fail("The CT and the label map lie on different grids; resample one to the other.");
  auto field = makeTissueField(ct, labels, region, detail_mm, progress);
  if (!field) return tl::unexpected(field.error());

  auto impl = std::make_unique<Impl>();
  impl->table = table;
  impl->points = std::move(points);
  impl->field = std::move(*field);
  impl->profiles =
      BoundaryProfiles(table, std::span(impl->field.label.data(), static_cast<std::size_t>(impl->field.channels)));
  impl->warnings = unknownLabelWarnings(labels);
  impl->midline_mm = midlineOf(labels);
  for (int side = 0; side < 2; ++side) {
    // Sheets of the neck lie along its outside: their normal points forward and outward (patient right is -x).
    const Vec3 outward = normalized({side == 0 ? -0.55 : 0.55, -0.83, 0.05});
    const Vec3 scmFibre = fibreAxis(labels, kSternocleidomastoid, impl->midline_mm, side == 0);
    for (int l = 0; l < kLabelCount; ++l) {
      const Vec3 fibre = l == kSternocleidomastoid ? scmFibre : normalized({side == 0 ? 0.12 : -0.12, 0.08, 1.0});
      impl->textureFrames[l][side] =
          frameOf(textureTile(table.of(static_cast<std::uint8_t>(l)).texture), fibre, outward);
    }
  }
  return std::shared_ptr<const AcousticScene>(new AcousticScene(std::move(impl)));
}

}  // namespace insonate
