#include "PatternAlignment.h"

#include "BlurProfile.h"
#include "LensDerivative.h"

#include <algorithm>
#include <cmath>

namespace insonate::camera {
namespace {

constexpr double kHalf = 0.5 * kTagCellsWithBorder;
constexpr double kRegion = 8.2 / kTagCells;  // part of the white border that counts, relative to the black square
constexpr double kMinBlur_px = 0.3, kMaxBlur_px = 4;
constexpr double kResidualScale = 0.15;  // of the contrast, in Geman and McClure's weights

/// Shares of a blurred pixel in the cells along one axis, and their derivatives by place and by the width of the blur.
struct CellShares {
  int first = 0, count = 0;
  std::array<float, kTagCellsWithBorder> share{}, byPlace{}, byWidth{};
};

CellShares sharesAt(double place_mm, double cell_mm, const BlurProfile& blur) {
  CellShares shares;
  const double reach = blur.reach_mm();
  const int last = std::clamp(int(std::floor((place_mm + reach) / cell_mm + kHalf)), 0, kTagCellsWithBorder - 1);
  shares.first = std::clamp(int(std::floor((place_mm - reach) / cell_mm + kHalf)), 0, last);
  shares.count = last - shares.first + 1;
  BlurProfile::Edge before = blur.at((shares.first - kHalf) * cell_mm - place_mm);
  for (int i = 0; i < shares.count; ++i) {
    const BlurProfile::Edge after = blur.at((shares.first + i + 1 - kHalf) * cell_mm - place_mm);
    const auto k = std::size_t(i);
    shares.share[k] = after.share - before.share;
    shares.byPlace[k] = before.density - after.density;
    shares.byWidth[k] = after.byWidth - before.byWidth;
    before = after;
  }
  return shares;
}

}  // namespace

/// Appearance of a tag at a pose.
struct PatternAlignment::TagView {
  Transform cameraFromTag;
  Vec3 origin;      ///< body's origin, camera frame
  Mat3 tagFromRay;  ///< homography: (X, Y, 1) on the tag, up to scale
  FrameBox box;
  double area_px = 0;
  BlurProfile across, down;
  double acrossPerBlur = 0, downPerBlur = 0;  ///< mm on the tag for each pixel of blur
};

/// Normal equations of all tags.
struct PatternAlignment::Sums {
  Matrix<kUnknowns, kUnknowns> matrix;
  Vector<kUnknowns> right;
  double squares = 0, weights = 0, contrast = 0, black = 0;
  int tags = 0;
};

/// Gray levels of ink and paper of one tag.
struct PatternAlignment::Photometry {
  double contrast = 0, black = 0;
};

PatternAlignment::PatternAlignment(const LensModel& lens) : lens_(lens) {
  rays_.reserve(std::size_t(2) * lens.width * lens.height);
  for (int y = 0; y < lens.height; ++y)
    for (int x = 0; x < lens.width; ++x) {
      const Vec3 ray = rayThrough(lens, {x + 0.5, y + 0.5});
      rays_.push_back(float(ray.x)), rays_.push_back(float(ray.y));
    }
}

std::optional<PatternAlignment::TagView> PatternAlignment::viewOf(const BodyTag& tag, const AlignmentStart& at) const {
  const Transform cameraFromTag = at.cameraFromBody * tag.bodyFromTag;
  const Vec3 normal = cameraFromTag.linear.column[2], center = cameraFromTag.offset;
  constexpr double kLeastCosine = 0.25;
  if (-dot(normal, center) < kLeastCosine * norm(center)) return std::nullopt;
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (const Vec3& corner : cornersOf(tag)) {
    const auto p = project(lens_, cameraFromTag * (corner * kRegion));
    if (!p) return std::nullopt;
    left = std::min(left, p->x), right = std::max(right, p->x);
    top = std::min(top, p->y), bottom = std::max(bottom, p->y);
  }
  if (left < 1 || top < 1 || right > lens_.width - 1 || bottom > lens_.height - 1) return std::nullopt;
  const auto middle = projectWithDerivative(lens_, center);
  if (!middle) return std::nullopt;
  const Vec3 &x = cameraFromTag.linear.column[0], &y = cameraFromTag.linear.column[1];
  const double xx = dot(middle->dx, x), xy = dot(middle->dx, y), yx = dot(middle->dy, x), yy = dot(middle->dy, y);
  const double determinant = xx * yy - xy * yx;
  const double area_px = std::abs(determinant) * tag.size_mm * tag.size_mm;
  constexpr double kLeastArea_px = 60;
  if (area_px < kLeastArea_px) return std::nullopt;
  // Rows of the inverse: mm on the tag for each pixel to the right and down.
  const double ax = yy / determinant, ay = -xy / determinant, bx = -yx / determinant, by = xx / determinant;
  const Vec3 path = shiftOf(at.duringExposure) + cross(turnOf(at.duringExposure), center - at.cameraFromBody.offset);
  const double mx = dot(middle->dx, path), my = dot(middle->dy, path);
  const double across = std::hypot(ax, ay), down = std::hypot(bx, by);
  return TagView{cameraFromTag,
                 at.cameraFromBody.offset,
                 insonate::inverted(Mat3{{x, y, center}}),
                 {int(left), int(top), int(right - left) + 2, int(bottom - top) + 2},
                 area_px,
                 BlurProfile(at.blur_px * across, std::abs(ax * mx + ay * my)),
                 BlurProfile(at.blur_px * down, std::abs(bx * mx + by * my)),
                 across,
                 down};
}

void PatternAlignment::sampleTag(const GrayView& image, const BodyTag& tag, const TagView& view, int step) {
  const TagPattern& pattern = tagPattern(tag.id);
  const double cell = tag.size_mm / kTagCells, limit = 0.5 * tag.size_mm * kRegion;
  const auto& [x, y, normal] = view.cameraFromTag.linear.column;
  const int right = std::min(view.box.left + view.box.width, image.width);
  const int bottom = std::min(view.box.top + view.box.height, image.height);
  samples_.clear();
  for (int v = view.box.top; v < bottom; ++v)
    for (int u = view.box.left + (step == 2 ? v % 2 : 0); u < right; u += step) {
      const float* ray = &rays_[2 * (std::size_t(v) * image.width + u)];
      const Vec3 direction{ray[0], ray[1], 1}, onTag = view.tagFromRay * direction;
      const double tx = onTag.x / onTag.z, ty = onTag.y / onTag.z;
      if (!(std::abs(tx) < limit && std::abs(ty) < limit)) continue;
      const CellShares columns = sharesAt(tx, cell, view.across), rows = sharesAt(-ty, cell, view.down);
      float ink = 0, byX = 0, byY = 0, byAcross = 0, byDown = 0;
      for (int j = 0; j < rows.count; ++j) {
        float share = 0, slope = 0, width = 0;
        const std::uint8_t* cells =
            &pattern[std::size_t(rows.first + j) * kTagCellsWithBorder + std::size_t(columns.first)];
        for (int i = 0; i < columns.count; ++i) {
          if (cells[i]) continue;
          const auto k = std::size_t(i);
          share += columns.share[k], slope += columns.byPlace[k], width += columns.byWidth[k];
        }
        const auto k = std::size_t(j);
        ink += rows.share[k] * share, byX += rows.share[k] * slope, byY -= rows.byPlace[k] * share;
        byAcross += rows.share[k] * width, byDown += rows.byWidth[k] * share;
      }
      Sample sample;
      sample.gray = image.pixels[std::size_t(v) * image.stride + u];
      sample.model = 1 - ink;
      // When the body moves by m, the ray meets the tag at -g m: the motion m, less its part along the ray.
      const double along = dot(normal, direction);
      const Vec3 gx = x - normal * (dot(x, direction) / along), gy = y - normal * (dot(y, direction) / along);
      const Vec3 g = gx * byX + gy * byY;  // derivative of `ink` is -g m, hence that of the model is +g m
      const Vec3 lever = view.cameraFromTag.offset + x * tx + y * ty - view.origin;
      const Vec3 turn = cross(lever, g);
      sample.slope = {float(g.x),
                      float(g.y),
                      float(g.z),
                      float(turn.x),
                      float(turn.y),
                      float(turn.z),
                      float(-byAcross * view.acrossPerBlur - byDown * view.downPerBlur)};
      samples_.push_back(sample);
    }
}

std::optional<PatternAlignment::Photometry> PatternAlignment::photometryOf(bool isRobust,
                                                                           double leastCorrelation) const {
  Photometry result;
  double correlation = 0;
  for (int pass = 0; pass < (isRobust ? 3 : 1); ++pass) {
    double w = 0, m = 0, g = 0, mm = 0, mg = 0, gg = 0;
    for (const Sample& s : samples_) {
      double weight = 1;
      if (pass > 0) {
        const double e = (s.gray - result.black - result.contrast * s.model) / (kResidualScale * result.contrast);
        weight = 1 / ((1 + e * e) * (1 + e * e));
      }
      w += weight, m += weight * s.model, g += weight * s.gray;
      mm += weight * s.model * s.model, mg += weight * s.model * s.gray, gg += weight * double(s.gray) * s.gray;
    }
    const double variance = w * mm - m * m, both = w * mg - m * g;
    if (!(variance > 1e-6 * w * w)) return std::nullopt;
    result.contrast = both / variance, result.black = (g - result.contrast * m) / w;
    if (pass == 0) correlation = both / std::sqrt(variance * std::max(1e-9, w * gg - g * g));
    constexpr double kLeastContrast = 8;
    if (result.contrast < kLeastContrast) return std::nullopt;
  }
  if (correlation < leastCorrelation) return std::nullopt;
  return result;
}

void PatternAlignment::addTag(const Photometry& photometry, bool isRobust, Sums& sums) const {
  // Unknowns, then contrast and black level, then the residual.
  constexpr int kAll = kUnknowns + 3;
  std::array<std::array<double, kAll>, kAll> s{};
  const double scale = 1 / (kResidualScale * photometry.contrast);
  for (const Sample& sample : samples_) {
    std::array<double, kAll> row{};
    for (std::size_t i = 0; i < kUnknowns; ++i) row[i] = photometry.contrast * sample.slope[i];
    row[kUnknowns] = sample.model, row[kUnknowns + 1] = 1;
    const double rest = sample.gray - photometry.black - photometry.contrast * sample.model;
    row[kUnknowns + 2] = rest;
    const double e = rest * scale, weight = isRobust ? 1 / ((1 + e * e) * (1 + e * e)) : 1;
    for (std::size_t i = 0; i < kAll; ++i) {
      const double weighted = weight * row[i];
      for (std::size_t j = i; j < kAll; ++j) s[i][j] += weighted * row[j];
    }
  }
  for (std::size_t i = 0; i < kAll; ++i)
    for (std::size_t j = 0; j < i; ++j) s[i][j] = s[j][i];
  // Eliminate contrast and black level (Schur complement).
  const std::size_t m = kUnknowns, one = kUnknowns + 1, rest = kUnknowns + 2;
  const double determinant = s[m][m] * s[one][one] - s[m][one] * s[m][one];
  for (std::size_t i = 0; i < kUnknowns; ++i) {
    const double a = (s[i][m] * s[one][one] - s[i][one] * s[m][one]) / determinant;
    const double b = (s[i][one] * s[m][m] - s[i][m] * s[m][one]) / determinant;
    for (std::size_t j = 0; j < kUnknowns; ++j) sums.matrix(int(i), int(j)) += s[i][j] - a * s[m][j] - b * s[one][j];
    sums.right[int(i)] += s[i][rest] - a * s[m][rest] - b * s[one][rest];
  }
  sums.squares += s[rest][rest], sums.weights += s[one][one];
  sums.contrast += photometry.contrast, sums.black += photometry.black;
  ++sums.tags;
}

PatternAlignment::Sums PatternAlignment::sumsAt(const GrayView& image, const TagBody& body, const AlignmentStart& at,
                                                bool isCoarse) {
  Sums sums;
  double area_px = 0;
  std::vector<std::optional<TagView>> views;
  AlignmentStart coarse = at;
  // A wider blur of the model finds edges that are farther away.
  constexpr double kWider_px = 1.3, kCoarseCorrelation = 0.5, kFineCorrelation = 0.75;
  if (isCoarse) coarse.blur_px += kWider_px;
  for (const BodyTag& tag : body.tags) {
    views.push_back(viewOf(tag, coarse));
    if (views.back()) area_px += views.back()->area_px;
  }
  // Half or a third of the pixels determine the pose of a large body well enough.
  constexpr double kManyPixels = 1500;
  const int step = area_px > 3 * kManyPixels ? 3 : area_px > kManyPixels ? 2 : 1;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!views[i]) continue;
    sampleTag(image, body.tags[i], *views[i], step);
    if (const auto photometry = photometryOf(!isCoarse, isCoarse ? kCoarseCorrelation : kFineCorrelation))
      addTag(*photometry, !isCoarse, sums);
  }
  return sums;
}

std::optional<AlignedPose> PatternAlignment::align(const GrayView& image, const TagBody& body,
                                                   const AlignmentStart& start, int leastTags) {
  if (image.width != lens_.width || image.height != lens_.height) return std::nullopt;
  AlignmentStart now = start;
  constexpr int kIterations = 7;
  const int coarse = start.isPrecise ? 1 : 2;
  Sums sums;
  for (int i = 0; i < kIterations; ++i) {
    sums = sumsAt(image, body, now, i < coarse);
    if (sums.tags < leastTags || sums.tags == 0) return std::nullopt;
    Matrix<kUnknowns, kUnknowns> matrix = sums.matrix;
    // The width of the blur changes little from image to image: 0.2 pixels.
    const double variance = std::max(1.0, sums.squares / sums.weights);
    matrix(6, 6) += variance / 0.04;
    const Vector<kUnknowns> step = solved(matrix, sums.right);
    Motion motion;
    for (int k = 0; k < 6; ++k) motion[k] = step[k];
    const double shift_mm = norm(shiftOf(motion)), turn = norm(turnOf(motion));
    constexpr double kTooFar_mm = 20, kTooFar_rad = 0.3;
    if (!(shift_mm < kTooFar_mm && turn < kTooFar_rad)) return std::nullopt;
    now.cameraFromBody = movedBy(now.cameraFromBody, motion);
    if (i >= coarse) now.blur_px = std::clamp(now.blur_px + std::clamp(step[6], -0.5, 0.5), kMinBlur_px, kMaxBlur_px);
    if (i > coarse && shift_mm < 0.01 && turn < 2e-4) break;
  }
  AlignedPose pose;
  pose.cameraFromBody = now.cameraFromBody, pose.blur_px = now.blur_px, pose.tags = sums.tags;
  const double contrast = sums.contrast / sums.tags;
  pose.black = sums.black / sums.tags, pose.white = pose.black + contrast;
  const double noise = std::max(1.0, std::sqrt(sums.squares / sums.weights));
  pose.error = noise / contrast;
  // Errors of the model are alike in neighboring pixels; measured errors are about twice those of independent noise.
  constexpr double kCorrelated = 4;
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) pose.information(r, c) = sums.matrix(r, c) / (kCorrelated * noise * noise);
  return pose;
}

}  // namespace insonate::camera
