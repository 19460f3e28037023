#include "Components.h"
#include "Guarded.h"

#include <insonate/segmentation/Guide.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

namespace insonate {
namespace {

constexpr double kBeside_mm = 2;        // a click within this distance of a structure refers to it
constexpr double kMaxOfSurface = 0.02;  // share of the surface that may touch structures that it should not touch
constexpr double kAside_mm = 5;         // clicks nearer to the midline have no side
constexpr double kAround_mm = 25;       // distance from the clicks at which a structure ends that may continue beyond

/// Components of a label in or beside which clicks lie, and the clicks beside all of them, counted from 1.
struct Found {
  Selection pieces;
  std::vector<int> clicksBeside{};
};

Found foundAt(const LabelMap& labels, std::uint8_t label, std::span<const Vec3> clicks_mm) {
  const VoxelBox box = boxAround(labels.geometry, clicks_mm, kAround_mm);
  Found found{voxelsOf(labels, label, box)};
  Selection& chosen = found.pieces;
  const Progress nobody;
  segmentation::Work work(nobody, 1);
  const segmentation::Components pieces(chosen.mask, segmentation::Components::Reach::Volume, work);
  std::vector<bool> reached(pieces.count(), false);
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  for (std::size_t n = 0; n < clicks_mm.size(); ++n) {
    const Vec3& click_mm = clicks_mm[n];
    bool inside = false;
    const VoxelBox near = boxAround(labels.geometry, std::array{click_mm}, kBeside_mm);
    for (int k = near.first[2]; k < near.end[2]; ++k)
      for (int j = near.first[1]; j < near.end[1]; ++j)
        for (int i = near.first[0]; i < near.end[0]; ++i) {
          if (!chosen.isSelected(i, j, k)) continue;
          if (norm(patientFromIndex * Vec3{double(i), double(j), double(k)} - click_mm) > kBeside_mm) continue;
          reached[pieces.componentAt(i - box.first[0], j - box.first[1], k - box.first[2])] = inside = true;
        }
    if (!inside) found.clicksBeside.push_back(int(n) + 1);
  }
  std::ranges::fill(chosen.mask.voxels, std::uint8_t{0});
  pieces.paint(reached, 1, chosen.mask);
  return found;
}

/// Share of the faces of a shape's surface that touch one of the labels.
double shareTouching(const Selection& shape, const LabelMap& labels, std::uint8_t other) {
  std::size_t faces = 0, touching = 0;
  const VoxelBox& box = shape.box;
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i) {
        if (!shape.isSelected(i, j, k)) continue;
        for (int axis = 0; axis < 3; ++axis)
          for (const int step : {-1, 1}) {
            std::array at{i, j, k};
            at[axis] += step;
            if (!labels.geometry.contains(at[0], at[1], at[2]) || shape.isSelected(at[0], at[1], at[2])) continue;
            ++faces, touching += labels.at(at[0], at[1], at[2]) == other;
          }
      }
  return faces > 0 ? double(touching) / double(faces) : 0;
}

/// Position of the patient's midline beside the clicks, to the left in mm: that of the airway, else of the body.
std::optional<double> middle_mm(const LabelMap& labels, std::span<const Vec3> clicks_mm) {
  const VoxelBox near = boxAround(labels.geometry, clicks_mm, kAround_mm);
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  double airway_mm = 0, body_mm = 0;
  std::size_t airway = 0, body = 0;
  for (int k = near.first[2]; k < near.end[2]; ++k)
    for (int j = 0; j < labels.geometry.size[1]; ++j)
      for (int i = 0; i < labels.geometry.size[0]; ++i) {
        const std::uint8_t label = labels.at(i, j, k);
        if (label == kBackground) continue;
        const double left_mm = (patientFromIndex * Vec3{double(i), double(j), double(k)}).x;
        body_mm += left_mm, ++body;
        if (label == kAirway) airway_mm += left_mm, ++airway;
      }
  if (airway > 0) return airway_mm / double(airway);
  return body > 0 ? std::optional(body_mm / double(body)) : std::nullopt;
}

/// The image shows the patient's right on its left, which beginners confuse.
std::optional<std::string> offSide(const GuideStep& step, std::span<const Vec3> clicks_mm, const LabelMap& labels) {
  const auto middle = step.side ? middle_mm(labels, clicks_mm) : std::nullopt;
  if (!middle) return std::nullopt;
  Vec3 sum;
  for (const Vec3& click_mm : clicks_mm) sum = sum + click_mm;
  const double aside_mm = sum.x / double(clicks_mm.size()) - *middle;
  const bool left = aside_mm > 0;
  if (std::abs(aside_mm) < kAside_mm || left == (*step.side == GuideSide::Left)) return std::nullopt;
  return left ? "The clicks lie on the patient's left; this step is for the right, which slices show on their left."
              : "The clicks lie on the patient's right; this step is for the left, which slices show on their right.";
}

double length_mm(std::span<const Vec3> line) {
  double sum = 0;
  for (std::size_t n = 1; n < line.size(); ++n) sum += norm(line[n] - line[n - 1]);
  return sum;
}

/// An example of a click that the result does not contain, with its place as the status line shows it.
GuideFinding clickBeside(const GuideStep& step, const std::vector<int>& beside, std::span<const Vec3> clicks_mm) {
  const Vec3 p = clicks_mm[std::size_t(beside.front() - 1)];
  std::array<char, 96> place;
  std::snprintf(place.data(), place.size(), "(%.1f, %.1f, %.1f) mm", p.x, p.y, p.z);
  const std::string others = beside.size() == 1   ? " lies"
                             : beside.size() == 2 ? " and 1 other lie"
                                                  : " and " + std::to_string(beside.size() - 1) + " others lie";
  const bool isVessel = step.label == kVein || step.label == kArtery;
  return {"Click " + std::to_string(beside.front()) + " at " + place.data() + others + " outside the result." +
              (isVessel ? " Move each of these clicks into the vessel and repeat the step, or edit the result; until "
                          "then the step is not done."
                        : ""),
          !isVessel};
}

/// A slice's section of a vessel.
struct VesselSection {
  double width_mm = 0;  ///< diameter of a circle with the section's area
  double level_mm = 0;  ///< patient z of its center, or of the slice's center without a section
};

VesselSection sectionIn(const Selection& vessel, const VolumeGeometry& grid, int slice) {
  Vec3 sum;
  double voxels = 0;
  for (int j = vessel.box.first[1]; j < vessel.box.end[1]; ++j)
    for (int i = vessel.box.first[0]; i < vessel.box.end[0]; ++i)
      if (vessel.isSelected(i, j, slice)) sum = sum + Vec3{double(i), double(j), double(slice)}, ++voxels;
  const Vec3 center = voxels > 0 ? sum / voxels : Vec3{grid.size[0] / 2.0, grid.size[1] / 2.0, double(slice)};
  return {2 * std::sqrt(voxels * grid.spacing_mm.x * grid.spacing_mm.y / std::numbers::pi),
          (grid.patientFromIndex() * center).z};
}

/// Sections of a vessel between its clicks, in every slice; none if the vessel does not run across the slices. Its ends
/// may be cut obliquely, and are left out.
struct VesselSections {
  std::vector<VesselSection> all;
  int reach = 1;  ///< number of slices over which a vessel hardly changes
};

VesselSections sectionsBetween(const Selection& vessel, const VolumeGeometry& grid, std::span<const Vec3> clicks_mm) {
  constexpr double kWithin_mm = 6;
  VesselSections sections;
  const Transform index = grid.indexFromPatient();
  const auto [lowest, highest] = std::ranges::minmax(clicks_mm, {}, [&](const Vec3& p) { return (index * p).z; });
  const double from = (index * lowest).z, to = (index * highest).z;
  if ((to - from) * grid.spacing_mm.z <= 0.7 * norm(highest - lowest)) return sections;
  sections.reach = std::max(1, int(kWithin_mm / grid.spacing_mm.z));
  const int end = std::min(vessel.box.end[2], int(std::lround(to)) + 1) - sections.reach;
  for (int k = std::max(vessel.box.first[2], int(std::lround(from))) + sections.reach; k < end; ++k)
    sections.all.push_back(sectionIn(vessel, grid, k));
  return sections;
}

/// A vessel does not change its width within a few millimeters: other tissue is labeled, or a part is missing.
std::optional<std::string> widthJump(const VesselSections& sections, const VolumeGeometry& grid) {
  constexpr double kRatio = 1.8, kWide_mm = 4;
  std::array<char, 160> text;
  for (std::size_t n = 0; n < sections.all.size(); ++n) {
    const auto& [here_mm, level_mm] = sections.all[n];
    if (here_mm == 0) {
      std::snprintf(text.data(), text.size(), "Nothing is labeled at z = %.0f mm, between your clicks.", level_mm);
      return text.data();
    }
    const std::size_t next = std::min(n + std::size_t(sections.reach), sections.all.size() - 1);
    const double next_mm = sections.all[next].width_mm;
    const double wide_mm = std::max(here_mm, next_mm);
    if (next_mm == 0 || wide_mm < kWide_mm || wide_mm < kRatio * std::min(here_mm, next_mm)) continue;
    std::snprintf(
        text.data(), text.size(),
        "The width changes from %.0f to %.0f mm within %.0f mm, near z = %.0f mm. Check whether other tissue is "
        "labeled there.",
        here_mm, next_mm, sections.reach * grid.spacing_mm.z, level_mm);
    return text.data();
  }
  return std::nullopt;
}

/// The mean width hides a place where the label is much too narrow or too wide. Sections vary more than the mean.
std::optional<std::string> widthOffRange(const VesselSections& sections, const std::optional<GuideRange>& usual) {
  constexpr double kNarrow = 0.7, kWide = 1.15;
  if (!usual || sections.all.empty()) return std::nullopt;
  const auto [narrow, wide] = std::ranges::minmax(sections.all, {}, &VesselSection::width_mm);
  const bool isWide = wide.width_mm > kWide * usual->high;
  if (!isWide && narrow.width_mm >= kNarrow * usual->low) return std::nullopt;
  const VesselSection& worst = isWide ? wide : narrow;
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(),
                "The vessel is only %.0f mm wide at z = %.0f mm; the usual range is %.0f to %.0f mm.", worst.width_mm,
                worst.level_mm, usual->low, usual->high);
  std::string sentence = text.data();
  if (isWide) sentence.erase(sentence.find("only "), std::string("only ").size());
  return sentence;
}

std::string number(double value) {
  std::ostringstream text;
  text.precision(value < 10 ? 2 : 3);
  text << value;
  return text.str();
}

std::optional<std::string> offRange(const std::optional<GuideRange>& usual, double value, const std::string& of,
                                    const std::string& unit) {
  if (!usual || (value >= usual->low && value <= usual->high)) return std::nullopt;
  return "The structure has " + of + " of " + number(value) + " " + unit + "; the usual range is " +
         number(usual->low) + " to " + number(usual->high) + " " + unit + ".";
}

}  // namespace

std::vector<GuideFinding> checkGuideStep(const GuideStep& step, std::span<const Vec3> clicks_mm,
                                         const LabelMap& labels) {
  std::vector<GuideFinding> findings;
  const auto add = [&](std::optional<std::string> text) {
    if (text) findings.push_back({std::move(*text)});
  };
  for (const std::uint8_t label : step.makes)
    if (boundingBoxOf(labels, label).empty())
      add("There is no " + labelName(label) + "; check whether the CT shows this structure.");
  if (clicks_mm.empty() || step.label == 0) return findings;
  add(offSide(step, clicks_mm, labels));
  const Found found = foundAt(labels, step.label, clicks_mm);
  const std::size_t voxels = found.pieces.count();
  if (voxels == 0) {
    findings.push_back({"Nothing is labeled where you clicked.", step.label != kVein && step.label != kArtery});
    return findings;
  }
  if (!found.clicksBeside.empty()) findings.push_back(clickBeside(step, found.clicksBeside, clicks_mm));
  const Vec3& spacing_mm = labels.geometry.spacing_mm;
  const double volume_mm3 = double(voxels) * spacing_mm.x * spacing_mm.y * spacing_mm.z;
  const double along_mm = length_mm(clicks_mm);
  auto width = along_mm > 0 ? offRange(step.diameter_mm, 2 * std::sqrt(volume_mm3 / along_mm / std::numbers::pi),
                                       "a mean diameter", "mm")
                            : std::nullopt;
  if (step.label == kVein || step.label == kArtery) {
    const VesselSections sections = sectionsBetween(found.pieces, labels.geometry, clicks_mm);
    if (!width) width = widthOffRange(sections, step.diameter_mm);
    add(widthJump(sections, labels.geometry));
  }
  add(std::move(width));
  add(offRange(step.volume_ml, volume_mm3 / 1000, "a volume", "ml"));
  for (const std::uint8_t other : step.apart)
    if (const double share = shareTouching(found.pieces, labels, other); share > kMaxOfSurface)
      add(number(100 * share) + " % of its surface touch the " + labelName(other) +
          ". Other tissue should lie between them.");
  return findings;
}

}  // namespace insonate
