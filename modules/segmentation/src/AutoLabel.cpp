#include "Body.h"
#include "Bone.h"
#include "Calm.h"

#include <insonate/segmentation/AutoLabel.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>

namespace insonate {
namespace segmentation {
namespace {

constexpr int kFatBelow_HU = -30;        // halfway between fat (-100) and muscle (50)
constexpr int kPaddingBelow_HU = -1500;  // outside the scanner's field of view; no tissue has this value
// Width of the zone in which a mixture of air and skin looks like fat: two and a half standard deviations of the blur,
// which is the scanner's (0.4 mm), or that with the smoothing of a noisy CT.
constexpr double kSkin_mm = 2, kBlurredSkin_mm = 1, kCalmedSkin_mm = 1.6;
// Noise above the first limit hides the border between skin (30 HU) and fat, above the second it turns blood into bone.
// The CT is then smoothed, although this widens bone a little.
constexpr double kSkinHidden_HU = 24, kLoud_HU = 28;
constexpr double kStrand_mm = 1.6;  // tissue thinner than twice this is not muscle
constexpr double kPasses = 60;      // number of calls of Work::slices below, for the progress

void labelBone(LabelMap& labels, const CtVolume& ct, Work& work) {
  const Mask bone = findBone(ct, labels, work);
  work.voxels(ct.geometry, [&](std::size_t v) {
    if (bone.voxels[v]) labels.voxels[v] = kBone;
  });
}

/// Separates fat, muscle and the strands between them in the remaining soft tissue. Voxels that line an airway mix air
/// and tissue, which looks like fat; they stay soft tissue.
void labelFatAndMuscle(LabelMap& labels, const CtVolume& ct, Work& work) {
  Mask lining(ct.geometry);
  work.voxels(ct.geometry, [&](std::size_t v) { lining.voxels[v] = labels.voxels[v] == kAirway; });
  dilateToNeighbors(lining, work);

  Mask fat(ct.geometry);
  work.voxels(ct.geometry, [&](std::size_t v) { fat.voxels[v] = ct.voxels[v] < kFatBelow_HU; });
  majorityInSlice(fat, work);
  work.voxels(ct.geometry, [&](std::size_t v) {
    if (labels.voxels[v] == kSoftTissue && fat.voxels[v] && !lining.voxels[v]) labels.voxels[v] = kFat;
  });

  Mask& firm = fat;
  work.voxels(ct.geometry, [&](std::size_t v) {
    firm.voxels[v] = labels.voxels[v] == kBone || (labels.voxels[v] == kSoftTissue && !lining.voxels[v]);
  });
  open(firm, kStrand_mm, work);
  work.voxels(ct.geometry, [&](std::size_t v) {
    if (labels.voxels[v] == kSoftTissue && firm.voxels[v] && !lining.voxels[v]) labels.voxels[v] = kMuscle;
  });
}

/// Depth near air within which fat cannot be distinguished from skin.
double skinThatLooksLikeFat_mm(double noise_HU, const VolumeGeometry& geometry) {
  if (noise_HU < kSkinHidden_HU) return kBlurredSkin_mm;
  return noise_HU > kLoud_HU && canBeCalmed(geometry) ? kCalmedSkin_mm : kSkin_mm;
}

/// Padding is not air that touches the patient, so that there is no skin beside it. Visible fat is not skin, unless it
/// lies so near to air that blur has mixed them.
void labelSkin(LabelMap& labels, const CtVolume& ct, double blurred_mm, Work& work) {
  Mask shell(ct.geometry), rim(ct.geometry);
  work.voxels(ct.geometry, [&](std::size_t v) {
    shell.voxels[v] = labels.voxels[v] == kBackground && ct.voxels[v] > kPaddingBelow_HU;
    rim.voxels[v] = shell.voxels[v];
  });
  dilate(shell, kSkin_mm, work);
  dilate(rim, blurred_mm, work);
  work.voxels(ct.geometry, [&](std::size_t v) {
    shell.voxels[v] &= std::uint8_t(rim.voxels[v] || labels.voxels[v] != kFat);
    rim.voxels[v] = labels.voxels[v] == kBackground && ct.voxels[v] > kPaddingBelow_HU;
  });
  dilateToNeighbors(rim, work);
  work.voxels(ct.geometry, [&](std::size_t v) {
    const std::uint8_t label = labels.voxels[v];
    if (label != kBackground && label != kAirway && (shell.voxels[v] || rim.voxels[v])) labels.voxels[v] = kSkin;
  });
}

/// Without air the outline of the patient is unknown; a label map or a CT in other units has none.
Result<void> checkHasAir(const CtVolume& ct) {
  constexpr int kAirBelow_HU = -300;
  if (std::ranges::any_of(ct.voxels, [](std::int16_t hu) { return hu < kAirBelow_HU; })) return {};
  return fail(
      "There is no air in this CT (no value is below -300 HU), so its skin cannot be found. It is probably a label "
      "map, or not in Hounsfield units, or a part of the inside of a body. Import a series whose air is near -1000 HU, "
      "or label this CT with the tools, for example with a threshold.");
}

Result<void> checkIsMixed(const LabelMap& labels) {
  constexpr double kNearlyAll = 0.998;
  std::array<std::size_t, 256> count{};
  for (const std::uint8_t label : labels.voxels) ++count[label];
  const auto most = std::ranges::max_element(count);
  if (static_cast<double>(*most) < kNearlyAll * static_cast<double>(labels.voxels.size())) return {};
  return fail("Nearly everything in this CT would be labeled " +
              std::string(labelTable()[static_cast<std::size_t>(most - count.begin())].name) +
              ": it is probably a label map or not in Hounsfield units.");
}

}  // namespace
}  // namespace segmentation

Result<LabelMap> autoLabel(const CtVolume& ct, const Progress& progress) {
  using namespace segmentation;
  if (auto ok = validate(ct.geometry); !ok) return tl::unexpected(ok.error());
  if (ct.voxels.size() != ct.geometry.voxelCount())
    return fail("The CT holds " + std::to_string(ct.voxels.size()) + " voxels where its grid has " +
                std::to_string(ct.geometry.voxelCount()) + ".");
  if (auto ok = checkHasAir(ct); !ok) return tl::unexpected(ok.error());
  try {
    Work work(progress, kPasses);
    work.start("Finding the body");
    std::optional<LabelMap> labels = findBody(ct, work);
    if (!labels)
      return fail(
          "No body was found in this CT: nothing in it is denser than air and thicker than a couch. Check that its "
          "values are Hounsfield units.");
    work.start("Finding bone");
    const double noise_HU = noiseInBody_HU(ct, *labels, work);
    const bool isLoud = noise_HU > kLoud_HU;
    const CtVolume calm = isLoud ? calmed(ct, work) : CtVolume();
    const CtVolume& hu = isLoud ? calm : ct;
    labelBone(*labels, hu, work);
    work.start("Finding fat and muscle");
    labelFatAndMuscle(*labels, hu, work);
    work.start("Finding skin");
    labelSkin(*labels, ct, skinThatLooksLikeFat_mm(noise_HU, ct.geometry), work);
    if (auto ok = checkIsMixed(*labels); !ok) return tl::unexpected(ok.error());
    return std::move(*labels);
  } catch (const Cancelled&) {
    return fail(std::string(kCancelled));
  } catch (const std::bad_alloc&) {
    return fail("There is not enough memory to label this CT. Close other programs or crop the CT.");
  }
}

}  // namespace insonate
