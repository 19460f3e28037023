#include "DepthMarks.h"
#include "Evidence.h"
#include "Guesses.h"

#include <insonate/ultrasound/FovFit.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>

namespace insonate {
namespace {

using namespace fit;

constexpr int kLeastSide = 64, kMostSide = 16384;
constexpr double kWork_px = 900;                         // longer side of the image during the search
constexpr double kMostEnlarged = 2;                      // maximum enlargement of small captures
constexpr std::size_t kToMeasure = 250, kToRefine = 16;  // of the guesses
constexpr double kReach_px = 14;
constexpr double kCoarse_px = 4, kFine_px = 2.5;
constexpr double kDegrees = 180 / std::numbers::pi;

// Minimum agreement of outline and area with the image for a field of view.
constexpr double kLeastAgreement = 0.75, kLeastOutline = 0.3, kLeastCover = 0.6, kLeastFilled = 0.25, kMostGaps = 0.7;
constexpr double kEdgeSeen = 0.3, kEdgeVisible = 0.1;

// Maximum differences in width, depth and height for two images on one screen to count as equal. Of two equally clear
// ones, the left one is used.
constexpr double kSameSize = 0.12, kSameHeight = 0.06, kClearer = 0.05;

enum class Beside { Nothing, Right, Left };  ///< the side of another image

struct Candidate {
  FovModel model;
  Evidence evidence;
  bool upsideDown = false;
  const Plate* plate = nullptr;
  Beside beside = Beside::Nothing;
};

bool isSeen(const EdgeEvidence& edge) {
  return edge.visible >= kEdgeVisible && edge.seen >= kEdgeSeen && edge.seen > 2 * edge.against;
}

int edgesSeen(const Evidence& evidence) {
  return int(std::count_if(evidence.edges.begin(), evidence.edges.end(), isSeen));
}

bool acceptable(const Candidate& candidate) {
  const Evidence& e = candidate.evidence;
  if (e.agreement < kLeastAgreement || e.filled < kLeastFilled || e.gaps > kMostGaps || edgesSeen(e) < 2) return false;
  // A complete outline suffices, whatever else the screen shows.
  if (candidate.model.fan && e.outline >= 2 * kLeastOutline && e.agreement >= 0.9 && e.cover >= kLeastCover / 2)
    return true;
  // A large part of a dark image's outline is dark; the visible part must then agree better.
  const double least = e.agreement >= 0.84 && candidate.model.fan ? 0.65 * kLeastOutline : kLeastOutline;
  return e.outline >= least && e.cover >= kLeastCover;
}

std::optional<Candidate> bestOn(const Plate& plate, bool upsideDown) {
  // Computing the areas of all guesses would take seconds.
  std::vector<std::pair<double, FovModel>> guesses;
  for (const FovModel& model : guessesFor(plate)) guesses.emplace_back(outlineFor(model, plate, kCoarse_px), model);
  const std::size_t some = std::min(kToMeasure, guesses.size());
  std::partial_sort(guesses.begin(), guesses.begin() + std::ptrdiff_t(some), guesses.end(),
                    [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Candidate> all;
  for (std::size_t k = 0; k < some; ++k)
    all.push_back({guesses[k].second, evidenceFor(guesses[k].second, plate, kCoarse_px), upsideDown, &plate});
  const auto better = [](const Candidate& a, const Candidate& b) { return a.evidence.score() > b.evidence.score(); };
  const std::size_t few = std::min(kToRefine, all.size());
  std::partial_sort(all.begin(), all.begin() + std::ptrdiff_t(few), all.end(), better);
  all.resize(few);
  std::optional<Candidate> best;
  for (Candidate& candidate : all) {
    candidate.model = refined(candidate.model, plate, kReach_px);
    candidate.evidence = evidenceFor(candidate.model, plate, kFine_px);
    // A rectangle is the same upside down.
    if (upsideDown && !candidate.model.fan) continue;
    if (!best || better(candidate, *best)) best = candidate;
  }
  return best;
}

bool alike(const FovModel& a, const FovModel& b) {
  const auto near = [](double one, double other, double share) {
    return std::abs(one - other) <= share * std::max(one, other);
  };
  const double deepA = a.outer - a.inner, deepB = b.outer - b.inner;
  return a.fan == b.fan && near(a.half, b.half, kSameSize) && near(deepA, deepB, kSameSize) &&
         std::abs(a.at(0, 0).y - b.at(0, 0).y) <= kSameHeight * deepA;
}

/// One of two images beside each other. If both together look like one image (`whole`), only if the two are equal.
std::optional<Candidate> bestOfHalves(const std::array<Plate, 2>& halves, bool upsideDown, bool whole) {
  std::array<std::optional<Candidate>, 2> found;
  for (std::size_t side = 0; side < 2; ++side) {
    found[side] = bestOn(halves[side], upsideDown);
    if (!found[side]) continue;
    if (!acceptable(*found[side]))
      found[side].reset();
    else
      found[side]->beside = side == 0 ? Beside::Right : Beside::Left;
  }
  auto& [left, right] = found;
  if (whole && !(left && right && alike(left->model, right->model))) return std::nullopt;
  if (!left || !right) return left ? left : right;
  return right->evidence.score() > left->evidence.score() + kClearer ? right : left;
}

FovShape shapeOf(const Candidate& candidate, double scale, int height) {
  const FovModel& m = candidate.model;
  const double back = 1 / scale;
  FovShape shape;
  const double depth = (m.outer - m.inner) * back;
  shape.origin = {(m.x + 0.5) * back - 0.5, (m.y + 0.5) * back - 0.5};
  if (candidate.upsideDown) shape.origin.y = height - 1 - shape.origin.y;
  shape.upsideDown = candidate.upsideDown;
  shape.rotation_deg = m.turn * kDegrees;
  if (!m.fan) {
    shape.width_px = 2 * m.half * back, shape.depth_px = depth;
    return shape;
  }
  shape.alpha_deg = 2 * m.half * kDegrees;
  shape.r1_px = m.inner * back, shape.r2_px = m.outer * back;
  shape.shape = m.inner < 0.08 * m.outer ? ProbeShape::Phased : ProbeShape::Curvilinear;
  return shape;
}

/// The shape in the pixels of the other image, as a model.
FovModel modelOf(const FovShape& shape, int height) {
  const bool fan = shape.shape != ProbeShape::Linear;
  FovModel model{fan, shape.origin.x, shape.upsideDown ? height - 1 - shape.origin.y : shape.origin.y,
                 shape.rotation_deg / kDegrees};
  model.half = fan ? shape.alpha_deg / 2 / kDegrees : shape.width_px / 2;
  model.inner = fan ? shape.r1_px : 0, model.outer = fan ? shape.r2_px : shape.depth_px;
  return model;
}

std::vector<std::string> warningsOf(const Candidate& candidate) {
  static constexpr std::array<const char*, kEdges> kNames{"left side", "right side", "face", "far end"};
  std::vector<std::string> warnings;
  for (int edge = 0; edge < kEdges; ++edge) {
    const EdgeEvidence& seen = candidate.evidence.edges[std::size_t(edge)];
    if (candidate.model.fan && edge == kFace && candidate.model.inner < 0.08 * candidate.model.outer) continue;
    const std::string name = std::string("The ") + kNames[std::size_t(edge)];
    if (seen.visible < kEdgeVisible)
      warnings.push_back(name + " lies outside the image.");
    else if (!isSeen(seen))
      warnings.push_back(name + " is hardly visible. Check it.");
    else if (seen.visible < 0.75)
      warnings.push_back(name + " is cut off by the edge of the image.");
  }
  if (candidate.beside != Beside::Nothing)
    warnings.push_back(std::string("Two images lie side by side; this is the ") +
                       (candidate.beside == Beside::Right ? "left" : "right") + " one.");
  if (candidate.plate->darkOnLight)
    warnings.emplace_back("The image shows dark echoes on a light background; its grays were inverted.");
  if (candidate.upsideDown) warnings.emplace_back("The image is upside down.");
  return warnings;
}

double confidenceOf(const Evidence& evidence) {
  const double outline = std::clamp((evidence.outline - 0.2) / 0.6, 0.0, 1.0);
  const double agreement = std::clamp((evidence.agreement - 0.7) / 0.25, 0.0, 1.0);
  const double cover = std::clamp((evidence.cover - 0.2) / 0.5, 0.0, 1.0);
  return std::cbrt(outline * agreement * cover) * (0.4 + 0.15 * edgesSeen(evidence));
}

/// The likely meaning: if every second, fifth or tenth mark is longer, the longer marks are centimeters or multiples of
/// five; equal marks are centimeters, if a depth of that many is likely.
void giveMeaning(DepthRuler& ruler, double depth_px, bool linear) {
  ruler.mmPerMark = ruler.longEvery == 2 ? 5 : ruler.longEvery == 10 ? 1 : 10;
  const double depth_mm = depth_px / ruler.spacing_px * ruler.mmPerMark;
  if (depth_mm > (linear ? 160 : 330)) ruler.mmPerMark /= ruler.longEvery == 0 ? 2 : 5;
}

}  // namespace

Result<FovFit> fitFov(const GrayImage& picture) {
  const int wide = picture.width, high = picture.height;
  if (std::min(wide, high) < kLeastSide || std::max(wide, high) > kMostSide)
    return fail("The image has " + std::to_string(wide) + " x " + std::to_string(high) +
                " pixels. A fit needs 64 to 16384 pixels in width and height.");
  if (picture.gray.size() != std::size_t(wide) * high) return fail("The image is not complete.");
  cv::Mat_<uchar> gray(high, wide);
  std::copy(picture.gray.begin(), picture.gray.end(), gray.begin());
  const double scale = std::min(kMostEnlarged, kWork_px / std::max(wide, high));
  cv::Mat_<uchar> work, flipped;
  cv::resize(gray, work, {}, scale, scale, scale < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  cv::flip(work, flipped, 0);
  const std::vector<Plate> upright = platesOf(work), turned = platesOf(flipped);
  std::deque<std::array<Plate, 2>> parted;  // candidates point into it, so that elements must not move
  std::optional<Candidate> best;
  const auto consider = [&](const std::vector<Plate>& plates, bool upsideDown) {
    for (const Plate& plate : plates) {
      auto candidate = bestOn(plate, upsideDown);
      if (candidate && !acceptable(*candidate)) candidate.reset();
      if (auto halves = halvesOf(plate)) {
        parted.push_back(std::move(*halves));
        if (auto half = bestOfHalves(parted.back(), upsideDown, candidate.has_value())) candidate = half;
      }
      if (!candidate) continue;
      if (!best || candidate->evidence.score() > best->evidence.score() + 0.01) best = candidate;
    }
  };
  consider(upright, false);
  consider(turned, true);
  if (!best)
    return fail(
        "No field of view was found: the image shows no fan or rectangle of echoes on a uniform background. Use an "
        "image that shows the whole field of view, or place the outline by hand.");
  FovFit fit;
  fit.shape = shapeOf(*best, scale, high);
  fit.confidence = confidenceOf(best->evidence);
  fit.warnings = warningsOf(*best);
  cv::Mat_<uchar> original = gray;
  if (best->plate->darkOnLight) original = 255 - gray;
  if (best->upsideDown) cv::flip(original.clone(), original, 0);
  fit.ruler = depthMarks(original, modelOf(fit.shape, high));
  if (fit.ruler) {
    giveMeaning(*fit.ruler, depthOf_px(fit.shape), fit.shape.shape == ProbeShape::Linear);
    if (best->upsideDown)
      for (PixelPoint& p : fit.ruler->at) p.y = high - 1 - p.y;
  } else {
    fit.warnings.emplace_back("No marks of a depth scale were found; type the depth.");
  }
  return fit;
}

}  // namespace insonate
