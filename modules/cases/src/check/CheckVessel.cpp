#include "Checks.h"
#include "Flood.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>

namespace insonate::check {
namespace {

/// Share of a label's voxels that belong to a 2x2 block of the label in the plane perpendicular to the vessel's main
/// direction.
double solidShare(const LabelMap& labels, std::uint8_t label) {
  const VolumeGeometry& g = labels.geometry;
  const int along = headFootAxis(g), u = (along + 1) % 3, v = (along + 2) % 3;
  std::vector<std::uint8_t> solid(labels.voxels.size(), 0);
  std::size_t total = 0, inBlocks = 0;
  std::array<int, 3> p;
  for (p[2] = 0; p[2] < g.size[2]; ++p[2])
    for (p[1] = 0; p[1] < g.size[1]; ++p[1])
      for (p[0] = 0; p[0] < g.size[0]; ++p[0]) {
        if (labels.at(p[0], p[1], p[2]) != label) continue;
        ++total;
        std::array<std::size_t, 4> block{};
        bool whole = true;
        for (int corner = 0; corner < 4 && whole; ++corner) {
          std::array<int, 3> q = p;
          q[u] += corner & 1;
          q[v] += corner >> 1;
          whole = g.contains(q[0], q[1], q[2]) && labels.at(q[0], q[1], q[2]) == label;
          if (whole) block[corner] = g.offset(q[0], q[1], q[2]);
        }
        if (!whole) continue;
        for (std::size_t n : block) {
          inBlocks += !solid[n];
          solid[n] = 1;
        }
      }
  return total ? static_cast<double>(inBlocks) / static_cast<double>(total) : 1;
}

/// Tells whether one part ends shortly before the other begins, nearly in line with it.
bool isGap(const Part& lower, const Part& upper) {
  constexpr double kLongest_mm = 20;
  return upper.low > lower.high && norm(upper.lowEnd_mm - lower.highEnd_mm) < kLongest_mm;
}

/// Each gap is a finding, unless there are so many that the label is a set of pieces rather than a vessel with gaps.
void checkGaps(const std::vector<Part>& parts, std::uint8_t label, Findings& findings) {
  constexpr std::size_t kMost = 5;
  const std::string name = labelName(label);
  std::vector<Finding> gaps;
  for (const Part& lower : parts)
    for (const Part& upper : parts)
      if (isGap(lower, upper))
        gaps.push_back({FindingSeverity::kWarning, name + "_broken",
                        "The " + name + " ends at " + placeText(lower.highEnd_mm) + " and goes on at " +
                            placeText(upper.lowEnd_mm) + ". Join the pieces; otherwise the vessel ends in the image.",
                        lower.highEnd_mm, label});
  if (gaps.size() > kMost)
    gaps = {{FindingSeverity::kWarning, name + "_broken",
             "The " + name + " is in " + std::to_string(parts.size()) + " pieces that end near each other, first at " +
                 placeText(*gaps.front().place_mm) +
                 ". Join the pieces that are part of the vessel and remove the others with Islands in Prepare; "
                 "otherwise the vessel ends in the image.",
             gaps.front().place_mm, label}};
  findings.insert(findings.end(), gaps.begin(), gaps.end());
}

/// The probe follows a vessel to be punctured in both directions.
void checkPieceOf(const CaseView& patient, const Target& target, Findings& findings) {
  constexpr double kLeast_mm = 20;
  const VolumeGeometry& g = patient.labels.geometry;
  if (sampleNearest(patient.labels, g.indexFromPatient() * target.position_mm) != target.label) return;
  const double long_mm = pieceLength_mm(patient.labels, g.indexFromPatient() * target.position_mm);
  if (long_mm >= kLeast_mm) return;
  findings.push_back({FindingSeverity::kWarning, labelName(target.label) + "_short",
                      "The piece of " + labelName(target.label) + " that holds the target \"" + target.name +
                          "\" is only " + std::to_string(std::lround(long_mm)) +
                          " mm long; it cannot be followed with the probe. Join it to the rest of the vessel.",
                      target.position_mm, target.label});
}

}  // namespace

void checkWall(const CaseView& patient, Findings& findings) {
  constexpr std::size_t kFew = 10;
  const LabelMap& labels = patient.labels;
  const VolumeGeometry& g = labels.geometry;
  std::size_t faces = 0, first = 0;
  const std::array<std::size_t, 3> step{1, std::size_t(g.size[0]), std::size_t(g.size[0]) * std::size_t(g.size[1])};
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const std::size_t v = g.offset(i, j, k);
        const std::uint8_t label = labels.voxels[v];
        if (label != kVein && label != kArtery) continue;
        const std::uint8_t other = label == kVein ? kArtery : kVein;
        const std::array<bool, 3> more{i + 1 < g.size[0], j + 1 < g.size[1], k + 1 < g.size[2]};
        for (std::size_t a = 0; a < 3; ++a)
          if (more[a] && labels.voxels[v + step[a]] == other && faces++ == 0) first = v;
      }
  if (faces < kFew) return;
  findings.push_back({FindingSeverity::kWarning, "no_wall",
                      "Vein and artery touch over " + std::to_string(faces) + " faces of voxels, first at " +
                          placeText(placeOf(g, first)) +
                          ": the needle cannot meet a wall between them, and the image cannot show one. Leave a voxel "
                          "of soft tissue between them.",
                      placeOf(g, first), kVein});
}

void checkVessel(const CaseView& patient, std::uint8_t label, Findings& findings) {
  constexpr double kCrumb_mm3 = 30;  // less than 5 mm of a vessel 3 mm wide
  const std::string name = labelName(label);
  const int axis = headFootAxis(patient.labels.geometry);
  std::vector<Part> parts = partsOf(patient.labels, label, axis);
  const auto isCrumb = [&](const Part& p) {
    return static_cast<double>(p.voxels) * voxelVolume_mm3(patient.labels.geometry) < kCrumb_mm3;
  };
  // Parts come largest first.
  const auto crumb = std::ranges::find_if(parts, isCrumb);
  const std::size_t crumbs = static_cast<std::size_t>(parts.end() - crumb);
  const Vec3 firstCrumb_mm = crumbs > 0 ? crumb->lowEnd_mm : Vec3{};
  parts.erase(crumb, parts.end());
  checkGaps(parts, label, findings);
  if (crumbs > 0)
    findings.push_back(
        {FindingSeverity::kWarning, name + "_fragments",
         "The " + name + " has " + std::to_string(crumbs) +
             (crumbs == 1 ? " small island apart from the vessels. Erase it, since a needle could puncture it."
                          : " small islands apart from the vessels. Erase them, since a needle could "
                            "puncture them."),
         firstCrumb_mm, label});
  const double solid = solidShare(patient.labels, label);
  if (solid < 0.5)
    findings.push_back(
        {FindingSeverity::kWarning,
         name + "_thin",
         "Most of the " + name +
             " is only one voxel thick, so it has no lumen that can be shown or punctured. Label it on a finer grid.",
         {},
         label});
  for (const Target& target : patient.manifest.targets)
    if (target.label == label) checkPieceOf(patient, target, findings);
}

}  // namespace insonate::check
