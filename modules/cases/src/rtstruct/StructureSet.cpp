#include "../files/LabelGrid.h"
#include "../files/LabelNames.h"
#include "../files/OwnNumbers.h"
#include "../import/DerivedUid.h"
#include "ContourFill.h"
#include "StructureFile.h"

#include <insonate/cases/StructureSet.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace insonate {
namespace fs = std::filesystem;
namespace {

std::string quoted(const DrawnStructure& structure) {
  return "The structure \"" + structure.listed.name + "\"";
}

/// Places structures in one label map and counts what the notes report.
class StructurePlacer {
 public:
  StructurePlacer(const VolumeGeometry& grid, const ContourSpacing& spacing, LabelReadResult& result)
      : grid_(grid), spacing_(spacing), result_(result) {}

  /// `planes` is the grid of the CT, or, for contours that are not parallel to its slices, a grid of their planes.
  void place(const DrawnStructure& structure, const VolumeGeometry& planes, std::uint8_t label) {
    if (structure.listed.type == "EXTERNAL") bodyLabel_ = label;
    const bool isParallel = planes == grid_;
    const double step_mm = planes.spacing_mm.z;
    const ContourSpacing spacing = isParallel ? spacing_ : ContourSpacing{0.5 * step_mm, step_mm};
    FilledStructure filled = fillContours(structure.contours, planes, spacing);
    contoursOutside_ += filled.contoursOutside;
    interpolatedSlices_ += filled.interpolatedSlices;
    interpolatedStructures_ += filled.interpolatedSlices > 0;
    tilted_ += !isParallel;
    if (isParallel)
      paintBlock(filled, label);
    else
      paintFrom(std::move(filled), planes, label);
  }

  void addNotes() {
    if (interpolatedSlices_ > 0)
      result_.notes.push_back("Slices without contours between contoured slices got an interpolated shape: " +
                              std::to_string(interpolatedSlices_) + (interpolatedSlices_ == 1 ? " slice" : " slices") +
                              " of " + std::to_string(interpolatedStructures_) +
                              (interpolatedStructures_ == 1 ? " structure." : " structures."));
    if (tilted_ > 0)
      result_.notes.push_back("The contours of " + std::to_string(tilted_) +
                              (tilted_ == 1 ? " structure" : " structures") +
                              " are not parallel to the slices of the CT. Each voxel took the nearest position in the "
                              "contours' planes, so that borders may have moved by half a voxel.");
    if (overlaps_ > 0)
      result_.notes.push_back(std::to_string(overlaps_) +
                              " voxels belong to several structures; each gets the label of the last one.");
    if (contoursOutside_ > 0)
      result_.notes.push_back(std::to_string(contoursOutside_) +
                              (contoursOutside_ == 1 ? " contour lies" : " contours lie") +
                              " outside the CT and had no effect.");
  }

 private:
  void paint(std::uint8_t& voxel, std::uint8_t label) {
    overlaps_ += voxel != 0 && voxel != label && voxel != bodyLabel_;
    voxel = label;
  }

  void paintBlock(const FilledStructure& filled, std::uint8_t label) {
    const VoxelBox& box = filled.box;
    const std::uint8_t* inside = filled.inside.data();
    for (int k = box.first[2]; k < box.end[2]; ++k)
      for (int j = box.first[1]; j < box.end[1]; ++j)
        for (int i = box.first[0]; i < box.end[0]; ++i)
          if (*inside++) paint(result_.labels.at(i, j, k), label);
  }

  void paintFrom(FilledStructure&& filled, const VolumeGeometry& planes, std::uint8_t label) {
    if (filled.box.empty()) return;
    LabelMap shape;
    shape.geometry = gridOf(planes, filled.box);
    shape.voxels = std::move(filled.inside);
    std::vector<Vec3> corners;
    const Transform patientFromShape = shape.geometry.patientFromIndex();
    for (int corner = 0; corner < 8; ++corner) {
      const auto edge = [&](int axis) {
        return (corner >> axis & 1) != 0 ? shape.geometry.size[std::size_t(axis)] - 1.0 : 0.0;
      };
      corners.push_back(patientFromShape * Vec3{edge(0), edge(1), edge(2)});
    }
    const VoxelBox box = boxAround(grid_, corners, planes.spacing_mm.z);
    Transform shapeFromGrid = shape.geometry.indexFromPatient() * grid_.patientFromIndex();
    shapeFromGrid.offset = shapeFromGrid.offset - Vec3{kOffTheBorder, kOffTheBorder, kOffTheBorder};
    for (int k = box.first[2]; k < box.end[2]; ++k)
      for (int j = box.first[1]; j < box.end[1]; ++j)
        for (int i = box.first[0]; i < box.end[0]; ++i)
          if (sampleNearest(shape, shapeFromGrid * Vec3{double(i), double(j), double(k)}) != 0)
            paint(result_.labels.at(i, j, k), label);
  }

  const VolumeGeometry& grid_;
  ContourSpacing spacing_;
  LabelReadResult& result_;
  std::uint8_t bodyLabel_ = 0;
  int interpolatedSlices_ = 0;
  std::size_t overlaps_ = 0, interpolatedStructures_ = 0, tilted_ = 0, contoursOutside_ = 0;
};

/// The structures to read: those with the wanted numbers; the outline of the body first, below all others.
Result<std::vector<const DrawnStructure*>> chosenOf(const StructureSet& set, const std::vector<std::int32_t>& numbers) {
  std::vector<const DrawnStructure*> chosen;
  for (const DrawnStructure& structure : set.structures)
    if (numbers.empty() || std::ranges::find(numbers, structure.listed.number) != numbers.end())
      chosen.push_back(&structure);
  if (chosen.empty()) return fail("none of the chosen structures is in the file. List its structures.");
  for (const DrawnStructure* structure : chosen)
    if (!structure->damage.empty())
      return fail("the structure \"" + structure->listed.name + "\" " + structure->damage +
                  ". Export the structure set again, or choose other structures.");
  std::stable_partition(chosen.begin(), chosen.end(),
                        [](const DrawnStructure* s) { return s->listed.type == "EXTERNAL"; });
  return chosen;
}

void noteOtherContours(const DrawnStructure& structure, std::vector<std::string>& notes) {
  const std::size_t other = structure.listed.otherContours;
  if (structure.contours.empty())
    notes.push_back(quoted(structure) + " has no closed contours and was left out.");
  else if (other > 0)
    notes.push_back("In the structure \"" + structure.listed.name + "\", " + std::to_string(other) +
                    (other == 1 ? " point or open contour was" : " points or open contours were") + " left out.");
  if (!structure.contours.empty() && structure.withoutArea > 0)
    notes.push_back("In the structure \"" + structure.listed.name + "\", " + std::to_string(structure.withoutArea) +
                    (structure.withoutArea == 1 ? " contour" : " contours") + " of fewer than three points " +
                    (structure.withoutArea == 1 ? "was" : "were") + " left out.");
}

/// The name of an unknown structure is not copied: it may contain patient data.
std::uint8_t labelOfStructure(const DrawnStructure& structure, OwnNumbers& numbers, LabelReadResult& result) {
  const auto known = labelFromAnyName(structure.listed.name);
  const auto label = known ? static_cast<std::uint8_t>(*known) : numbers.take(0);
  if (known)
    result.notes.push_back(quoted(structure) + " is read as " + labelName(label) + " (" + std::to_string(label) + ").");
  else
    result.notes.push_back(unknownStructure(quoted(structure), label));
  if (!known && isOwnLabel(label)) {
    result.own[label] = {"", kSoftTissue};
    result.foreign.insert(label);
  }
  if (structure.color && (known || isOwnLabel(label)) && *structure.color != caseLabelColor({}, label))
    result.colors.try_emplace(label, *structure.color);
  result.structures.push_back({structure.listed.number, structure.listed.name, label});
  return label;
}

void noteOtherSeries(const StructureSet& set, const std::string& source, std::vector<std::string>& notes) {
  const bool knowsItsSeries = source.find("UID was replaced by 2.25.") != std::string::npos;
  const bool isOfThisSeries = std::ranges::any_of(
      set.seriesUids, [&](const std::string& uid) { return source.find(derivedUid(uid)) != std::string::npos; });
  if (knowsItsSeries && !set.seriesUids.empty() && !isOfThisSeries)
    notes.push_back(
        "The structures were drawn on another DICOM series than the one from which this case was imported. Check that "
        "the labels fit the CT.");
}

Result<LabelReadResult> placed(const StructureSet& set, const PatientCase& patient,
                               const std::vector<std::int32_t>& numbers, const Progress& progress) {
  const auto chosen = chosenOf(set, numbers);
  if (!chosen) return tl::unexpected(chosen.error());
  const VolumeGeometry& grid = patient.ct.geometry;
  LabelReadResult result{LabelMap(grid), {}};
  StructurePlacer placer(grid, spacingOfPlanes(set.structures, grid), result);
  OwnNumbers own;
  bool anyContours = false;
  for (std::size_t n = 0; n < chosen->size(); ++n) {
    if (!report(progress, "Placing structures", double(n) / double(chosen->size())))
      return fail(std::string(kCancelled));
    const DrawnStructure& structure = *(*chosen)[n];
    noteOtherContours(structure, result.notes);
    if (structure.contours.empty()) continue;
    anyContours = true;
    const auto planes =
        areParallelToSlices(structure.contours, grid) ? std::optional(grid) : gridOfPlanes(structure.contours, grid);
    if (planes)
      placer.place(structure, *planes, labelOfStructure(structure, own, result));
    else
      result.notes.push_back(quoted(structure) +
                             " was left out: its contours do not lie in parallel planes, or are too large.");
  }
  if (!anyContours) return fail("the chosen structures have no closed contours. Choose structures that have contours.");
  if (std::ranges::none_of(result.labels.voxels, [](std::uint8_t v) { return v != 0; }))
    return fail(
        "no voxel of the CT lies within the contours, so they were drawn on another CT or are too small. Choose the "
        "structure set of this CT.");
  placer.addNotes();
  noteOtherSeries(set, patient.manifest.source, result.notes);
  return result;
}

}  // namespace

Result<LabelReadResult> readStructureSet(const PatientCase& patient, const fs::path& file,
                                         const std::vector<std::int32_t>& numbers, const Progress& progress) {
  const auto set = readStructureFile(file);
  if (!set) return tl::unexpected(set.error());
  auto result = placed(*set, patient, numbers, progress);
  if (!result && result.error().message != kCancelled) return fail(file.string() + ": " + result.error().message);
  return result;
}

}  // namespace insonate
