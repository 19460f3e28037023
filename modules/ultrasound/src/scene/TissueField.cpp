#include "scene/TissueField.h"

#include "scene/TissueTiles.h"

#include <insonate/tissue/Labels.h>

#include <tbb/parallel_for.h>

#include <algorithm>

namespace insonate {
namespace {

void nameChannels(const std::vector<TissueTiles::TilePtr>& tiles, TissueField& field) {
  std::uint32_t present = 0;
  for (const auto& tile : tiles)
    for (const std::uint8_t label : tile->labels) present |= 1U << label;
  for (int label = 0; label < kLabelCount; ++label) {
    if (!(present >> label & 1)) continue;
    if (label == kBackground) field.backgroundChannel = field.channels;
    field.label[field.channels++] = static_cast<std::uint8_t>(label);
  }
}

void copyTile(const TissueTile& tile, const NodeBox& box, const TissueField::Distances& far, TissueField& field) {
  const NodeBox shared = overlap(tile.box, box);
  std::vector<int> channel;
  for (const std::uint8_t label : tile.labels)
    channel.push_back(static_cast<int>(std::ranges::find(field.label, label) - field.label.begin()));
  const std::size_t nodes = tile.box.count();
  for (int k = shared.low[2]; k < shared.high(2); ++k)
    for (int j = shared.low[1]; j < shared.high(1); ++j) {
      const std::size_t from = tile.box.offset(shared.low[0], j, k), to = box.offset(shared.low[0], j, k);
      TissueField::Distances* row = field.distance.data() + to;
      std::fill_n(row, shared.size[0], far);
      for (std::size_t s = 0; s < channel.size(); ++s) {
        const std::int16_t* distance = tile.distance.data() + s * nodes + from;
        for (int i = 0; i < shared.size[0]; ++i) row[i].to[channel[s]] = distance[i];
      }
      std::copy_n(tile.ctDeviation.data() + from, shared.size[0], field.ctDeviation.data() + to);
    }
}

}  // namespace

Result<TissueField> makeTissueField(TissueTiles& tiles, const Region& region, const Progress& progress) {
  const NodeLattice& lattice = tiles.lattice();
  const NodeBox box = lattice.boxOf(region);
  if (box.count() == 0) return fail("The image plane lies outside the CT; move the probe onto the patient.");
  const auto covering = tiles.covering(box, progress);
  if (!covering) return tl::unexpected(covering.error());

  TissueField field;
  field.size = box.size;
  Transform fieldFromNode;
  for (int a = 0; a < 3; ++a) fieldFromNode.offset[a] = -box.low[a];
  field.nodeFromPatient = fieldFromNode * lattice.nodeFromPatient;
  nameChannels(*covering, field);
  field.distance.resize(box.count());
  field.ctDeviation.resize(box.count() + TissueField::kPadding);
  std::fill(field.ctDeviation.end() - TissueField::kPadding, field.ctDeviation.end(), std::int16_t{0});

  TissueField::Distances far;
  std::ranges::fill(far.to, lattice.farUnits());
  tbb::parallel_for(std::size_t{0}, covering->size(),
                    [&](std::size_t t) { copyTile(*(*covering)[t], box, far, field); });
  return field;
}

}  // namespace insonate
