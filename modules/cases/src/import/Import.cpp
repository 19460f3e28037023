#include "../files/Hounsfield.h"
#include "DerivedUid.h"
#include "DicomPixels.h"
#include "InputScan.h"
#include "ValueShift.h"

#include <insonate/cases/Import.h>

#include <algorithm>
#include <limits>

namespace insonate {
namespace fs = std::filesystem;
namespace {

SeriesListing listingOf(const InputScan& scan) {
  SeriesListing listing;
  for (const FoundSeries& found : scan.series) listing.series.push_back(found.info);
  listing.skippedFiles = scan.skippedFiles;
  return listing;
}

Result<const FoundSeries*> choose(const InputScan& scan, const fs::path& input, const std::string& uid) {
  const std::string list = "\n" + seriesListText(listingOf(scan));
  if (!uid.empty()) {
    const auto found = std::ranges::find_if(scan.series, [&](const FoundSeries& f) { return f.info.uid == uid; });
    if (found == scan.series.end()) return fail(input.string() + " holds no series " + uid + ". It holds:" + list);
    return &*found;
  }
  std::vector<const FoundSeries*> importable;
  for (const FoundSeries& found : scan.series)
    if (found.info.refusal.empty()) importable.push_back(&found);
  if (importable.size() == 1) return importable.front();
  if (importable.size() > 1)
    return fail(input.string() + " holds " + std::to_string(importable.size()) +
                " series; name the one to import. It holds:" + list);
  if (scan.series.size() == 1) return &scan.series.front();
  return fail(input.string() + " holds nothing that can be imported." + (list.size() > 1 ? list : ""));
}

CtVolume assemble(const StackPlan& plan, const SliceStack& stack, std::vector<std::int16_t> slices) {
  if (plan.resample) return resampleStack(plan, stack, slices);
  CtVolume ct;
  ct.geometry = plan.grid;
  ct.voxels = std::move(slices);
  return ct;
}

Result<HounsfieldCt> read(const DicomSeries& series, std::vector<std::string>& notes, const Progress& progress) {
  auto slices = readSlices(series, notes, progress);
  if (!slices) return tl::unexpected(slices.error());
  return HounsfieldCt{assemble(series.plan, series.stack, std::move(slices->hu)), slices->saturated};
}

Result<HounsfieldCt> read(const VolumeSeries& series, const SeriesInfo& info, std::vector<std::string>& notes) {
  const auto header = readVolumeHeader(series.file);
  if (!header) return tl::unexpected(header.error());
  if (!series.stack) return readHounsfield(series.file, *header, info.geometry, notes);
  VolumeGeometry asStored;
  asStored.size = header->size;
  auto stored = readHounsfield(series.file, *header, asStored, notes);
  if (!stored) return stored;
  const std::size_t sliceSize = static_cast<std::size_t>(header->size[0]) * header->size[1];
  std::vector<std::int16_t> ordered;
  ordered.reserve(stored->ct.voxels.size());
  for (const int n : series.plan.order) {
    const auto slice = stored->ct.voxels.begin() + static_cast<std::ptrdiff_t>(n * sliceSize);
    ordered.insert(ordered.end(), slice, slice + static_cast<std::ptrdiff_t>(sliceSize));
  }
  return HounsfieldCt{assemble(series.plan, *series.stack, std::move(ordered)), stored->saturated};
}

/// The header of a label map that was stored in 16 bits resembles that of a CT.
Result<void> checkIsNoLabelMap(const CtVolume& ct) {
  constexpr std::size_t kFewVoxels = 1000, kMaxLabels = 256;
  if (ct.voxels.size() < kFewVoxels) return {};
  std::vector<bool> seen(1 << 16);
  std::size_t different = 0;
  for (const std::int16_t hu : ct.voxels) {
    if (hu < 0) return {};
    if (seen[hu]) continue;
    seen[hu] = true;
    if (++different > kMaxLabels) return {};
  }
  return fail("it holds only " + std::to_string(different) +
              " different values, none below 0: it is a label map or an image, not a CT in Hounsfield units. Import "
              "the CT from which it was made.");
}

void judgeValues(ImportedCt& imported) {
  imported.likelyShift_HU = likelyShift(imported.ct);
  if (imported.likelyShift_HU)
    imported.series.warnings.push_back(
        "Air lies near 0 and soft tissue near 1024: the values look like Hounsfield "
        "units to which 1024 was added when they were stored.");
  else if (hasNothingBelowZero(imported.ct))
    imported.series.warnings.push_back(
        "No value of the CT is below 0: it may not be in Hounsfield units; air should be near -1000.");
}

/// Slices missing at an end of the stack leave no gap; only the damaged files indicate them.
void warnOfDamagedFiles(const InputScan& scan, std::vector<std::string>& warnings) {
  const auto damaged = std::ranges::count_if(
      scan.skippedFiles, [](const SkippedFile& s) { return s.reason.starts_with("DICOM that is"); });
  if (damaged > 0)
    warnings.push_back(std::to_string(damaged) + (damaged == 1 ? " DICOM file" : " DICOM files") +
                       " could not be read; slices at the ends of the volume may be missing.");
}

}  // namespace

std::string saturationText(const ImportedCt& imported) {
  return std::to_string(imported.saturatedVoxels) +
         (imported.saturatedVoxels == 1 ? " voxel exceeds" : " voxels exceed") +
         " 32767 HU with the scale that the file states, so the scale is probably wrong: metal has 3000 to 30000 HU. "
         "An import limits them to 32767 HU.";
}

Result<SeriesListing> listSeries(const fs::path& input, const Progress& progress) {
  const auto scan = scanInput(input, progress);
  if (!scan) return tl::unexpected(scan.error());
  const SeriesListing listing = listingOf(*scan);
  if (listing.series.empty()) return fail(input.string() + " holds no image series.\n" + seriesListText(listing));
  report(progress, "Reading the files", 1);
  return listing;
}

Result<ImportedCt> importSeries(const fs::path& input, const std::string& uid, const Progress& progress) {
  const auto scan = scanInput(input, progress);
  if (!scan) return tl::unexpected(scan.error());
  const auto chosen = choose(*scan, input, uid);
  if (!chosen) return tl::unexpected(chosen.error());
  const FoundSeries& found = **chosen;
  if (!found.info.refusal.empty())
    return fail("The series " + found.info.uid + " cannot be imported: " + found.info.refusal);
  ImportedCt imported{{}, found.info, {}};
  auto& warnings = imported.series.warnings;
  if (uid.empty() && !scan->unreadable.empty())
    return fail(unreadableText(scan->unreadable) +
                ". It may be a slice of the series. Make it readable, or choose the series " + found.info.uid +
                " to import the series without this file.");
  const DicomSeries* dicom = std::get_if<DicomSeries>(&found.data);
  if (dicom) warnOfDamagedFiles(*scan, warnings);
  auto values =
      dicom ? read(*dicom, warnings, progress) : read(std::get<VolumeSeries>(found.data), found.info, warnings);
  if (!values) return tl::unexpected(values.error());
  if (auto ok = dicom ? Result<void>{} : checkIsNoLabelMap(values->ct); !ok)
    return fail("The file " + found.info.uid + " cannot be imported: " + ok.error().message);
  imported.ct = std::move(values->ct);
  imported.saturatedVoxels = values->saturated;
  judgeValues(imported);
  imported.source = dicom ? "Imported from a DICOM CT series of " + std::to_string(dicom->slices.size()) +
                                " slices; its UID was replaced by " + derivedUid(dicom->uid) + "."
                          : "Imported from a volume file.";
  report(progress, "Reading slices", 1);
  return imported;
}

}  // namespace insonate
