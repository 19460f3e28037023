#include "SeriesGroups.h"

#include "FrameRuns.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace insonate {
namespace {

using Slices = std::vector<DicomSlice>;

/// Rounding noise is below this limit; gantry positions of one scan that differ by more are separate stacks.
constexpr double kSameOrientation = 0.0087;  // half a degree, as a chord of the unit circle

bool placed(const DicomSlice& s) {
  return s.position_mm && s.orientation && s.pixelSpacing_mm;
}

bool sameKind(const DicomSlice& a, const DicomSlice& b) {
  if (a.modality != b.modality || a.studyUid != b.studyUid) return false;
  if (a.columns != b.columns || a.rows != b.rows || placed(a) != placed(b)) return false;
  if (!placed(a)) return true;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs((*a.pixelSpacing_mm)[axis] - (*b.pixelSpacing_mm)[axis]) > 1e-3 * (*a.pixelSpacing_mm)[axis])
      return false;
    if (norm((*a.orientation)[axis] - (*b.orientation)[axis]) > kSameOrientation) return false;
  }
  return true;
}

std::vector<Slices> splitByKind(const Slices& slices) {
  std::vector<Slices> parts;
  for (const DicomSlice& s : slices) {
    const auto home = std::ranges::find_if(parts, [&](const Slices& part) { return sameKind(part.front(), s); });
    if (home == parts.end())
      parts.push_back({s});
    else
      home->push_back(s);
  }
  return parts;
}

/// Groups of slices at the same place, in the order of the first slice of each.
std::vector<Slices> byPlace(const Slices& slices) {
  if (slices.empty()) return {};
  const Vec3 normal = cross((*slices[0].orientation)[0], (*slices[0].orientation)[1]);
  Slices sorted = slices;
  std::ranges::stable_sort(sorted, {}, [&](const DicomSlice& s) { return dot(*s.position_mm, normal); });
  std::vector<Slices> places;
  for (const DicomSlice& s : sorted) {
    const bool same =
        !places.empty() && std::abs(dot(*s.position_mm - *places.back().front().position_mm, normal)) < kSamePlace_mm;
    if (!same) places.emplace_back();
    places.back().push_back(s);
  }
  return places;
}

bool hasDuplicates(const Slices& slices) {
  return byPlace(slices).size() != slices.size();
}

Slices withoutCopies(const Slices& slices, std::vector<std::string>& warnings) {
  // Some writers give all slices the same UID: a copy has the same place, too.
  std::set<std::tuple<std::string, double, double, double>> seen;
  Slices unique;
  for (const DicomSlice& s : slices) {
    const auto [x, y, z] = *s.position_mm;
    if (s.sopUid.empty() || seen.emplace(s.sopUid, x, y, z).second) unique.push_back(s);
  }
  const std::size_t copies = slices.size() - unique.size();
  if (copies > 0)
    warnings.push_back(std::to_string(copies) + (copies == 1 ? " slice is" : " slices are") +
                       " in the folder twice (same SOP Instance UID); the copies were ignored.");
  return unique;
}

/// Separates by acquisition if this explains duplicates or uneven spacing; empty if it does not.
std::vector<Slices> splitByAcquisition(const Slices& slices) {
  std::vector<Slices> parts = groupedBy(slices, [](const DicomSlice& s) { return s.acquisition.value_or(0); });
  const bool explained = std::ranges::all_of(parts, [](const Slices& part) {
    return part.size() > 1 && !hasDuplicates(part) && isRegular(stackOfSlices(part));
  });
  return explained && parts.size() > 1 ? parts : std::vector<Slices>{};
}

std::vector<Slices> splitByKernel(const Slices& slices) {
  return groupedBy(slices, [](const DicomSlice& s) { return s.kernel; });
}

/// Phases of one scan under one UID: every place occurs equally often; the n-th by instance number is phase n. If
/// numbers occur twice, slices of different phases could be mixed.
std::vector<Slices> splitByPhase(const Slices& slices) {
  std::vector<Slices> places = byPlace(slices);
  const std::size_t phases = places.front().size();
  std::vector<Slices> parts(phases);
  for (Slices& place : places) {
    const auto number = [](const DicomSlice& s) { return s.instance.value_or(0); };
    std::ranges::stable_sort(place, {}, number);
    if (place.size() != phases || std::ranges::adjacent_find(place, {}, number) != place.end()) return {};
    for (std::size_t p = 0; p < phases; ++p) parts[p].push_back(place[p]);
  }
  return parts;
}

struct Part {
  Slices slices;
  std::vector<std::string> warnings;
  std::string refusal;
};

/// Parts of slices that were not copied and whose frames of reference do not separate them.
std::vector<Part> partsOf(const Slices& slices, const std::vector<std::string>& warnings) {
  const bool duplicates = hasDuplicates(slices);
  std::vector<Part> parts;
  if (const auto kernels = splitByKernel(slices); duplicates && kernels.size() > 1) {
    for (const Slices& ofOne : kernels) std::ranges::move(partsOf(ofOne, warnings), std::back_inserter(parts));
    return parts;
  }
  if (!duplicates && isRegular(stackOfSlices(slices))) return {{slices, warnings, {}}};
  std::vector<Slices> split = splitByAcquisition(slices);
  if (split.empty() && duplicates) split = splitByPhase(slices);
  if (split.empty() && duplicates) {
    const std::size_t more = slices.size() - byPlace(slices).size();
    return {{slices, warnings,
             std::to_string(more) + (more == 1 ? " slice is" : " slices are") +
                 " at the same position as another slice, and nothing distinguishes them. Export one series only."}};
  }
  if (split.empty()) return {{slices, warnings, {}}};
  for (Slices& s : split) parts.push_back({std::move(s), warnings, {}});
  return parts;
}

/// Slices of one kind as parts, each with its warnings.
std::vector<Part> partsOfKind(const Slices& kind) {
  if (!placed(kind.front())) return {{kind, {}, {}}};
  std::vector<std::string> warnings;
  const Slices slices = withoutCopies(kind, warnings);
  std::vector<Part> parts;
  for (const Slices& together : splitByFrame(slices)) {
    std::vector<std::string> ofThese = warnings;
    const auto frames = groupedBy(together, [](const DicomSlice& s) { return s.frameOfReferenceUid; }).size();
    if (frames > 1)
      ofThese.push_back("The slices state " + std::to_string(frames) +
                        " different frames of reference, as after the removal of the patient's identity. Their "
                        "positions are evenly spaced, so they were put into one stack.");
    std::ranges::move(partsOf(together, ofThese), std::back_inserter(parts));
  }
  return parts;
}

std::string whyNot(const DicomSlice& s) {
  if (s.modality != "CT")
    return "It is " + (s.modality.empty() ? std::string("of unknown modality") : s.modality) +
           ", not CT; its values are not Hounsfield units.";
  if (s.columns < 1 || s.rows < 1)
    return "Its slices do not state their size (Rows, Columns). Export the original series.";
  if (!s.pixelSpacing_mm)
    return "Its slices have no Pixel Spacing, so nothing in them can be measured. Export the original series.";
  if (!((*s.pixelSpacing_mm)[0] > 0 && (*s.pixelSpacing_mm)[1] > 0)) return "Its Pixel Spacing is not above 0.";
  if (!s.position_mm || !s.orientation)
    return "Its slices do not state their position (Image Position and Orientation). Export the original series.";
  if (s.cutOff)
    return "The slice " + s.file.filename().string() +
           " is cut off: it ends before the end of its image. Copy it again.";
  if (s.slope == 0.0)
    return "Its Rescale Slope is 0, so all voxels would have the same value. Export the original series.";
  if (s.lookupTable)
    return "Its values become Hounsfield units only by a lookup table (Modality LUT), which Insonate cannot read. "
           "Export "
           "it "
           "with Rescale Slope and Intercept.";
  const auto& [i, j] = *s.orientation;
  if (!(std::abs(norm(i) - 1) < 0.01 && std::abs(norm(j) - 1) < 0.01))
    return "The Image Orientation of its slices is not a pair of unit vectors. Export the original series.";
  return {};
}

using Scale = std::pair<double, double>;  // slope, intercept

Scale scaleOf(const DicomSlice& s) {
  return {s.slope.value_or(1), s.intercept.value_or(0)};
}

std::string textOf(Scale scale) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.6g and %.6g", scale.first, scale.second);
  return text.data();
}

/// Names the slices whose scale differs from that of most slices. Some scanners scale each slice by itself.
void warnOfScales(DicomSeries& series) {
  constexpr std::size_t kNamed = 3;
  std::map<Scale, std::size_t> counts;
  for (const DicomSlice& s : series.slices) ++counts[scaleOf(s)];
  if (counts.size() < 2) return;
  const auto usual = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
  const std::size_t others = series.slices.size() - usual->second;
  if (usual->second <= series.slices.size() / 2)
    return series.warnings.push_back("The slices have " + std::to_string(counts.size()) +
                                     " different scales (Rescale Slope and Intercept). Each slice is converted with "
                                     "its own; check that all look alike.");
  std::string named;
  std::size_t count = 0;
  for (const DicomSlice& s : series.slices) {
    if (scaleOf(s) == usual->first || count++ >= kNamed) continue;
    std::array<char, 64> level;
    std::snprintf(level.data(), level.size(), " in the slice at z = %.1f mm", s.position_mm->z);
    named += ", but " + textOf(scaleOf(s)) + level.data() +
             (s.instance ? " (instance " + std::to_string(*s.instance) + ")" : "");
  }
  if (others > kNamed) named += ", and differ in " + std::to_string(others - kNamed) + " more slices";
  series.warnings.push_back("Rescale Slope and Intercept are " + textOf(usual->first) + " in " +
                            std::to_string(usual->second) + " slices" + named +
                            ". Each slice is converted with its own; compare these slices with their neighbors.");
}

bool isScaled(const DicomSlice& s) {
  return s.slope && s.intercept;
}

/// Reason why these slices cannot form one stack; empty if there is none.
std::string whyNotTogether(const Slices& slices) {
  const auto scaled = static_cast<std::size_t>(std::ranges::count_if(slices, isScaled));
  if (scaled == 0 || scaled == slices.size()) return {};
  return std::to_string(slices.size() - scaled) + " of its " + std::to_string(slices.size()) +
         " slices lack Rescale Slope or Intercept, which the other slices have, so their values cannot be compared. "
         "Export the "
         "original series.";
}

/// Distance of a slice's far corner from the position in its own header, if all slices are assumed parallel.
double unparallel_mm(const DicomSeries& series) {
  const SliceStack& stack = series.stack;
  double worst_mm = 0;
  for (const DicomSlice& s : series.slices) {
    const Vec3 i = (*s.orientation)[0] - stack.direction[0], j = (*s.orientation)[1] - stack.direction[1];
    worst_mm = std::max(worst_mm, norm(stack.columns * stack.spacing_mm[0] * i + stack.rows * stack.spacing_mm[1] * j));
  }
  return worst_mm;
}

void addWarnings(DicomSeries& series) {
  const DicomSlice& first = series.slices.front();
  const double spacing_mm = series.plan.grid.spacing_mm.z;
  if (series.slices.size() > 1 && first.thickness_mm && *first.thickness_mm > 0) {
    const double ratio = *first.thickness_mm / spacing_mm;
    if (ratio < 0.67)
      series.warnings.push_back(
          "The slices are much thinner than their distance, so structures between them are not visible.");
    else if (ratio > 2.1)
      series.warnings.push_back(
          "The slices are much thicker than their distance, so fine detail along the stack is blurred.");
  }
  if (const double worst_mm = unparallel_mm(series); worst_mm > 0.5 * series.plan.grid.spacing_mm.x)
    series.warnings.push_back(
        "The slices are not quite parallel, but are treated as parallel. Their corners are up to " +
        std::to_string(static_cast<int>(std::ceil(worst_mm))) + " mm away from the positions in their headers.");
  if (splitByKernel(series.slices).size() > 1)
    series.warnings.push_back(
        "The slices were reconstructed with several kernels, so their sharpness and noise differ.");
  warnOfScales(series);
  if (!std::ranges::all_of(series.slices, isScaled))
    series.warnings.push_back("Slices lack Rescale Slope or Intercept; 1 and 0 are used. Air should be near -1000 HU.");
  if (std::ranges::any_of(series.slices, &DicomSlice::otherUnit))
    series.warnings.push_back(
        "The slices do not call their values Hounsfield units (Rescale Type); check that air is near "
        "-1000 and water near 0.");
  if (std::ranges::any_of(series.slices, &DicomSlice::lossy))
    series.warnings.push_back(
        "The images were compressed with loss: values are not exact. Export the original series if "
        "there is one.");
  if (std::ranges::any_of(series.slices, &DicomSlice::burnedInText))
    series.warnings.push_back("The images may contain burned-in text; check that it does not identify the patient.");
}

DicomSeries finish(Part part, std::string uid) {
  DicomSeries series{std::move(uid), part.slices.front().modality, {}, {}, {}, std::move(part.warnings), {}};
  for (const DicomSlice& s : part.slices)
    if (series.refusal.empty()) series.refusal = whyNot(s);
  if (series.refusal.empty()) series.refusal = part.refusal;
  if (series.refusal.empty()) series.refusal = whyNotTogether(part.slices);
  if (series.refusal.empty()) {
    series.stack = stackOfSlices(part.slices);
    series.plan = planStack(series.stack);
    series.refusal = series.plan.refusal;
    if (auto ok = checkVoxelSize(series.plan.grid.spacing_mm); !ok && series.refusal.empty())
      series.refusal = ok.error().message;
    series.warnings.insert(series.warnings.end(), series.plan.warnings.begin(), series.plan.warnings.end());
  }
  if (!series.refusal.empty()) {
    const DicomSlice& first = part.slices.front();
    series.plan = {};  // only its size can be trusted
    series.plan.grid.size = {std::max(first.columns, 1), std::max(first.rows, 1), static_cast<int>(part.slices.size())};
    series.slices = std::move(part.slices);
    return series;
  }
  for (int n : series.plan.order) series.slices.push_back(part.slices[n]);
  addWarnings(series);
  return series;
}

}  // namespace

std::vector<DicomSeries> groupSlices(const std::vector<DicomSlice>& slices) {
  std::map<std::string, Slices> byUid;
  for (const DicomSlice& s : slices) byUid[s.seriesUid].push_back(s);
  std::vector<DicomSeries> series;
  for (const auto& [uid, all] : byUid) {
    std::vector<Part> parts;
    for (const Slices& kind : splitByKind(all)) std::ranges::move(partsOfKind(kind), std::back_inserter(parts));
    std::ranges::stable_sort(parts, std::greater{}, [](const Part& p) { return p.slices.size(); });
    const std::string name = uid.empty() ? "unnamed" : uid;
    for (std::size_t n = 0; n < parts.size(); ++n) {
      if (parts.size() > 1)
        parts[n].warnings.push_back("One Series Instance UID holds " + std::to_string(parts.size()) +
                                    " different stacks; this is number " + std::to_string(n + 1) + ".");
      series.push_back(finish(std::move(parts[n]), n == 0 ? name : name + "#" + std::to_string(n + 1)));
    }
  }
  return series;
}

}  // namespace insonate
