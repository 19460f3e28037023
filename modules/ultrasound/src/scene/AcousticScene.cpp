#include "scene/SceneData.h"
#include "scene/SceneSourceData.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

namespace insonate {
namespace {

/// Rows u, v, w scaled to tile voxels; w is the thin axis, as perpendicular to the fiber as possible.
TextureFrame frameOf(const TextureTile& tile, Vec3 origin_mm, Vec3 fibre, Vec3 thinHint) {
  const Vec3 u = normalized(fibre);
  const Vec3 w = normalized(thinHint - u * dot(u, thinHint));
  const Vec3 v = cross(w, u);
  const Vec3 s{1 / tile.voxel_mm.x, 1 / tile.voxel_mm.y, 1 / tile.voxel_mm.z};
  const Mat3 linear{{Vec3{u.x * s.x, v.x * s.y, w.x * s.z}, Vec3{u.y * s.x, v.y * s.y, w.y * s.z},
                     Vec3{u.z * s.x, v.z * s.y, w.z * s.z}}};
  // Whole voxels, so that positions between voxels in the patient are the same between voxels of the tile; see
  // TextureTile::at().
  const Vec3 origin = linear * origin_mm;
  return {{linear, {-std::round(origin.x), -std::round(origin.y), -std::round(origin.z)}}, w};
}

/// Directions of a structure's texture: along its fibers, and normal to its sheets.
struct Directions {
  Vec3 fibre, outward;
};

/// Septa of a muscle are oblique in its cross-section, and fascicles meet its surface at an angle (pennation),
/// different for each muscle of each patient. The amounts are chosen by comparison with images of necks.
Directions askew(const Directions& muscle, int label, int side, std::uint32_t patient) {
  constexpr double kSlant_rad = 0.38, kPennation_rad = 0.16;
  const auto within = [&](int which) { return 2 * unitInterval(hashNode(label, side, which, patient)) - 1; };
  const double slant = kSlant_rad * within(0), pennation = kPennation_rad * within(1);
  const Vec3 across = normalized(cross(muscle.outward, muscle.fibre));
  return {normalized(muscle.fibre + std::tan(pennation) * muscle.outward),
          normalized(muscle.outward + std::tan(slant) * across)};
}

/// Position within the longest period of a tile.
Vec3 textureOriginOf(std::uint32_t patient) {
  constexpr double kPeriod_mm = 32;
  const auto along = [&](int axis) { return kPeriod_mm * unitInterval(hashNode(axis, 0, 0, patient)); };
  return {along(0), along(1), along(2)};
}

}  // namespace

AcousticScene::AcousticScene(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
AcousticScene::~AcousticScene() = default;
const std::vector<std::string>& AcousticScene::warnings() const {
  return impl_->warnings;
}

double AcousticScene::trachea_mm() const {
  return impl_->trachea_mm;
}

const AcousticTable& AcousticScene::tissues() const {
  return impl_->table;
}

Result<std::shared_ptr<const AcousticScene>> AcousticScene::make(const CtVolume& ct, const LabelMap& labels,
                                                                 const AcousticTable& table, const Region& region,
                                                                 const Progress& progress,
                                                                 std::vector<PointTarget> points, double detail_mm) {
  const auto source = SceneSource::make(ct, labels);
  if (!source) return tl::unexpected(source.error());
  return make(**source, table, region, progress, std::move(points), detail_mm);
}

Result<std::shared_ptr<const AcousticScene>> AcousticScene::make(const SceneSource& source, const AcousticTable& table,
                                                                 const Region& region, const Progress& progress,
                                                                 std::vector<PointTarget> points, double detail_mm,
                                                                 SceneQuality quality) {
  TissueTiles& tiles = quality == SceneQuality::Coarse ? source.impl().coarseTiles : source.impl().tilesOf(detail_mm);
  auto field = makeTissueField(tiles, region, progress);
  if (!field) return tl::unexpected(field.error());

  const CaseFacts& facts = source.impl().facts;
  static std::atomic<std::uint64_t> scenes = 0;
  auto impl = std::make_unique<Impl>();
  impl->serial = ++scenes;
  impl->table = table;
  impl->points = std::move(points);
  impl->field = std::move(*field);
  impl->profiles =
      BoundaryProfiles(table, std::span(impl->field.label.data(), static_cast<std::size_t>(impl->field.channels)));
  impl->warnings = facts.warnings;
  impl->midline_mm = facts.midline_mm, impl->trachea_mm = facts.trachea_mm;
  impl->textureOrigin_mm = textureOriginOf(facts.patient);
  for (int side = 0; side < 2; ++side) {
    // Sheets of the neck are parallel to its outside: their normal points forward and outward (patient right is -x).
    const Vec3 outward = normalized({side == 0 ? -0.55 : 0.55, -0.83, 0.05});
    for (int l = 0; l < kLabelCount; ++l) {
      const Texture texture = table.of(static_cast<std::uint8_t>(l)).texture;
      Directions directions{
          l == kSternocleidomastoid ? facts.muscleFibre[side] : normalized({side == 0 ? 0.12 : -0.12, 0.08, 1.0}),
          outward};
      if (texture == Texture::Septa) directions = askew(directions, l, side, facts.patient);
      impl->textureFrames[l][side] =
          frameOf(textureTile(texture), impl->textureOrigin_mm, directions.fibre, directions.outward);
    }
  }
  return std::shared_ptr<const AcousticScene>(new AcousticScene(std::move(impl)));
}

}  // namespace insonate
