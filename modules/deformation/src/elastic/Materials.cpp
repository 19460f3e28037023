#include "elastic/Materials.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::elastic {
namespace {

constexpr float kBloodMu_kPa = 0.1f;  // material of a lumen besides pressure, which keeps its cells regular
/// Area modulus of blood beside the small cells, which keeps its area: a vein in cells of up to 12 mm has no wall that
/// would hold it, and would lift the skin by millimeters.
constexpr float kStillBulk_kPa = 200;
constexpr float kGasMu_kPa = Materials::kGasMu_kPa;
constexpr float kStiffest_kPa = 2000;  // a higher stiffness makes no difference to the tissue around it

struct Moduli {
  float mu = 0, bulk = 0, logMu = 0;

  Moduli(float m, float b) : mu(m), bulk(b), logMu(std::log(m)) {}
  Moduli() = default;
};

Moduli moduliOf(double young_kPa, double poisson) {
  const double e = std::min(young_kPa, double(kStiffest_kPa));
  const double mu = e / (2 * (1 + poisson));
  return {float(mu), float(mu + e * poisson / ((1 + poisson) * (1 - 2 * poisson)))};
}

Moduli moduliOf(const MechanicalTissue& tissue) {
  switch (tissue.kind) {
    case Mechanics::Lumen:
      return {kBloodMu_kPa, 0};
    case Mechanics::Gas:
      return {kGasMu_kPa, 2 * kGasMu_kPa};
    default:
      return moduliOf(tissue.young_kPa, tissue.poisson);
  }
}

bool isRigid(const MechanicalTissue& tissue) {
  return tissue.kind == Mechanics::Rigid || (tissue.kind == Mechanics::Solid && std::isinf(tissue.young_kPa));
}

/// Share of a cell that is nearer than `reach` to a structure, from the distances at its corners.
float shareWithin(const std::array<float, 4>& corner, float reach, float size) {
  float share = 0;
  for (const float r : {0.25f, 0.75f})
    for (const float s : {0.25f, 0.75f}) {
      const float distance =
          (1 - s) * ((1 - r) * corner[0] + r * corner[1]) + s * ((1 - r) * corner[3] + r * corner[2]);
      share += std::clamp(0.5f + (reach - distance) / (0.5f * size), 0.0f, 1.0f) / 4;
    }
  return share;
}

/// The layers of a vessel, as moduli.
struct Vessel {
  bool lumen = false;
  float wall_mm = 0, reach_mm = 0;  ///< thickness of the wall; of wall and loose tissue together
  Moduli inside, wall, sheath;

  explicit Vessel(const MechanicalTissue& t)
      : lumen(t.kind == Mechanics::Lumen),
        wall_mm(lumen ? float(t.wall_mm) : 0),
        reach_mm(lumen ? float(t.wall_mm + t.sheath_mm) : 0),
        inside(moduliOf(t)),
        wall(moduliOf(t.wallYoung_kPa, 0.49)),
        sheath(moduliOf(t.sheathYoung_kPa, 0.49)) {}
};

/// Mixture of a cell's materials. Walls, blood and gas count by their shares, since the stiffness of a membrane is
/// proportional to its thickness. Solids in one cell count by the geometric mean (Lichtenecker): an arithmetic mean
/// makes stiff bodies half a cell thicker, and a mesh of 0.5 mm 5 % stiffer than one of 0.25 mm; a harmonic mean makes
/// them thinner.
struct Mixture {
  float mu = 0, bulk = 0;
  float left = 1;  ///< share that is not yet assigned
  float solid = 0, logMu = 0;

  void addLayer(const Moduli& m, float share) {
    share = taken(share);
    mu += share * m.mu;
    bulk += share * m.bulk;
  }
  void addSolid(const Moduli& m, float share) {
    share = taken(share);
    bulk += share * m.bulk;
    logMu += share * m.logMu;
    solid += share;
  }
  void add(const Moduli& m, float share) { m.mu > kGasMu_kPa ? addSolid(m, share) : addLayer(m, share); }
  float wholeMu() const { return solid > 0 ? mu + solid * std::exp(logMu / solid) : mu; }

 private:
  float taken(float share) {
    share = std::clamp(share, 0.0f, left);
    left -= share;
    return share;
  }
};

/// The remainder has the materials of the cell's middle (the first of `labels`) and of its corners, in equal parts.
void addRest(const std::array<std::uint8_t, 5>& labels, const std::array<Moduli, kLabelCount>& solid,
             Mixture& mixture) {
  const bool inGas = labels[0] == kBackground;  // nodes of the skin may lie on either side of it
  std::array<float, 5> share{4, 1, 1, 1, 1};
  float weight = 0;
  for (int k = 0; k < 5; ++k) {
    const Label label = knownLabel(labels[k]);
    if (label == kArtery || label == kVein || (label == kBackground && !inGas)) share[k] = 0;
    weight += share[k];
  }
  if (weight == 0) {
    mixture.addSolid(solid[kSoftTissue], 1);
    return;
  }
  const float unspoken = mixture.left / weight;
  for (int k = 0; k < 5; ++k)
    if (share[k] > 0) mixture.add(solid[knownLabel(labels[k])], unspoken * share[k]);
}

}  // namespace

/// Adds the stiffness of the walls of vessels that run along the plane.
void Materials::addTubes(const Mesh& mesh, const TissuePlane& plane, const MechanicalTable& tissues) {
  const auto add = [&](float PlaneTissue::*outline, Label label, const std::vector<float>& blood) {
    tubes_.find(mesh, plane, outline, tissues.of(label), blood, tube_);
    for (std::size_t n = 0; n < blood.size(); ++n) {
      bulk[n] += blood[n] * tube_[n].narrower_kPa;
      hoop[n] += blood[n] * (tube_[n].wider_kPa - tube_[n].narrower_kPa);
    }
  };
  add(&PlaneTissue::artery_mm, kArtery, arteryBlood);
  add(&PlaneTissue::vein_mm, kVein, veinBlood);
}

void Materials::fill(const Mesh& mesh, const TissuePlane& plane, const MechanicalTable& tissues) {
  const int nx = mesh.columns(), nz = mesh.rows();
  const std::size_t size = std::size_t(nx) * nz + GridMatrix::kPadding;
  for (auto* v : {&mu, &bulk, &hoop, &artery, &vein, &arteryBlood, &veinBlood}) v->assign(size, 0.0f);
  fixed.assign(std::size_t(nx) * nz, 0);
  anyBlood = false;
  std::array<Moduli, kLabelCount> solid;
  std::array<bool, kLabelCount> rigid;
  for (int l = 0; l < kLabelCount; ++l) {
    rigid[l] = l != kBackground && isRigid(tissues.tissues[l]);
    solid[l] = l == kBackground ? Moduli{kGasMu_kPa, 2 * kGasMu_kPa} : moduliOf(tissues.tissues[l]);
  }
  const Vessel vessels[2] = {Vessel(tissues.of(kArtery)), Vessel(tissues.of(kVein))};
  constexpr float PlaneTissue::*kDistance[2] = {&PlaneTissue::artery_mm, &PlaneTissue::vein_mm};
  const bool boneRigid = isRigid(tissues.of(kBone));
  const auto& tissue = mesh.tissue();
  const Nodes& rest = mesh.rest();
  const FineBlocks& across = mesh.lines().across;
  const Moduli still{kBloodMu_kPa, kStillBulk_kPa};

  for (int j = 0; j < nz; ++j)
    for (int i = 0; i < nx; ++i) {
      const std::size_t n = std::size_t(j) * nx + i;
      fixed[n] = j == nz - 1 || i == 0 || i == nx - 1 || rigid[knownLabel(tissue[n].label)] ||
                 (boneRigid && tissue[n].bone_mm <= 0);
    }
  for (int j = 0; j + 1 < nz; ++j)
    for (int i = 0; i + 1 < nx; ++i) {
      const std::size_t n = std::size_t(j) * nx + i;
      const std::size_t corner[4] = {n, n + 1, n + 1 + nx, n + nx};
      const float cell = 0.5f * (rest.x[n + 1] - rest.x[n] + rest.z[n + nx] - rest.z[n]);
      const float middle_mm = 0.5f * (mesh.lines().x_mm[i] + mesh.lines().x_mm[i + 1]);
      const bool beside = middle_mm < across.first_mm || middle_mm > across.end_mm();
      Mixture mixture;
      for (int v = 0; v < 2; ++v) {
        std::array<float, 4> distance;
        for (int c = 0; c < 4; ++c) distance[c] = tissue[corner[c]].*kDistance[v];
        const auto [least, most] = std::minmax_element(distance.begin(), distance.end());
        const float reach = vessels[v].reach_mm;
        if (*least > reach + cell) continue;
        const float spread = std::max(*most - *least, 0.2f * cell);
        const float inside = shareWithin(distance, 0, spread);
        if (!beside) (v == 0 ? artery : vein)[n] = inside;
        if (vessels[v].lumen) (v == 0 ? arteryBlood : veinBlood)[n] = inside, anyBlood |= inside > 0;
        mixture.addLayer(beside && vessels[v].lumen ? still : vessels[v].inside, inside);
        if (reach <= 0) continue;
        const float wall = shareWithin(distance, vessels[v].wall_mm, spread);
        mixture.addLayer(vessels[v].wall, wall - inside);
        mixture.addSolid(vessels[v].sheath, shareWithin(distance, reach, spread) - wall);
      }
      addRest({mesh.middle()[n].label, tissue[n].label, tissue[n + 1].label, tissue[n + 1 + nx].label,
               tissue[n + nx].label},
              solid, mixture);
      mu[n] = mixture.wholeMu();
      bulk[n] = mixture.bulk;
    }
  if (anyBlood) addTubes(mesh, plane, tissues);
}

}  // namespace insonate::elastic
