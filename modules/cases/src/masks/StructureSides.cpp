#include "StructureSides.h"

#include "../structures/FoldedWords.h"
#include "../structures/StructureTable.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// A vessel that is nearer to the middle of the body lies on no certain side.
constexpr double kMiddle_mm = 10;

const Structure* structureNamed(const std::string& name) {
  const auto& all = structureTable().structures;
  const auto found = std::ranges::find(all, name, &Structure::name);
  return found == all.end() ? nullptr : &*found;
}

/// Middle of the body's outline in the slices near `center_mm`; every fourth voxel suffices.
double outlineMiddle_mm(const CtVolume& ct, Vec3 center_mm) {
  constexpr int kStep = 4;
  constexpr std::int16_t kTissue_HU = -400;
  constexpr double kNear_mm = 5;
  const VolumeGeometry& g = ct.geometry;
  const Transform patientFromIndex = g.patientFromIndex();
  double sum = 0;
  std::size_t count = 0;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; j += kStep)
      for (int i = 0; i < g.size[0]; i += kStep) {
        if (ct.at(i, j, k) < kTissue_HU) continue;
        const Vec3 at_mm = patientFromIndex * Vec3{double(i), double(j), double(k)};
        if (std::abs(at_mm.z - center_mm.z) > kNear_mm + g.spacing_mm.z) continue;
        sum += at_mm.x;
        ++count;
      }
  return count > 0 ? sum / double(count) : center_mm.x;
}

/// Middle of the body near a place: that of the airway, larynx or spine if the file has them there, else that of the
/// body's outline.
double middleOfBody_mm(const PatientCase& patient, const PartComposer& placed, const LabelReadResult& result,
                       Vec3 center_mm) {
  constexpr double kNear_mm = 60;
  double sum = 0;
  int count = 0;
  for (std::size_t n = 0; n < result.structures.size(); ++n) {
    const auto number = static_cast<std::uint16_t>(n + 1);
    const Structure* known = structureNamed(result.structures[n].known);
    if (!known || !known->isMidline || placed.part(number).voxels == 0) continue;
    const Vec3 middle_mm = placed.centerOf_mm(number);
    if (std::abs(middle_mm.z - center_mm.z) > kNear_mm) continue;
    sum += middle_mm.x;
    ++count;
  }
  return count > 0 ? sum / count : outlineMiddle_mm(patient.ct, center_mm);
}

std::string wordOf(BodySide side) {
  return side == BodySide::Right ? "right" : "left";
}

/// Side by name and location. `offset_mm` is the distance to the left of the middle of the body.
std::optional<BodySide> sideOf(ReadStructure& structure, double offset_mm, std::vector<std::string>& notes) {
  auto stated = sideInName(structure.name);
  const BodySide there = offset_mm > 0 ? BodySide::Left : BodySide::Right;
  const bool isCertain = std::abs(offset_mm) >= kMiddle_mm;
  const std::string distance = std::to_string(std::lround(std::abs(offset_mm))) + " mm";
  const std::string quoted = "\"" + structure.key() + "\"";
  if (stated && (!isCertain || stated == there)) return stated;
  if (!stated && isCertain) {
    notes.push_back("The name " + quoted + " states no side; the structure lies " + distance + " to the " +
                    wordOf(there) + " of the middle of the body and was taken as the " + wordOf(there) + " one.");
    return there;
  }
  structure.state = StructureState::kDoubtful;
  structure.doubt = stated
                        ? "The name " + quoted + " states the " + wordOf(*stated) + " side, but the structure lies " +
                              distance + " to the " + wordOf(there) + " of the middle of the body."
                        : "The name " + quoted + " states no side, and the structure lies only " + distance +
                              " from the middle of the body.";
  return std::nullopt;
}

}  // namespace

void nameVessels(const PatientCase& patient, const PartComposer& placed, const StructureChoices& choices,
                 LabelReadResult& result) {
  for (std::size_t n = 0; n < result.structures.size(); ++n) {
    ReadStructure& structure = result.structures[n];
    const Structure* known = structureNamed(structure.known);
    const bool isVessel = structure.label == kVein || structure.label == kArtery;
    if (structure.state != StructureState::kTaken || !isVessel || !known || known->isGroup ||
        known->label != structure.label)
      continue;
    if (!known->hasSides) {
      structure.vessel = known->name;
      continue;
    }
    std::optional<BodySide> side;
    if (const auto chosen = choices.sides.find(structure.key()); chosen != choices.sides.end()) {
      if (chosen->second == SideAnswer::Both) continue;
      side = chosen->second == SideAnswer::Right ? BodySide::Right : BodySide::Left;
    } else {
      const Vec3 center_mm = placed.centerOf_mm(static_cast<std::uint16_t>(n + 1));
      side = sideOf(structure, center_mm.x - middleOfBody_mm(patient, placed, result, center_mm), result.notes);
    }
    if (side) structure.vessel = wordOf(*side) + " " + known->name;
  }
}

}  // namespace insonate
