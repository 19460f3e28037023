#include <insonate/cases/Import.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <tuple>

namespace insonate {
namespace {

std::string sizeText(const VolumeGeometry& g, bool known) {
  std::array<char, 120> text;
  if (!known) {
    std::snprintf(text.data(), text.size(), "%dx%dx%d voxels", g.size[0], g.size[1], g.size[2]);
    return text.data();
  }
  std::snprintf(text.data(), text.size(), "%dx%dx%d voxels of %.4gx%.4gx%.4g mm", g.size[0], g.size[1], g.size[2],
                g.spacing_mm.x, g.spacing_mm.y, g.spacing_mm.z);
  return text.data();
}

/// Stacks with the same key are shown together: number of slices, modality, series, and whether an import is refused.
/// Single slices of all series are one group.
using GroupKey = std::tuple<int, std::string, std::string, bool>;

GroupKey groupOf(const SeriesInfo& s) {
  const int slices = s.geometry.size[2];
  const std::string series = s.modality.empty() ? s.uid : s.uid.substr(0, s.uid.rfind('#'));
  return {slices, s.modality, slices == 1 ? std::string() : series, s.refusal.empty()};
}

std::string omittedText(const GroupKey& group, std::size_t count) {
  const auto& [slices, modality, uid, importable] = group;
  const std::string what =
      slices == 1 ? " more single slices" : " more stacks of " + std::to_string(slices) + " slices";
  return std::to_string(count) + what + (modality.empty() ? "" : " (" + modality + ")") +
         (uid.empty() ? "" : " of the series " + uid) + (importable ? " are" : ", which cannot be imported, are") +
         " not listed.";
}

}  // namespace

ListingOverview overviewOf(const SeriesListing& listing) {
  constexpr std::size_t kMostOfAGroup = 12, kShownOfALargeGroup = 2;
  std::map<GroupKey, std::vector<std::size_t>> groups;
  for (std::size_t n = 0; n < listing.series.size(); ++n) groups[groupOf(listing.series[n])].push_back(n);
  ListingOverview overview;
  for (const auto& [group, members] : groups) {
    const std::size_t shown = members.size() > kMostOfAGroup ? kShownOfALargeGroup : members.size();
    overview.shown.insert(overview.shown.end(), members.begin(), members.begin() + std::ptrdiff_t(shown));
    if (shown < members.size()) overview.omitted.push_back(omittedText(group, members.size() - shown));
  }
  std::ranges::sort(overview.shown);
  return overview;
}

std::string seriesListText(const SeriesListing& listing) {
  std::string text;
  const ListingOverview overview = overviewOf(listing);
  for (const std::size_t n : overview.shown) {
    const SeriesInfo& s = listing.series[n];
    text += "  " + s.uid + "  " + (s.modality.empty() ? "-" : s.modality) + "  " +
            sizeText(s.geometry, s.geometryKnown) + (s.kernel.empty() ? "" : "  kernel " + s.kernel) +
            (s.date.empty() ? "" : "  " + s.date) + (s.bodyPart.empty() ? "" : "  " + s.bodyPart) +
            (s.description.empty() ? "" : "  \"" + s.description + "\"") + "\n";
    for (const std::string& warning : s.warnings) text += "    note: " + warning + "\n";
    if (!s.refusal.empty()) text += "    cannot be imported: " + s.refusal + "\n";
  }
  for (const std::string& omitted : overview.omitted) text += "  " + omitted + "\n";
  std::map<std::string, std::pair<int, std::string>> reasons;
  for (const SkippedFile& s : listing.skippedFiles) {
    auto& [count, example] = reasons[s.reason];
    if (count++ == 0) example = s.file.filename().string();
  }
  for (const auto& [reason, files] : reasons)
    text += "  set aside: " +
            (files.first == 1 ? files.second : std::to_string(files.first) + " files, e.g. " + files.second) + ": " +
            reason + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace insonate
