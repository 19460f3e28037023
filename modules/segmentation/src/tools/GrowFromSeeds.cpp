#include "Gradient.h"
#include "Guarded.h"
#include "SeedFront.h"

#include <insonate/segmentation/GrowFromSeeds.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using segmentation::guarded;
using segmentation::SeedFront;
using segmentation::Work;

/// Finer than a Hounsfield unit, so that paths of a few millimeters differ.
constexpr double kStepsPerHu = 4;
constexpr double kMaxPerStep = SeedFront::kBuckets - 1;

Result<void> checkSeeds(const Seeds& seeds) {
  LabelSet found;
  for (const std::uint8_t label : seeds.painted.labels.voxels) found.set(label);
  found.reset(Proposal::kKeep);
  if (found.count() >= 2) return {};
  return fail(
      "Seeds of at least two labels are needed in the region, " + std::to_string(found.count()) +
      " found. Paint a part of the structure with its label, and a part of the surrounding tissue with another label.");
}

std::uint32_t whole(double cost) {
  return static_cast<std::uint32_t>(std::clamp(std::lround(cost), 1L, long(kMaxPerStep)));
}

}  // namespace

Seeds seedsOf(const LabelMap& labels, const VoxelBox& box, const LabelSet& which, const LabelSet& over) {
  Seeds seeds;
  seeds.painted.box = seeds.contested.box = box;
  if (box.empty()) return seeds;
  seeds.painted.labels = cropped(labels, box);
  seeds.contested = Selection(labels.geometry, box);
  for (std::size_t v = 0; v < seeds.painted.labels.voxels.size(); ++v) {
    std::uint8_t& label = seeds.painted.labels.voxels[v];
    seeds.contested.mask.voxels[v] = over.test(label) && !which.test(label);
    if (!which.test(label)) label = Proposal::kKeep;
  }
  return seeds;
}

Result<Proposal> grownFromSeeds(const CtVolume& ct, const Seeds& seeds, const SeedCompetition& competition,
                                const Progress& progress) {
  if (auto ok = checkSeeds(seeds); !ok) return tl::unexpected(ok.error());
  return guarded([&] {
    Work work(progress, 1.2);
    work.start("Growing from seeds");
    Proposal grown = seeds.painted;
    const Volume<float> hu = segmentation::blurred(ct, grown.box, competition.smoothing_mm);
    SeedFront front(grown, seeds.contested);
    front.run(work, [&](std::uint32_t cost, std::uint32_t from, std::uint32_t to, int axis) {
      const double way_HU =
          std::abs(hu.voxels[to] - hu.voxels[from]) + competition.lengthCost_HUpmm * hu.geometry.spacing_mm[axis];
      return cost + whole(kStepsPerHu * way_HU);
    });
    return grown;
  });
}

Result<Proposal> watershed(const CtVolume& ct, const Seeds& seeds, double smoothing_mm, const Progress& progress) {
  if (auto ok = checkSeeds(seeds); !ok) return tl::unexpected(ok.error());
  return guarded([&] {
    Work work(progress, 2.2);
    work.start("Finding edges");
    Proposal flooded = seeds.painted;
    const Volume<float> slope = segmentation::gradientMagnitude(ct, flooded.box, smoothing_mm, work);
    work.start("Flooding");
    SeedFront front(flooded, seeds.contested);
    // The cost is the water level on the path, not its length.
    front.run(work, [&](std::uint32_t cost, std::uint32_t, std::uint32_t to, int) {
      return std::max(cost, whole(kStepsPerHu * slope.voxels[to]));
    });
    return flooded;
  });
}

}  // namespace insonate
