#include "LabelAssembly.h"

#include "../files/LabelNames.h"
#include "../structures/FoldedWords.h"
#include "../structures/StructureTable.h"
#include "StructureSides.h"

#include <algorithm>
#include <set>

namespace insonate {
namespace {

/// Also recognizes the names that this program gives to unknown numbers.
std::optional<std::uint8_t> meaningOf(const NumberName& described) {
  if (const auto known = labelFromSnomed(described.snomedCode)) return *known;
  if (const auto known = labelFromAnyName(described.name)) return *known;
  for (int number = kLabelCount; number < 256; ++number)
    if (described.name == labelName(static_cast<std::uint8_t>(number))) return static_cast<std::uint8_t>(number);
  return std::nullopt;
}

constexpr int kBelowKnown = -1;

/// Labels of a file whose structures were not tracked voxel by voxel.
Volume<std::uint16_t> partsByLabel(const LabelReadResult& read) {
  std::array<std::uint16_t, 256> partOf{};
  for (std::size_t n = read.structures.size(); n > 0; --n)
    partOf[read.structures[n - 1].label] = static_cast<std::uint16_t>(n);
  Volume<std::uint16_t> parts(read.labels.geometry);
  for (std::size_t v = 0; v < parts.voxels.size(); ++v) parts.voxels[v] = partOf[read.labels.voxels[v]];
  return parts;
}

}  // namespace

void LabelAssembly::keepNumbers(const NumberNames& names) {
  for (const auto& [value, described] : names)
    if (const auto meaning = meaningOf(described)) numbers_.keep(*meaning);
}

/// Unknown structures must not hide known ones: plans of radiotherapy have target volumes that contain vessels.
int LabelAssembly::priorityOf(const ReadStructure& structure) const {
  const auto& priority = structureTable().priority;
  const auto found = priority.find(static_cast<Label>(structure.label));
  if (found != priority.end()) return found->second;
  if (!isOwnLabel(structure.label)) return 0;
  const bool isChosen = !choices_.only.empty() || choices_.taken.contains(structure.key());
  return isChosen ? int(priority.size()) : kBelowKnown;
}

Result<std::uint16_t> LabelAssembly::addEmpty(std::int32_t number, const NumberName& described) {
  ReadStructure structure{number, described.name};
  structure.details = described.details;
  structure.state = StructureState::kEmpty;
  result_.structures.push_back(std::move(structure));
  return composer_.addPart(kBelowAll, 0);
}

Result<std::uint16_t> LabelAssembly::add(std::int32_t number, const NumberName& described, const std::string& source,
                                         StructureRole role) {
  ReadStructure structure{number, described.name};
  structure.details = described.details;
  structure.known = knownStructure(described.name, described.snomedCode);
  const bool isUsual = role == StructureRole::kOrgan && !isLeftOut(described.name);
  if (!isTaken(structure, choices_, isUsual)) structure.state = StructureState::kLeftOut;
  if (const auto known = meaningOf(described)) {
    structure.label = *known;
  } else if (structure.state != StructureState::kLeftOut) {
    structure.label = numbers_.take(number);
    const bool isListed = isLeftOut(described.name);  // a name of the table is no name of a patient
    result_.notes.push_back(unknownStructure(
        source + " \"" + described.name + "\" (number " + std::to_string(number) + ")", structure.label));
    if (isOwnLabel(structure.label)) {
      result_.own[structure.label] = {isListed ? nameWithoutSide(described.name) : tidyLabelName(described.name),
                                      kSoftTissue};
      if (!isListed) result_.foreign.insert(structure.label);
    }
  }
  if (described.color && structure.label != 0 && !isUsualColor(structure.label, *described.color))
    result_.colors.try_emplace(structure.label, *described.color);
  const int priority = role == StructureRole::kOutline ? kBelowAll : priorityOf(structure);
  const std::uint8_t label = structure.label;
  result_.structures.push_back(std::move(structure));
  return composer_.addPart(priority, label);
}

Result<void> LabelAssembly::adopt(LabelReadResult&& read, const Progress& progress) {
  Volume<std::uint16_t> parts = read.parts.voxels.empty() ? partsByLabel(read) : std::move(read.parts);
  const auto before = static_cast<std::uint16_t>(result_.structures.size());
  std::map<std::uint8_t, std::uint8_t> renumbered;
  for (ReadStructure& structure : read.structures) {
    const std::uint8_t label = structure.label;
    if (isOwnLabel(label)) {
      const auto [given, isNew] = renumbered.try_emplace(label);
      if (isNew) given->second = numbers_.take(label);
      structure.label = given->second;
    }
    if (read.own.contains(label)) result_.own.try_emplace(structure.label, read.own[label]);
    if (read.foreign.contains(label)) result_.foreign.insert(structure.label);
    if (read.colors.contains(label)) result_.colors.try_emplace(structure.label, read.colors[label]);
    if (read.states.contains(label)) result_.states.try_emplace(structure.label, read.states[label]);
    const auto number = composer_.addPart(priorityOf(structure), structure.label);
    if (!number) return tl::unexpected(number.error());
    if (!isTaken(structure, choices_, true)) structure.state = StructureState::kLeftOut;
    result_.structures.push_back(std::move(structure));
  }
  for (std::uint16_t& part : parts.voxels)
    if (part != 0) part = isRead(part + before) ? static_cast<std::uint16_t>(part + before) : std::uint16_t{0};
  std::ranges::move(read.notes, std::back_inserter(result_.notes));
  result_.isUnnamed = result_.isUnnamed || read.isUnnamed;
  return composer_.place(parts, Sampling::kNearest, progress);
}

void LabelAssembly::fillLabels() {
  result_.parts = composer_.takeParts();
  result_.labels = LabelMap(result_.parts.geometry);
  for (std::size_t v = 0; v < result_.labels.voxels.size(); ++v)
    if (const std::uint16_t part = result_.parts.voxels[v]; part != 0)
      result_.labels.voxels[v] = result_.structures[part - 1u].label;
}

/// Removes labels of structures that were left out. A case contains no identity of the patient.
void LabelAssembly::forgetUnused() {
  std::set<std::uint8_t> used;
  for (const ReadStructure& structure : result_.structures)
    if (structure.state != StructureState::kLeftOut) used.insert(structure.label);
  std::erase_if(result_.own, [&used](const auto& own) { return !used.contains(own.first); });
  std::erase_if(result_.foreign, [&used](std::uint8_t label) { return !used.contains(label); });
  for (const std::uint8_t label : result_.foreign) result_.own[label].name.clear();
}

void LabelAssembly::noteUnited() {
  std::map<std::string, std::vector<std::string>> namesOf;
  for (const ReadStructure& structure : result_.structures)
    if (!structure.vessel.empty()) namesOf[structure.vessel].push_back(structure.key());
  for (const auto& [vessel, names] : namesOf) {
    if (names.size() < 2) continue;
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    result_.notes.push_back("These structures were united, since each is the " + vessel + ": " + list + ".");
  }
}

Result<LabelReadResult> LabelAssembly::finish() {
  if (composer_.isOutside())
    return fail("the labels lie outside the CT: they were drawn on another CT. Choose the labels of this CT.");
  std::string leftOut;
  for (std::size_t n = 0; n < result_.structures.size(); ++n) {
    ReadStructure& structure = result_.structures[n];
    structure.voxels = composer_.part(static_cast<std::uint16_t>(n + 1)).voxels;
    if (structure.state == StructureState::kTaken && structure.voxels == 0) structure.state = StructureState::kEmpty;
    if (structure.state == StructureState::kLeftOut) leftOut += (leftOut.empty() ? "" : ", ") + structure.key();
  }
  if (!leftOut.empty()) result_.notes.push_back("These structures were left out: " + leftOut + ".");
  nameVessels(patient_, composer_, choices_, result_);
  noteUnited();
  std::ranges::move(composer_.notes(), std::back_inserter(result_.notes));
  fillLabels();
  forgetUnused();
  return std::move(result_);
}

}  // namespace insonate
