#include "LensDerivative.h"
#include "Rigid.h"

#include <insonate/camera/LensCalibration.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace insonate {
namespace {

using camera::Matrix;
using camera::Motion;

constexpr int kLensUnknowns = 8;  // fx, fy, cx, cy, k1, k2, p1, p2
constexpr int kFirstBoardId = 22, kBoardColumns = 3, kBoardRows = 4;
constexpr double kBoardTag_mm = 42, kBoardPitch_mm = 56;

std::vector<BodyTag> makeBoard() {
  std::vector<BodyTag> tags;
  for (int row = 0; row < kBoardRows; ++row)
    for (int column = 0; column < kBoardColumns; ++column) {
      BodyTag tag;
      tag.id = kFirstBoardId + row * kBoardColumns + column, tag.size_mm = kBoardTag_mm;
      tag.bodyFromTag.offset = {(column - 0.5 * (kBoardColumns - 1)) * kBoardPitch_mm,
                                (0.5 * (kBoardRows - 1) - row) * kBoardPitch_mm, 0};
      tags.push_back(tag);
    }
  return tags;
}

struct Corner {
  Vec3 board;
  FramePoint pixel;
};
using View = std::vector<Corner>;

/// Homography of the board's plane, from (x, y, 1) to pixels; the last value is 1.
std::optional<std::array<double, 9>> homographyOf(const View& view, const LensModel& scale) {
  Matrix<8, 8> a;
  Matrix<8, 1> b;
  // Coordinates of about 1 keep the equations well conditioned.
  const double size = kBoardPitch_mm;
  for (const Corner& c : view) {
    const double x = c.board.x / size, y = c.board.y / size;
    const double u = (c.pixel.x - scale.cx_px) / scale.fx_px, v = (c.pixel.y - scale.cy_px) / scale.fx_px;
    const double rows[2][8] = {{x, y, 1, 0, 0, 0, -u * x, -u * y}, {0, 0, 0, x, y, 1, -v * x, -v * y}};
    for (int k = 0; k < 2; ++k)
      for (int i = 0; i < 8; ++i) {
        b[i] += rows[k][i] * (k == 0 ? u : v);
        for (int j = 0; j < 8; ++j) a(i, j) += rows[k][i] * rows[k][j];
      }
  }
  if (!camera::solvePositive(a.values.data(), b.values.data(), 8, 1)) return std::nullopt;
  return std::array<double, 9>{b[0] / size, b[1] / size, b[2], b[3] / size, b[4] / size, b[5],
                               b[6] / size, b[7] / size, 1};
}

using Homographies = std::vector<std::array<double, 9>>;

/// Focal length relative to that of `scale` from the condition that the board's axes are perpendicular and equally
/// long; no value if the board was always parallel to the image.
std::optional<double> focalFrom(const Homographies& all) {
  double above = 0, below = 0;
  for (const auto& h : all) {
    const double length = h[0] * h[0] + h[3] * h[3] + h[1] * h[1] + h[4] * h[4];
    const double a[2] = {(h[0] * h[1] + h[3] * h[4]) / length,
                         (h[0] * h[0] + h[3] * h[3] - h[1] * h[1] - h[4] * h[4]) / length};
    const double b[2] = {-h[6] * h[7] / length, (h[7] * h[7] - h[6] * h[6]) / length};
    for (int k = 0; k < 2; ++k) above += a[k] * b[k], below += a[k] * a[k];
  }
  constexpr double kLeastTilt = 1e-4;
  const double inverseSquare = above / below;
  if (!(below > kLeastTilt * double(all.size())) || !(inverseSquare > 0)) return std::nullopt;
  return 1 / std::sqrt(inverseSquare);
}

Transform poseFrom(const std::array<double, 9>& h, double focal) {
  const Vec3 h1{h[0] / focal, h[3] / focal, h[6]}, h2{h[1] / focal, h[4] / focal, h[7]},
      h3{h[2] / focal, h[5] / focal, 1};
  const double scale = 2 / (norm(h1) + norm(h2));
  return {camera::orthonormal({{normalized(h1), normalized(h2), normalized(cross(h1, h2))}}), h3 * scale};
}

/// The lens and the poses of the board in all images.
struct Estimate {
  LensModel lens;
  std::vector<Transform> cameraFromBoard;
};

struct Equations {
  std::vector<double> matrix, right;
  double squares = 0;
  int count = 0;
};

/// Derivatives of both coordinates of a corner by the unknowns of the lens, as in LensModel.h.
std::array<std::array<double, kLensUnknowns>, 2> lensRows(const LensModel& lens, Vec3 p) {
  const double x = p.x / p.z, y = p.y / p.z, r2 = x * x + y * y;
  const double radial = 1 + r2 * (lens.k1 + r2 * lens.k2);
  const double dx = x * radial + 2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x);
  const double dy = y * radial + lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y;
  return {{{dx, 0, 1, 0, lens.fx_px * x * r2, lens.fx_px * x * r2 * r2, lens.fx_px * 2 * x * y,
            lens.fx_px * (r2 + 2 * x * x)},
           {0, dy, 0, 1, lens.fy_px * y * r2, lens.fy_px * y * r2 * r2, lens.fy_px * (r2 + 2 * y * y),
            lens.fy_px * 2 * x * y}}};
}

Equations equationsAt(const Estimate& e, const std::vector<View>& views) {
  const std::size_t n = kLensUnknowns + 6 * views.size();
  Equations q{std::vector<double>(n * n), std::vector<double>(n), 0, 0};
  for (std::size_t v = 0; v < views.size(); ++v)
    for (const Corner& corner : views[v]) {
      const Vec3 lever = e.cameraFromBoard[v].linear * corner.board, p = lever + e.cameraFromBoard[v].offset;
      const auto projected = camera::projectWithDerivative(e.lens, p);
      if (!projected) {
        q.squares += 1e4, ++q.count;
        continue;
      }
      const auto ofLens = lensRows(e.lens, p);
      const double rest[2] = {corner.pixel.x - projected->pixel.x, corner.pixel.y - projected->pixel.y};
      for (std::size_t k = 0; k < 2; ++k) {
        const Vec3 d = k == 0 ? projected->dx : projected->dy, w = cross(lever, d);
        std::array<double, kLensUnknowns + 6> row{};
        std::array<std::size_t, kLensUnknowns + 6> place{};
        std::copy(ofLens[k].begin(), ofLens[k].end(), row.begin());
        const double ofPose[6] = {d.x, d.y, d.z, w.x, w.y, w.z};
        std::copy(ofPose, ofPose + 6, row.begin() + kLensUnknowns);
        for (std::size_t i = 0; i < row.size(); ++i) place[i] = i < kLensUnknowns ? i : i + 6 * v;
        for (std::size_t i = 0; i < row.size(); ++i) {
          q.right[place[i]] += row[i] * rest[k];
          for (std::size_t j = 0; j < row.size(); ++j) q.matrix[place[i] * n + place[j]] += row[i] * row[j];
        }
        q.squares += rest[k] * rest[k];
      }
      ++q.count;
    }
  return q;
}

Estimate moved(Estimate e, const std::vector<double>& step) {
  LensModel& lens = e.lens;
  lens.fx_px += step[0], lens.fy_px += step[1], lens.cx_px += step[2], lens.cy_px += step[3];
  lens.k1 += step[4], lens.k2 += step[5], lens.p1 += step[6], lens.p2 += step[7];
  for (std::size_t v = 0; v < e.cameraFromBoard.size(); ++v) {
    Motion motion;
    for (std::size_t i = 0; i < 6; ++i) motion[int(i)] = step[kLensUnknowns + 6 * v + i];
    e.cameraFromBoard[v] = camera::movedBy(e.cameraFromBoard[v], motion);
  }
  return e;
}

/// Levenberg-Marquardt over all unknowns; returns the mean square error of a corner, px^2.
double refine(Estimate& e, const std::vector<View>& views) {
  double damping = 1e-3;
  Equations now = equationsAt(e, views);
  const int n = int(now.right.size());
  constexpr int kIterations = 60;
  for (int i = 0; i < kIterations && damping < 1e8; ++i) {
    std::vector<double> matrix = now.matrix, step = now.right;
    for (int d = 0; d < n; ++d) matrix[std::size_t(d) * (n + 1)] *= 1 + damping;
    if (!camera::solvePositive(matrix.data(), step.data(), n, 1)) {
      damping *= 10;
      continue;
    }
    const Estimate next = moved(e, step);
    Equations there = equationsAt(next, views);
    if (!(there.squares < now.squares)) {
      damping *= 10;
      continue;
    }
    const bool isDone = now.squares - there.squares < 1e-10 * now.squares;
    e = next, now = std::move(there), damping = std::max(1e-9, damping / 10);
    if (isDone) break;
  }
  return now.squares / std::max(1, now.count);
}

/// Distance between two views: mean distance of the corners that both show, px; infinite without common corners.
double difference(const View& a, const View& b) {
  double sum = 0;
  int count = 0;
  for (const Corner& p : a)
    for (const Corner& q : b)
      if (p.board == q.board) sum += std::hypot(p.pixel.x - q.pixel.x, p.pixel.y - q.pixel.y), ++count;
  return count > 0 ? sum / count : 1e9;
}

}  // namespace

const std::vector<BodyTag>& lensBoard() {
  static const std::vector<BodyTag> board = makeBoard();
  return board;
}

struct LensCalibrator::Views {
  int width, height;
  TagDetector detector;
  std::vector<View> views;
};

LensCalibrator::LensCalibrator(int width, int height) : views_(new Views{width, height, {}, {}}) {}
LensCalibrator::~LensCalibrator() = default;
LensCalibrator::LensCalibrator(LensCalibrator&&) noexcept = default;
LensCalibrator& LensCalibrator::operator=(LensCalibrator&&) noexcept = default;

int LensCalibrator::views() const {
  return int(views_->views.size());
}

BoardView LensCalibrator::add(const CameraFrame& frame) {
  if (frame.width != views_->width || frame.height != views_->height) return BoardView::kNoBoard;
  std::vector<TagDetection> found;
  views_->detector.detect(frame.view(), {0, 0, frame.width, frame.height}, 1, found);
  return add(found);
}

BoardView LensCalibrator::add(const std::vector<TagDetection>& detections) {
  View view;
  for (const TagDetection& detection : detections) {
    const auto tag = std::ranges::find(lensBoard(), detection.id, &BodyTag::id);
    if (tag == lensBoard().end()) continue;
    const auto corners = cornersOf(*tag);
    for (std::size_t i = 0; i < 4; ++i) view.push_back({tag->bodyFromTag * corners[i], detection.corners[i]});
  }
  constexpr std::size_t kLeastCorners = 16, kMaxViews = 40;
  if (view.size() < kLeastCorners) return BoardView::kNoBoard;
  const double near_px = 0.03 * views_->width;
  for (const View& other : views_->views)
    if (difference(view, other) < near_px) return BoardView::kSimilar;
  if (views_->views.size() >= kMaxViews) return BoardView::kSimilar;
  views_->views.push_back(std::move(view));
  return BoardView::kTaken;
}

Result<LensCalibration> LensCalibrator::calibrate() const {
  if (views() < kLeastViews)
    return fail("The calibration of the lens has " + std::to_string(views()) +
                " images of the board; it needs at least " + std::to_string(kLeastViews) +
                ". Show the board in other places and directions.");
  Estimate e;
  e.lens = lensWithoutDistortion(views_->width, views_->height, 60);
  Homographies all;
  for (const View& view : views_->views)
    if (const auto h = homographyOf(view, e.lens)) all.push_back(*h);
  const auto focal = focalFrom(all);
  if (!focal || all.size() != views_->views.size())
    return fail("All images show the board from the same direction. Tilt the board in different directions.");
  e.lens.fx_px *= *focal, e.lens.fy_px *= *focal;
  for (const auto& h : all) e.cameraFromBoard.push_back(poseFrom(h, *focal));
  const double error_px = std::sqrt(refine(e, views_->views));
  constexpr double kMaxError_px = 1.5;
  if (!(error_px < kMaxError_px) || !(e.lens.fx_px > 0) || !(e.lens.fy_px > 0))
    return fail(
        "The images of the board do not fit to a lens. Glue the board flat onto cardboard, hold it still for each "
        "image, and calibrate again.");
  return LensCalibration{e.lens, error_px, views()};
}

}  // namespace insonate
