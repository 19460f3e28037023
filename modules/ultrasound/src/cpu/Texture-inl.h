// Structure that a CT does not resolve: septa, lobules and sheets within tissues, and layers at their boundaries.
#if defined(INSONATE_CPU_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_TEXTURE_INL_H_
#undef INSONATE_CPU_TEXTURE_INL_H_
#else
#define INSONATE_CPU_TEXTURE_INL_H_
#endif

#include "cpu/Lanes-inl.h"
#include "cpu/Shifts-inl.h"
#include "cpu/TraceInput.h"
#include "model/Boundary.h"

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Scattering level, and the share of the scattering that comes from sheets, which echo coherently.
struct Scattering {
  GateVec echo_dB, sheet;
};

/// Returns the texture of one structure on one side of the midline, -127 to 127. The echo of sheets depends on the
/// beam's angle to them. `line` is the vector's first scanline; `shift`, if not null, leads from the displayed points
/// to the rest positions of their tissue.
HWY_INLINE GateVec textureOf(const TextureTile& tile, const TextureRays& rays, int line, GateVec range,
                             const PlaneShifts<GateVec>* shift, float elevation_mm) {
  const GateTag d;
  const GateIntTag di;
  const auto index = [&](const std::vector<float>& origin, const std::vector<float>& direction, float lateral,
                         float axial, float across, int size) {
    auto onPlane = hn::MulAdd(hn::LoadU(d, direction.data() + line), range, hn::LoadU(d, origin.data() + line));
    if (shift) onPlane = carried(d, onPlane, *shift, lateral, axial);
    return hn::And(wholeBits(hn::Add(onPlane, hn::Set(d, across * elevation_mm))), hn::Set(di, size - 1));
  };
  const auto &lateral = rays.axes.lateral, &axial = rays.axes.axial;
  const auto u = index(rays.line.x, rays.line.dx, lateral.x, axial.x, rays.elevationX, tile.size[0]),
             v = index(rays.line.y, rays.line.dy, lateral.y, axial.y, rays.elevationY, tile.size[1]),
             w = index(rays.line.z, rays.line.dz, lateral.z, axial.z, rays.elevationZ, tile.size[2]);
  const auto place = hn::Add(hn::Add(hn::Mul(v, hn::Set(di, tile.stepV())), hn::Mul(u, hn::Set(di, tile.stepU()))), w);
  const auto value = hn::ConvertTo(d, byteOf<0>(tileWords(tile, place)));
  const auto facing = hn::LoadU(d, rays.facing.data() + line);
  return hn::IfThenElse(hn::Gt(value, hn::Zero(d)), hn::Mul(value, facing), value);
}

/// Adds to `here` the texture of each structure that occurs in the cells of this row, in the SIMD lanes that lie in the
/// structure. `right` marks the lanes right of the patient's midline.
HWY_INLINE void addTexture(const TraceInput& in, std::uint32_t present, GateInt channel, hn::Mask<GateTag> right,
                           int line, GateVec range, const PlaneShifts<GateVec>* shift, float elevation_mm,
                           Scattering& here) {
  const GateTag d;
  const GateIntTag di;
  for (std::uint32_t left = present & in.texturedChannels; left; left &= left - 1) {
    const int ch = __builtin_ctz(left);
    const auto mine = hn::RebindMask(d, hn::Eq(channel, hn::Set(di, ch)));
    if (hn::AllFalse(d, mine)) continue;
    const ChannelConstants& structure = in.channels[ch];
    for (int side = 0; side < 2; ++side) {
      const auto lanes = side == 0 ? hn::And(mine, right) : hn::AndNot(right, mine);
      if (hn::AllFalse(d, lanes)) continue;
      const auto value = hn::IfThenElseZero(
          lanes, textureOf(*structure.tile, in.textureRays[ch][side], line, range, shift, elevation_mm));
      here.echo_dB = hn::MulAdd(value, hn::Set(d, structure.textureStrength_dB / 127), here.echo_dB);
      if (structure.sheets)
        here.sheet = hn::Max(here.sheet, hn::Mul(value, hn::Set(d, static_cast<float>(kSheetCoherence / 127))));
    }
  }
}

/// Adds to `here` the connective layers at a boundary, whose echo replaces that of the tissue.
HWY_INLINE void addLayers(const TraceInput& in, const TraceBuffers::CellRow& cells, int l, GateVec s, GateVec down,
                          Scattering& here) {
  const GateTag d;
  const auto within = [&](const float* top, const float* bottom) {
    const auto t = hn::Load(d, top + l);
    return hn::MulAdd(down, hn::Sub(hn::Load(d, bottom + l), t), t);
  };
  const GateIntTag di;
  const auto scaled = hn::Floor(hn::MulAdd(s, hn::Set(d, static_cast<float>(1 / BoundaryProfiles::kStep_mm)),
                                           within(cells.wanderTop_steps, cells.wanderBottom_steps)));
  const auto entry = hn::Add(hn::ConvertTo(di, scaled), hn::Set(di, BoundaryProfiles::kEntries / 2));
  const auto inReach = hn::And(hn::Gt(entry, hn::Set(di, -1)), hn::Lt(entry, hn::Set(di, BoundaryProfiles::kEntries)));
  if (hn::AllFalse(di, inReach)) return;
  const auto index = hn::Add(hn::Load(di, cells.profile + l), hn::IfThenElseZero(inReach, entry));
  const auto packed =
      hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(in.scene->profiles.entries().data()), index);
  const auto byteMask = hn::Set(di, 255);
  const auto unit = hn::Set(d, 1.0F / 255);
  const auto toFloat = [&](GateInt v) { return hn::ConvertTo(d, hn::And(v, byteMask)); };
  const auto occupancy = hn::Mul(toFloat(packed), unit);
  const auto echo = hn::MulAdd(toFloat(hn::ShiftRight<8>(packed)), hn::Set(d, 0.25F), hn::Set(d, -32.0F));
  const auto anisotropy = hn::Mul(toFloat(hn::ShiftRight<16>(packed)), unit);
  const auto patchiness = hn::Mul(toFloat(hn::ShiftRight<24>(packed)), unit);
  const auto one = hn::Set(d, 1.0F);
  const auto patch = within(cells.patchTop, cells.patchBottom);
  // layerCover() in model/Boundary.h.
  const auto presence = hn::MulAdd(hn::Set(d, static_cast<float>(kLayerPresencePerPatch)), patch,
                                   hn::Set(d, static_cast<float>(kLayerPresence)));
  const auto absence = hn::Sub(one, hn::Min(one, hn::Max(hn::Zero(d), presence)));
  const auto covered = hn::Max(hn::Zero(d), hn::NegMulAdd(patchiness, absence, occupancy));
  const auto layer = hn::MulAdd(anisotropy, hn::Load(d, cells.facing_dB + l), echo);
  const auto coverHere = hn::IfThenElseZero(hn::RebindMask(d, inReach), covered);
  here.echo_dB = hn::MulAdd(coverHere, hn::Sub(layer, here.echo_dB), here.echo_dB);
  here.sheet = hn::MulAdd(
      coverHere, hn::Sub(hn::Mul(anisotropy, hn::Set(d, static_cast<float>(kSheetCoherence))), here.sheet), here.sheet);
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
