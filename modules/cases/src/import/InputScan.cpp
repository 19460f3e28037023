#include "InputScan.h"

#include "../files/SlicerSegmentation.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace insonate {
namespace fs = std::filesystem;
namespace {

/// Reason why the system refuses to open a file or folder; empty if it does not.
std::string whyClosed(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return std::strerror(errno);
  ::close(file);
  return {};
}

void addUnreadable(const fs::path& path, const std::string& why, InputScan& scan) {
  scan.unreadable.push_back({path, "cannot be read (" + why + "); slices may be missing"});
  scan.skippedFiles.push_back(scan.unreadable.back());
}

/// Files below a folder that can be opened; the others are noted.
Result<std::vector<fs::path>> filesOf(const fs::path& input, InputScan& scan) {
  std::error_code error;
  const fs::file_status status = fs::status(input, error);
  if (!fs::exists(status)) return fail("There is no file or folder " + input.string() + ".");
  if (fs::is_regular_file(status)) {
    if (const std::string why = whyClosed(input); !why.empty())
      return fail("Could not read " + input.string() + ": " + why + ".");
    return std::vector{input};
  }
  if (!fs::is_directory(status)) return fail(input.string() + " is neither a file nor a folder.");
  std::vector<fs::path> files;
  fs::recursive_directory_iterator entry(input, fs::directory_options::skip_permission_denied, error);
  if (error) return fail("Could not read the folder " + input.string() + ": " + error.message() + ".");
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (error) return fail("Could not read the folder " + input.string() + ": " + error.message() + ".");
    std::error_code ignored;
    const bool file = entry->is_regular_file(ignored);
    const bool lost = entry->is_symlink(ignored) && !entry->exists(ignored);
    if (!file && !lost && !entry->is_directory(ignored)) continue;
    if (const std::string why = whyClosed(entry->path()); !why.empty())
      addUnreadable(entry->path(), why, scan);
    else if (file)
      files.push_back(entry->path());
  }
  if (files.empty() && scan.unreadable.empty())
    return fail("The folder " + input.string() + " holds no files. Name the folder with the slices.");
  std::ranges::sort(files);
  return files;
}

/// Slices of a volume file whose third axis is not at a right angle to the others.
SliceStack stackOf(const VolumeHeader& raw) {
  const Mat3& step = raw.patientFromIndex.linear;
  SliceStack stack{
      raw.size[0], raw.size[1], {norm(step.column[0]), norm(step.column[1])}, {step.column[0], step.column[1]}, {}, 0};
  for (int k = 0; k < raw.size[2]; ++k) stack.positions_mm.push_back(raw.patientFromIndex * Vec3{0, 0, double(k)});
  return stack;
}

std::string whyNoCt(const VolumeHeader& raw) {
  if (isSlicerSegmentation(raw.metadata)) return "It is a segmentation, not a CT.";
  if (raw.components != 1) return "It has " + std::to_string(raw.components) + " values per voxel, e.g. color.";
  if (raw.eightBit) return "Its values have 8 bits, too few for Hounsfield units; it is a mask or an image.";
  return {};
}

void planVolume(const VolumeHeader& raw, FoundSeries& found, VolumeSeries& volume) {
  SeriesInfo& info = found.info;
  if (!raw.oriented)
    info.warnings.push_back(
        "The file does not state its orientation; its axes are assumed to be left, posterior, superior.");
  if (raw.size[2] == 1) info.warnings.push_back("There is only one slice.");
  info.refusal = whyNoCt(raw);
  if (auto ok = checkVoxelSize(spacingOf(raw)); !ok && info.refusal.empty()) info.refusal = ok.error().message;
  if (const auto geometry = orthogonalGeometry(raw)) {
    info.geometry = *geometry;
    return;
  }
  info.geometry.size = raw.size;
  const Mat3& step = raw.patientFromIndex.linear;
  for (int a = 0; a < 3; ++a)
    if (!(norm(step.column[a]) > 0)) info.refusal = "Its voxels have no size along one axis.";
  info.geometryKnown = info.refusal.empty();
  if (!info.refusal.empty()) return;
  volume.stack = stackOf(raw);
  volume.plan = planStack(*volume.stack);
  info.geometry = volume.plan.grid;
  info.refusal = volume.plan.refusal;
  info.warnings.insert(info.warnings.end(), volume.plan.warnings.begin(), volume.plan.warnings.end());
}

void addVolume(const fs::path& file, const fs::path& input, InputScan& scan) {
  const auto raw = readVolumeHeader(file);
  if (!raw) {
    scan.skippedFiles.push_back({file, raw.error().message});
    return;
  }
  FoundSeries found;
  found.info.uid = file == input ? file.filename().string() : file.lexically_relative(input).generic_string();
  VolumeSeries volume{file, {}, {}};
  planVolume(*raw, found, volume);
  found.data = std::move(volume);
  scan.series.push_back(std::move(found));
}

/// A text that all slices share; empty if they differ.
std::string sharedText(const DicomSeries& series, std::string DicomSlice::*text) {
  const std::string& first = series.slices.front().*text;
  const bool same = std::ranges::all_of(series.slices, [&](const DicomSlice& s) { return s.*text == first; });
  return same ? first : std::string{};
}

void addDicom(const std::vector<DicomSlice>& slices, InputScan& scan) {
  for (DicomSeries& series : groupSlices(slices)) {
    const bool known = series.refusal.empty() || !series.plan.order.empty();
    FoundSeries found{{series.uid, series.modality, sharedText(series, &DicomSlice::kernel), series.plan.grid, known,
                       series.warnings, series.refusal, sharedText(series, &DicomSlice::description),
                       sharedText(series, &DicomSlice::date), sharedText(series, &DicomSlice::bodyPart)},
                      {}};
    if (!scan.unreadable.empty())
      found.info.warnings.push_back(std::to_string(scan.unreadable.size()) +
                                    (scan.unreadable.size() == 1 ? " file or folder" : " files or folders") +
                                    " could not be opened; slices may be missing.");
    found.data = std::move(series);
    scan.series.push_back(std::move(found));
  }
}

}  // namespace

std::string unreadableText(const std::vector<SkippedFile>& unreadable) {
  const SkippedFile& first = unreadable.front();
  const std::size_t others = unreadable.size() - 1;
  std::string text = first.file.string() + " " + first.reason.substr(0, first.reason.rfind(';'));
  if (others > 0) text += others == 1 ? ", and so is another" : ", and so are " + std::to_string(others) + " more";
  return text;
}

namespace {

bool sameSlice(const DicomSlice& a, const DicomSlice& b) {
  if (a.position_mm && b.position_mm) return norm(*a.position_mm - *b.position_mm) < 1e-3;
  return a.sopUid == b.sopUid;
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// A selected slice represents its series: the other files of the series beside it are added, except copies of the
/// slice.
Result<void> addSeriesOf(const DicomSlice& chosen, InputScan& scan, std::vector<DicomSlice>& slices,
                         const Progress& progress) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folderOf(chosen.file), error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (std::error_code ignored;
        entry->is_regular_file(ignored) && !fs::equivalent(entry->path(), chosen.file, ignored))
      files.push_back(entry->path());
  std::ranges::sort(files);
  for (std::size_t n = 0; n < files.size(); ++n) {
    if (!report(progress, "Finding the series", static_cast<double>(n) / static_cast<double>(files.size())))
      return fail(std::string(kCancelled));
    if (isVolumeFile(files[n])) continue;
    if (const std::string why = whyClosed(files[n]); !why.empty()) {
      addUnreadable(files[n], why, scan);
      continue;
    }
    for (DicomSlice& slice : scanDicom(files[n]).slices)
      if (slice.seriesUid == chosen.seriesUid && !sameSlice(slice, chosen)) slices.push_back(std::move(slice));
  }
  return {};
}

}  // namespace

Result<InputScan> scanInput(const fs::path& input, const Progress& progress) {
  InputScan scan;
  const auto files = filesOf(input, scan);
  if (!files) return tl::unexpected(files.error());
  std::vector<DicomSlice> slices;
  for (std::size_t n = 0; n < files->size(); ++n) {
    if (!report(progress, "Reading the files", static_cast<double>(n) / static_cast<double>(files->size())))
      return fail(std::string(kCancelled));
    const fs::path& file = (*files)[n];
    if (isVolumeFile(file)) {
      addVolume(file, input, scan);
      continue;
    }
    DicomScan dicom = scanDicom(file);
    if (dicom.isDirectory && file == input) return scanInput(folderOf(input), progress);
    if (!dicom.skippedFiles.empty()) scan.skippedFiles.push_back({file, dicom.skippedFiles});
    std::ranges::move(dicom.slices, std::back_inserter(slices));
  }
  std::error_code error;
  if (slices.size() == 1 && fs::is_regular_file(input, error))
    if (auto ok = addSeriesOf(DicomSlice(slices.front()), scan, slices, progress); !ok)
      return tl::unexpected(ok.error());
  addDicom(slices, scan);
  return scan;
}

}  // namespace insonate
