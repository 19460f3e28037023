#include "StructureSet.h"

#include "../import/DerivedUid.h"
#include "ContourFill.h"
#include "StructureFile.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace insonate {
namespace fs = std::filesystem;
namespace {

std::string quoted(const DrawnStructure& structure) {
  return "The structure \"" + structure.name + "\"";
}

/// Places the voxels of structures, and counts what the notes report.
class StructurePlacer {
 public:
  StructurePlacer(const VolumeGeometry& grid, const ContourSpacing& spacing, PartComposer& composer)
      : grid_(grid), spacing_(spacing), composer_(composer) {}

  /// `planes` is the grid of the CT, or, for contours that are not parallel to its slices, a grid of their planes.
  Result<void> place(const DrawnStructure& structure, const VolumeGeometry& planes, std::uint16_t number,
                     const Progress& progress) {
    const bool isParallel = planes == grid_;
    const double step_mm = planes.spacing_mm.z;
    const ContourSpacing spacing = isParallel ? spacing_ : ContourSpacing{0.5 * step_mm, step_mm};
    FilledStructure filled = fillContours(structure.contours, planes, spacing);
    contoursOutside_ += filled.contoursOutside;
    interpolatedSlices_ += filled.interpolatedSlices;
    interpolatedStructures_ += filled.interpolatedSlices > 0;
    tilted_ += !isParallel;
    if (filled.box.empty()) return {};
    if (isParallel) {
      composer_.place(filled.box, filled.inside, number);
    } else {
      Volume<std::uint8_t> shape;
      shape.geometry = gridOf(planes, filled.box);
      shape.voxels = std::move(filled.inside);
      if (auto ok = composer_.place(shape, number, progress); !ok) return ok;
    }
    anyVoxels_ = anyVoxels_ || composer_.part(number).voxels > 0;
    return {};
  }

  bool hasVoxels() const { return anyVoxels_; }

  void addNotes(LabelAssembly& assembly) const {
    if (interpolatedSlices_ > 0)
      assembly.addNote("Slices without contours between contoured slices got an interpolated shape: " +
                       std::to_string(interpolatedSlices_) + (interpolatedSlices_ == 1 ? " slice" : " slices") +
                       " of " + std::to_string(interpolatedStructures_) +
                       (interpolatedStructures_ == 1 ? " structure." : " structures."));
    if (tilted_ > 0)
      assembly.addNote("The contours of " + std::to_string(tilted_) + (tilted_ == 1 ? " structure" : " structures") +
                       " are not parallel to the slices of the CT.");
    if (contoursOutside_ > 0)
      assembly.addNote(std::to_string(contoursOutside_) + (contoursOutside_ == 1 ? " contour lies" : " contours lie") +
                       " outside the CT and had no effect.");
  }

 private:
  const VolumeGeometry& grid_;
  ContourSpacing spacing_;
  PartComposer& composer_;
  int interpolatedSlices_ = 0;
  std::size_t interpolatedStructures_ = 0, tilted_ = 0, contoursOutside_ = 0;
  bool anyVoxels_ = false;
};

std::string countOf(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// "organ, drawn by hand, 34 contours"
std::string descriptionOf(const DrawnStructure& structure) {
  const bool isAbbreviation = structure.type.size() <= 3;  // PTV, CTV, GTV
  std::string type = structure.type;
  std::ranges::transform(type, type.begin(), [isAbbreviation](unsigned char c) {
    return c == '_' ? ' ' : isAbbreviation ? char(c) : char(std::tolower(c));
  });
  std::string text = type.empty() ? "" : type + ", ";
  if (structure.algorithm == "MANUAL") text += "drawn by hand, ";
  if (structure.algorithm == "AUTOMATIC") text += "segmented automatically, ";
  if (structure.algorithm == "SEMIAUTOMATIC") text += "segmented semi-automatically, ";
  return text + countOf(structure.contours.size(), "contour", "contours");
}

void noteOtherContours(const DrawnStructure& structure, LabelAssembly& assembly) {
  const std::size_t other = structure.otherContours;
  if (structure.contours.empty())
    assembly.addNote(quoted(structure) + " has no closed contours and was left out.");
  else if (other > 0)
    assembly.addNote("In the structure \"" + structure.name + "\", " + std::to_string(other) +
                     (other == 1 ? " point or open contour was" : " points or open contours were") + " left out.");
  if (!structure.contours.empty() && structure.withoutArea > 0)
    assembly.addNote("In the structure \"" + structure.name + "\", " + std::to_string(structure.withoutArea) +
                     (structure.withoutArea == 1 ? " contour" : " contours") + " of fewer than three points " +
                     (structure.withoutArea == 1 ? "was" : "were") + " left out.");
}

void noteOtherSeries(const StructureSet& set, const std::string& source, LabelAssembly& assembly) {
  const bool knowsItsSeries = source.find("UID was replaced by 2.25.") != std::string::npos;
  const bool isOfThisSeries = std::ranges::any_of(
      set.seriesUids, [&](const std::string& uid) { return source.find(derivedUid(uid)) != std::string::npos; });
  if (knowsItsSeries && !set.seriesUids.empty() && !isOfThisSeries)
    assembly.addNote(
        "The structures were drawn on another DICOM series than the one from which this case was imported. Check that "
        "the labels fit the CT.");
}

/// By the RT ROI Interpreted Type (PS3.3 C.8.8.8), in which an empty type says nothing.
StructureRole roleOf(const DrawnStructure& structure) {
  static const std::set<std::string> kAnatomy{"", "ORGAN", "CAVITY", "ORGAN_AT_RISK", "NONE"};
  if (structure.type == "EXTERNAL") return StructureRole::kOutline;
  return kAnatomy.contains(structure.type) ? StructureRole::kOrgan : StructureRole::kPlan;
}

/// Adds one structure. Returns false for a structure whose contours cannot be filled.
Result<bool> addStructure(const DrawnStructure& structure, const VolumeGeometry& grid, StructurePlacer& placer,
                          LabelAssembly& assembly, const Progress& progress) {
  const NumberName described{structure.name, {}, structure.color, descriptionOf(structure)};
  const bool isParallel = areParallelToSlices(structure.contours, grid), isDamaged = !structure.damage.empty();
  const auto planes = isParallel ? std::optional(grid) : gridOfPlanes(structure.contours, grid);
  if (!isDamaged && (structure.contours.empty() || !planes)) {
    if (!structure.contours.empty())
      assembly.addNote(quoted(structure) +
                       " was left out: its contours do not lie in parallel planes, or are too large.");
    if (auto number = assembly.addEmpty(structure.number, described); !number) return tl::unexpected(number.error());
    return false;
  }
  const auto number = assembly.add(structure.number, described, "The structure", roleOf(structure));
  if (!number) return tl::unexpected(number.error());
  if (!assembly.isRead(*number)) return true;
  if (isDamaged)
    return fail("the structure \"" + structure.name + "\" " + structure.damage +
                ". Export the structure set again, or choose other structures.");
  if (auto ok = placer.place(structure, *planes, *number, progress); !ok) return tl::unexpected(ok.error());
  return true;
}

Result<void> addAll(const StructureSet& set, const PatientCase& patient, LabelAssembly& assembly,
                    const Progress& progress) {
  const VolumeGeometry& grid = patient.ct.geometry;
  StructurePlacer placer(grid, spacingOfPlanes(set.structures, grid), assembly.composer());
  bool isAnyFilled = false, isAnyRead = false;
  for (std::size_t n = 0; n < set.structures.size(); ++n) {
    if (!report(progress, "Placing structures", double(n) / double(set.structures.size())))
      return fail(std::string(kCancelled));
    const DrawnStructure& structure = set.structures[n];
    noteOtherContours(structure, assembly);
    const auto isFilled = addStructure(structure, grid, placer, assembly, progress);
    if (!isFilled) return tl::unexpected(isFilled.error());
    isAnyFilled = isAnyFilled || *isFilled;
    isAnyRead = isAnyRead || (*isFilled && assembly.isRead(static_cast<std::uint16_t>(assembly.composer().size())));
  }
  if (!isAnyFilled)
    return fail("the structures have no closed contours. Choose a file whose structures have contours.");
  if (isAnyRead && !placer.hasVoxels())
    return fail(
        "no voxel of the CT lies within the contours, so they were drawn on another CT or are too small. Choose the "
        "structure set of this CT.");
  placer.addNotes(assembly);
  noteOtherSeries(set, patient.manifest.source, assembly);
  return {};
}

}  // namespace

Result<void> addStructureSet(const PatientCase& patient, const fs::path& file, LabelAssembly& assembly,
                             const Progress& progress) {
  const auto set = readStructureFile(file);
  if (!set) return tl::unexpected(set.error());
  auto done = addAll(*set, patient, assembly, progress);
  if (!done && done.error().message != kCancelled) return fail(file.string() + ": " + done.error().message);
  return done;
}

}  // namespace insonate
