#include <insonate/image/VoxelBox.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/simulator/ImportedLabels.h>
#include <insonate/simulator/VesselNaming.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace insonate {
namespace {

/// A vessel of one or more structures, and the voxels around them.
struct ImportedVessel {
  std::string name;
  std::uint8_t label = 0;
  VoxelBox box{};
};

struct ImportedVessels {
  std::vector<ImportedVessel> all;
  std::vector<std::size_t> ofPart{0};  ///< place in `all`, counted from 1, by the number of the structure
};

ImportedVessels vesselsIn(const LabelReadResult& read) {
  ImportedVessels vessels;
  std::map<std::string, std::size_t> placeOf;
  for (const ReadStructure& structure : read.structures) {
    std::size_t place = 0;
    if (!structure.vessel.empty()) {
      const auto [found, isNew] = placeOf.try_emplace(structure.vessel, vessels.all.size() + 1);
      if (isNew) vessels.all.push_back({structure.vessel, structure.label});
      place = found->second;
    }
    vessels.ofPart.push_back(place);
  }
  const VolumeGeometry& g = read.parts.geometry;
  std::size_t v = 0;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i, ++v)
        if (const std::size_t place = vessels.ofPart[read.parts.voxels[v]]; place > 0) {
          VoxelBox& box = vessels.all[place - 1].box;
          box = united(box, {{i, j, k}, {i + 1, j + 1, k + 1}});
        }
  return vessels;
}

/// The vessel alone, with one voxel around it.
LabelMap maskOf(const LabelReadResult& read, const ImportedVessels& vessels, std::size_t place) {
  const ImportedVessel& vessel = vessels.all[place - 1];
  VoxelBox box = vessel.box;
  for (int a = 0; a < 3; ++a) --box.first[a], ++box.end[a];
  const Volume<std::uint16_t> parts = cropped(read.parts, intersected(box, boxOf(read.parts.geometry)));
  LabelMap mask(parts.geometry);
  for (std::size_t v = 0; v < parts.voxels.size(); ++v)
    if (vessels.ofPart[parts.voxels[v]] == place) mask.voxels[v] = vessel.label;
  return mask;
}

/// Tells whether an imported structure replaces an automatic label.
bool replaces(std::uint8_t imported, std::uint8_t automatic) {
  if (automatic == kBackground || automatic == kSkin || automatic == kAirway) return false;
  switch (imported) {
    case kBackground:
    case kSkin:
    case kFat:
    case kAirway:
    case kMuscle:
    case kBone:
    case kSoftTissue:
      return false;
    case kVein:
    case kArtery:
    case kThyroid:
    case kCartilage:
      return true;  // with contrast agent or calcified, they are as dense as bone
    default:
      return automatic != kBone;
  }
}

}  // namespace

Result<void> makeImportedVessels(LabelReadResult& read, const Progress& progress) {
  read.vessels.clear();
  if (read.parts.voxels.empty()) return {};
  const ImportedVessels vessels = vesselsIn(read);
  for (std::size_t place = 1; place <= vessels.all.size(); ++place) {
    if (!report(progress, "Naming vessels", double(place - 1) / double(vessels.all.size())))
      return fail(std::string(kCancelled));
    const ImportedVessel& vessel = vessels.all[place - 1];
    if (vessel.box.empty()) continue;
    auto named = longestVessel(maskOf(read, vessels, place), vessel.label, vessel.name);
    if (named)
      read.vessels.push_back(std::move(*named));
    else
      read.notes.push_back(named.error().message);
  }
  return {};
}

bool needsRest(const LabelReadResult& read) {
  return std::ranges::none_of(read.labels.voxels, [](std::uint8_t label) { return label == kSkin; });
}

Result<void> labelRest(const CtVolume& ct, LabelReadResult& read, const Progress& progress) {
  auto automatic = autoLabel(ct, progress);
  if (!automatic) return tl::unexpected(automatic.error());
  for (std::size_t v = 0; v < read.labels.voxels.size(); ++v) {
    std::uint8_t& label = read.labels.voxels[v];
    if (replaces(label, automatic->voxels[v])) continue;
    label = automatic->voxels[v];
    if (!read.parts.voxels.empty()) read.parts.voxels[v] = 0;
  }
  read.notes.push_back(
      "Skin, air, bone, fat and muscle were labeled from the Hounsfield units of the CT; the other structures are "
      "those "
      "of the import.");
  return {};
}

}  // namespace insonate
