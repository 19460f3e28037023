#include <insonate/segmentation/SectionOutline.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace insonate {
namespace {

constexpr int kOutlineRays = VesselOutline::kRays;
constexpr double kMinOutline_mm = 0.3, kMaxOutline_mm = 30;
/// Radii that differ less are equal.
constexpr double kEqual_mm = 0.05;

double angleOf(int ray) {
  return 2 * std::numbers::pi * ray / kOutlineRays;
}

Vec3 directionOf(const VesselFrame& frame, int ray) {
  return frame.right * std::cos(angleOf(ray)) + frame.down * std::sin(angleOf(ray));
}

/// Share of a label at a continuous index, 0 to 1: interpolated between voxels, so that an outline has no steps.
double shareAt(const LabelMap& labels, std::uint8_t label, Vec3 index) {
  const double x = std::floor(index.x), y = std::floor(index.y), z = std::floor(index.z);
  double share = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = int(x) + corner % 2, j = int(y) + corner / 2 % 2, k = int(z) + corner / 4;
    if (!labels.geometry.contains(i, j, k) || labels.at(i, j, k) != label) continue;
    share += (1 - std::abs(index.x - i)) * (1 - std::abs(index.y - j)) * (1 - std::abs(index.z - k));
  }
  return share;
}

/// A section of the piece of the vessel that changes.
struct OutlineSection {
  VesselFrame frame;
  VesselOutline before, after;
};

double radiusOnRay(const VesselOutline& outline, double ray) {
  const int low = static_cast<int>(ray) % kOutlineRays;
  const double part = ray - std::floor(ray);
  return outline.radius_mm[std::size_t(low)] * (1 - part) +
         outline.radius_mm[std::size_t((low + 1) % kOutlineRays)] * part;
}

/// The place of a point between two sections.
struct RayPlace {
  double part, ray, radius_mm;
};

std::optional<RayPlace> placeBetween(const VesselFrame& a, const VesselFrame& b, Vec3 at_mm) {
  const double behind = dot(at_mm - a.center_mm, a.along), ahead = dot(at_mm - b.center_mm, b.along);
  if (behind < 0 || ahead >= 0) return std::nullopt;
  const double part = behind / (behind - ahead);
  const Vec3 off = at_mm - (a.center_mm + (b.center_mm - a.center_mm) * part);
  const double x = dot(off, a.right + (b.right - a.right) * part), y = dot(off, a.down + (b.down - a.down) * part);
  const double turns = std::atan2(y, x) / (2 * std::numbers::pi);
  return RayPlace{part, (turns < 0 ? turns + 1 : turns) * kOutlineRays, norm(off)};
}

/// Writes the voxels between the former and the new outlines of neighboring sections.
class OutlineWriter {
 public:
  OutlineWriter(const LabelMap& labels, std::uint8_t label, std::uint8_t rest, std::vector<OutlineSection> sections);
  Proposal write();

 private:
  std::uint8_t wanted(Vec3 at_mm, std::uint8_t now) const;

  const LabelMap& labels_;
  std::uint8_t label_, rest_;
  std::vector<OutlineSection> sections_;
  double largest_mm_ = 0, slack_mm_;
};

OutlineWriter::OutlineWriter(const LabelMap& labels, std::uint8_t label, std::uint8_t rest,
                             std::vector<OutlineSection> sections)
    : labels_(labels), label_(label), rest_(rest), sections_(std::move(sections)) {
  const Vec3& voxel_mm = labels.geometry.spacing_mm;
  // The surface of the voxels lies up to half a voxel's diagonal beside the outline.
  slack_mm_ = 0.5 * norm(voxel_mm);
  for (const OutlineSection& section : sections_)
    for (const VesselOutline* outline : {&section.before, &section.after})
      largest_mm_ = std::max(largest_mm_, std::ranges::max(outline->radius_mm));
  largest_mm_ += slack_mm_;
}

std::uint8_t OutlineWriter::wanted(Vec3 at_mm, std::uint8_t now) const {
  std::optional<RayPlace> best;
  const OutlineSection* from = nullptr;
  for (std::size_t n = 0; n + 1 < sections_.size(); ++n) {
    const auto place = placeBetween(sections_[n].frame, sections_[n + 1].frame, at_mm);
    if (place && place->radius_mm <= largest_mm_ && (!best || place->radius_mm < best->radius_mm))
      best = place, from = &sections_[n];
  }
  if (!best) return Proposal::kKeep;
  const auto radius = [&](VesselOutline OutlineSection::*outline) {
    return radiusOnRay(from[0].*outline, best->ray) * (1 - best->part) +
           radiusOnRay(from[1].*outline, best->ray) * best->part;
  };
  const double before_mm = radius(&OutlineSection::before), after_mm = radius(&OutlineSection::after),
               at = best->radius_mm;
  // A vessel does not grow into another vessel: there is a wall between them.
  const bool isOtherVessel = now != label_ && (now == kVein || now == kArtery);
  if (after_mm > before_mm + kEqual_mm && at <= after_mm && at > before_mm - slack_mm_)
    return now == label_ || isOtherVessel ? Proposal::kKeep : label_;
  if (after_mm < before_mm - kEqual_mm && at > after_mm && at <= before_mm + slack_mm_)
    return now == label_ ? rest_ : Proposal::kKeep;
  return Proposal::kKeep;
}

Proposal OutlineWriter::write() {
  std::vector<Vec3> centers_mm;
  for (const OutlineSection& section : sections_) centers_mm.push_back(section.frame.center_mm);
  Selection everything(labels_.geometry, boxAround(labels_.geometry, centers_mm, largest_mm_));
  Proposal proposal{everything.box, std::move(everything.mask)};
  const VoxelBox& box = proposal.box;
  const Transform patientFromIndex = labels_.geometry.patientFromIndex();
  std::size_t voxel = 0;
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i)
        proposal.labels.voxels[voxel++] =
            wanted(patientFromIndex * Vec3{double(i), double(j), double(k)}, labels_.at(i, j, k));
  return proposal;
}

/// Radii between the new outline of the section and the present outline at the end of the reach. `share` is 1 at the
/// section and 0 at the end. Rays that have moved little are only shifted with their neighbors, so that the changed
/// part of the wall has no edge.
void blendRadii(OutlineSection& section, const OutlineSection& changed, const VesselOutline* end, double share) {
  double most_mm = 0;
  for (std::size_t ray = 0; ray < kOutlineRays; ++ray)
    most_mm = std::max(most_mm, std::abs(changed.after.radius_mm[ray] - changed.before.radius_mm[ray]));
  section.after = section.before;
  if (most_mm < kEqual_mm) return;
  for (std::size_t ray = 0; ray < kOutlineRays; ++ray) {
    const double moved_mm = changed.after.radius_mm[ray] - changed.before.radius_mm[ray];
    if (std::abs(moved_mm) < kEqual_mm) continue;
    const double shifted_mm = section.before.radius_mm[ray] + share * moved_mm;
    const double between_mm =
        end ? share * changed.after.radius_mm[ray] + (1 - share) * end->radius_mm[ray] : shifted_mm;
    const double weight = std::abs(moved_mm) / most_mm;
    section.after.radius_mm[ray] =
        std::clamp(shifted_mm + weight * (between_mm - shifted_mm), kMinOutline_mm, kMaxOutline_mm);
  }
}

Result<void> checkSectionOutline(const SectionOutline& outline) {
  const bool hasLine =
      outline.line_mm.size() >= 2 && outline.section >= 0 && std::size_t(outline.section) < outline.line_mm.size();
  bool isSpread = true;
  for (std::size_t n = 1; n < outline.line_mm.size(); ++n)
    isSpread = isSpread && norm(outline.line_mm[n] - outline.line_mm[n - 1]) > 1e-3;
  if (!hasLine || !isSpread)
    return fail("An outline needs two or more different points of the center line, one of them in the section.");
  if (outline.corners_mm.size() != kOutlineRays)
    return fail("An outline needs " + std::to_string(kOutlineRays) + " corners, not " +
                std::to_string(outline.corners_mm.size()) + ".");
  for (const Vec3& corner_mm : outline.corners_mm)
    if (const double mm = norm(corner_mm - outline.line_mm[std::size_t(outline.section)]);
        !(mm > 1e-3) || mm > kMaxOutline_mm + 1)
      return fail("A corner of an outline is not between 0 and 30 mm from the center line.");
  return {};
}

}  // namespace

VesselOutline outlineOf(const LabelMap& labels, std::uint8_t label, const VesselFrame& frame) {
  VesselOutline outline{frame.center_mm, frame.right, frame.down, {}};
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  const Vec3& voxel_mm = labels.geometry.spacing_mm;
  const double step_mm = 0.5 * std::min({voxel_mm.x, voxel_mm.y, voxel_mm.z});
  for (int ray = 0; ray < kOutlineRays; ++ray) {
    const Vec3 from = indexFromPatient * frame.center_mm;
    const Vec3 way = indexFromPatient * (frame.center_mm + directionOf(frame, ray)) - from;
    double share = shareAt(labels, label, from), at_mm = 0;
    while (share >= 0.5 && at_mm < kMaxOutline_mm) {
      const double next = shareAt(labels, label, from + way * (at_mm + step_mm));
      // The wall is where the share is a half.
      at_mm += next < 0.5 ? step_mm * (share - 0.5) / (share - next) : step_mm;
      share = next;
    }
    outline.radius_mm[std::size_t(ray)] = std::min(at_mm, kMaxOutline_mm);
  }
  return outline;
}

Vec3 cornerOf(const VesselOutline& outline, int ray) {
  return outline.center_mm + (outline.right * std::cos(angleOf(ray)) + outline.down * std::sin(angleOf(ray))) *
                                 outline.radius_mm[std::size_t(ray)];
}

VesselOutline dragged(const VesselOutline& outline, int ray, double radius_mm) {
  constexpr int kFollow = 5;  // the first ray that does not move
  VesselOutline moved = outline;
  const double wanted_mm = std::clamp(radius_mm, kMinOutline_mm, kMaxOutline_mm);
  const double way_mm = wanted_mm - outline.radius_mm[std::size_t(ray)];
  for (int off = 1 - kFollow; off < kFollow; ++off) {
    const double share = 0.5 + 0.5 * std::cos(std::numbers::pi * off / kFollow);
    double& radius = moved.radius_mm[std::size_t((ray + off + kOutlineRays) % kOutlineRays)];
    // A corner that is already beyond the wanted radius stays, e.g. the wall beside a bulge that is removed.
    const double rest_mm = wanted_mm - radius;
    radius += share * (way_mm < 0 ? std::clamp(rest_mm, way_mm, 0.0) : std::clamp(rest_mm, 0.0, way_mm));
  }
  return moved;
}

double outlineReach_mm(const VolumeGeometry& geometry, Vec3 along) {
  constexpr double kMin_mm = 4, kVoxels = 2;
  return std::max(kMin_mm, kVoxels / norm(geometry.indexFromPatient().linear * along));
}

SectionOutline outlineStep(const VesselCourse& course, std::size_t frame, const VesselOutline& outline,
                           double reach_mm) {
  // The directions at the end of the reach depend on a few points beyond it.
  constexpr std::size_t kBeyond = 3;
  const auto& frames = course.frames();
  const auto reach = static_cast<std::size_t>(std::lround(reach_mm / course.step_mm())) + kBeyond;
  const std::size_t first = frame > reach ? frame - reach : 0, last = std::min(frame + reach, frames.size() - 1);
  SectionOutline step;
  step.reach_mm = reach_mm;
  for (std::size_t n = first; n <= last; ++n) step.line_mm.push_back(frames[n].center_mm);
  step.section = static_cast<int>(frame - first);
  for (int ray = 0; ray < kOutlineRays; ++ray) {
    VesselOutline visible = outline;
    // A corner at the center would have no direction.
    visible.radius_mm[std::size_t(ray)] = std::max(outline.radius_mm[std::size_t(ray)], kMinOutline_mm);
    step.corners_mm.push_back(cornerOf(visible, ray));
  }
  return step;
}

Result<Proposal> reshapedVessel(const LabelMap& labels, std::uint8_t label, std::uint8_t rest,
                                const SectionOutline& outline) {
  if (auto ok = checkSectionOutline(outline); !ok) return tl::unexpected(ok.error());
  const auto middle = static_cast<std::size_t>(outline.section);
  const Vec3 center_mm = outline.line_mm[middle];
  const auto frames = framesAlong(outline.line_mm, middle, outline.corners_mm[0] - center_mm,
                                  outline.corners_mm[std::size_t(kOutlineRays / 4)] - center_mm);
  std::vector<double> along_mm(frames.size(), 0);
  for (std::size_t n = middle + 1; n < frames.size(); ++n)
    along_mm[n] = along_mm[n - 1] + norm(frames[n].center_mm - frames[n - 1].center_mm);
  for (std::size_t n = middle; n-- > 0;)
    along_mm[n] = along_mm[n + 1] - norm(frames[n].center_mm - frames[n + 1].center_mm);
  // The last section within the reach on each side keeps its outline.
  const double limit_mm = outline.reach_mm + 0.5 * kEqual_mm;
  std::size_t first = middle, last = middle;
  while (first > 0 && -along_mm[first - 1] <= limit_mm) --first;
  while (last + 1 < frames.size() && along_mm[last + 1] <= limit_mm) ++last;
  std::vector<OutlineSection> sections;
  for (std::size_t n = first; n <= last; ++n) {
    const VesselOutline before = outlineOf(labels, label, frames[n]);
    sections.push_back({frames[n], before, before});
  }
  OutlineSection& changed = sections[middle - first];
  for (std::size_t ray = 0; ray < kOutlineRays; ++ray)
    changed.after.radius_mm[ray] = norm(outline.corners_mm[ray] - center_mm);
  const bool endsBefore = -along_mm[first] < outline.reach_mm - 1, endsBehind = along_mm[last] < outline.reach_mm - 1;
  for (std::size_t n = first; n <= last; ++n) {
    if (n == middle) continue;
    const bool isBefore = n < middle;
    const bool isOpen = isBefore ? endsBefore : endsBehind;
    const double end_mm = isOpen ? outline.reach_mm : std::abs(along_mm[isBefore ? first : last]);
    const double share = 0.5 + 0.5 * std::cos(std::numbers::pi * std::min(std::abs(along_mm[n]) / end_mm, 1.0));
    const VesselOutline* end = isOpen ? nullptr : &sections[isBefore ? 0 : sections.size() - 1].before;
    blendRadii(sections[n - first], changed, end, share);
  }
  return OutlineWriter(labels, label, rest, std::move(sections)).write();
}

}  // namespace insonate
