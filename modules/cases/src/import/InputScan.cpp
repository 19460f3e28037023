#include "InputScan.h"

#include "../files/SlicerSegmentation.h"

#include <algorithm>

namespace insonate {
namespace fs = std::filesystem;
namespace {

Result<std::vector<fs::path>> filesOf(const fs::path& input) {
  std::error_code error;
  const fs::file_status status = fs::status(input, error);
  if (!fs::exists(status)) return fail("There is no file or folder " + input.string() + ".");
  if (fs::is_regular_file(status)) return std::vector{input};
  if (!fs::is_directory(status)) return fail(input.string() + " is neither a file nor a folder.");
  std::vector<fs::path> files;
  fs::recursive_directory_iterator entry(input, fs::directory_options::skip_permission_denied, error);
  if (error) return fail("Could not look into " + input.string() + ": " + error.message() + ".");
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (error) return fail("Could not look into " + input.string() + ": " + error.message() + ".");
    std::error_code ignored;
    if (entry->is_regular_file(ignored)) files.push_back(entry->path());
  }
  if (files.empty()) return fail("The folder " + input.string() + " holds no files. Name the folder with the slices.");
  std::ranges::sort(files);
  return files;
}

/// The slices of a volume file whose third axis is not at right angles to the others.
SliceStack stackOf(const RawVolume& raw) {
  const Mat3& step = raw.patientFromIndex.linear;
  SliceStack stack{
      raw.size[0], raw.size[1], {norm(step.column[0]), norm(step.column[1])}, {step.column[0], step.column[1]}, {}, 0};
  for (int k = 0; k < raw.size[2]; ++k) stack.positions_mm.push_back(raw.patientFromIndex * Vec3{0, 0, double(k)});
  return stack;
}

std::string whyNoCt(const RawVolume& raw) {
  if (isSlicerSegmentation(raw.metadata)) return "It is a segmentation, not a CT.";
  if (raw.components != 1) return "It has " + std::to_string(raw.components) + " values per voxel, e.g. colour.";
  if (raw.eightBit) return "Its values have 8 bits, too few for Hounsfield units; it is a mask or a picture.";
  return {};
}

void planVolume(const RawVolume& raw, FoundSeries& found, VolumeSeries& volume) {
  SeriesInfo& info = found.info;
  if (!raw.oriented)
    info.warnings.push_back(
        "The file does not say how it lies in the patient; its axes are taken as left, posterior, superior.");
  if (raw.size[2] == 1) info.warnings.push_back("There is only one slice.");
  info.refusal = whyNoCt(raw);
  if (const auto geometry = orthogonalGeometry(raw)) {
    info.geometry = *geometry;
    return;
  }
  info.geometry.size = raw.size;
  const Mat3& step = raw.patientFromIndex.linear;
  for (int a = 0; a < 3; ++a)
    if (!(norm(step.column[a]) > 0)) info.refusal = "Its voxels have no size along one axis.";
  if (!info.refusal.empty()) return;
  volume.stack = stackOf(raw);
  volume.plan = planStack(*volume.stack);
  info.geometry = volume.plan.grid;
  info.refusal = volume.plan.refusal;
  info.warnings.insert(info.warnings.end(), volume.plan.warnings.begin(), volume.plan.warnings.end());
}

void addVolume(const fs::path& file, const fs::path& input, InputScan& scan) {
  const auto raw = readVolumeFile(file, ReadPart::kHeader);
  if (!raw) {
    scan.setAside.push_back({file, raw.error().message});
    return;
  }
  FoundSeries found;
  found.info.uid = file == input ? file.filename().string() : file.lexically_relative(input).generic_string();
  VolumeSeries volume{file, {}, {}};
  planVolume(*raw, found, volume);
  found.data = std::move(volume);
  scan.series.push_back(std::move(found));
}

void addDicom(const std::vector<DicomSlice>& slices, InputScan& scan) {
  for (DicomSeries& series : groupSlices(slices)) {
    FoundSeries found{{series.uid, series.modality, series.plan.grid, series.warnings, series.refusal}, {}};
    found.data = std::move(series);
    scan.series.push_back(std::move(found));
  }
}

}  // namespace

Result<InputScan> scanInput(const fs::path& input, const Progress& progress) {
  const auto files = filesOf(input);
  if (!files) return tl::unexpected(files.error());
  InputScan scan;
  std::vector<DicomSlice> slices;
  for (std::size_t n = 0; n < files->size(); ++n) {
    if (!report(progress, "Looking at files", static_cast<double>(n) / static_cast<double>(files->size())))
      return fail(std::string(kCancelled));
    const fs::path& file = (*files)[n];
    if (isVolumeFile(file)) {
      addVolume(file, input, scan);
      continue;
    }
    DicomScan dicom = scanDicom(file);
    if (!dicom.setAside.empty()) scan.setAside.push_back({file, dicom.setAside});
    std::ranges::move(dicom.slices, std::back_inserter(slices));
  }
  addDicom(slices, scan);
  return scan;
}

}  // namespace insonate
