#include "DepthMarks.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace insonate::fit {
namespace {

constexpr int kFewestMarks = 4;
constexpr double kLeastSpacing_px = 6;
constexpr double kHighestMark = 0.022;  // height of a mark relative to the depth
constexpr double kLeastSpan = 0.6;      // share of the depth that the marks must cover
constexpr double kLeastPresent = 0.7;   // share of the predicted marks that must exist
constexpr double kOffPlace_px = 1.3;
constexpr float kLeastContrast = 25;

/// The surroundings of the model, rotated upright: column u, row v, from `left`, `top`.
struct Upright {
  cv::Mat_<float> gray;
  double left = 0, top = 0;
};

Upright uprightOf(const cv::Mat_<uchar>& gray, const FovModel& model) {
  const double c = std::cos(model.turn), s = std::sin(model.turn);
  Upright upright;
  upright.left = -std::hypot(gray.cols, gray.rows), upright.top = model.inner - 0.08 * (model.outer - model.inner);
  double right = -upright.left, bottom = model.outer + 0.05 * (model.outer - model.inner);
  const auto u = [&](double x, double y) { return c * (x - model.x) - s * (y - model.y); };
  const double leftEnd = std::min(u(0, 0), u(0, gray.rows)),
               rightEnd = std::max(u(gray.cols, 0), u(gray.cols, gray.rows));
  upright.left = std::floor(leftEnd), right = std::ceil(rightEnd);
  const cv::Matx23d pictureFromUpright(c, s, model.x + c * upright.left + s * upright.top,  //
                                       -s, c, model.y - s * upright.left + c * upright.top);
  cv::Mat turned;
  cv::warpAffine(gray, turned, pictureFromUpright, {int(right - upright.left) + 1, int(bottom - upright.top) + 1},
                 cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  turned.convertTo(upright.gray, CV_32F);
  return upright;
}

struct Run {
  double middle = 0;
  int column = 0;
};

/// Short light runs in a column outside the model.
std::vector<Run> runsIn(const cv::Mat_<float>& contrast, const cv::Mat_<uchar>& outside, int column, int highest) {
  std::vector<Run> runs;
  int from = -1;
  for (int row = 0; row <= contrast.rows; ++row) {
    const bool light = row < contrast.rows && contrast(row, column) > kLeastContrast && outside(row, column);
    if (light && from < 0) from = row;
    if (light || from < 0) continue;
    if (row - from <= highest) {
      double sum = 0, weights = 0;
      for (int k = from; k < row; ++k) sum += double(k) * contrast(k, column), weights += contrast(k, column);
      runs.push_back({sum / weights, column});
    }
    from = -1;
  }
  return runs;
}

struct Comb {
  double first = 0, spacing = 0, score = 0;
  int marks = 0, column = 0;
};

/// Finds the equal spacing through two runs with which most runs agree and which predicts few missing runs.
Comb combThrough(const std::vector<Run>& runs, double depth_px) {
  Comb best;
  if (int(runs.size()) < kFewestMarks || runs.size() > 150) return best;
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t j = i + 1; j < std::min(runs.size(), i + 4); ++j) {
      double spacing = runs[j].middle - runs[i].middle, first = runs[i].middle;
      if (spacing < kLeastSpacing_px || spacing > depth_px / 2) continue;
      // Proceeds outward from the pair, mark by mark, so that a small error does not accumulate.
      double lowest = first, highest = runs[j].middle;
      int found = 2, steps = 1;
      for (std::size_t k = j + 1; k < runs.size(); ++k) {
        const double ahead = (runs[k].middle - first) / spacing, whole = std::round(ahead);
        if (whole <= steps || std::abs(ahead - whole) * spacing > kOffPlace_px) continue;
        if (whole > steps + 3) break;
        steps = int(whole), ++found, highest = runs[k].middle;
        spacing = (highest - first) / steps;
      }
      if (found < kFewestMarks || found < kLeastPresent * (steps + 1)) continue;
      if (highest - lowest < kLeastSpan * depth_px) continue;
      // Runs that are not marks lower the score of a ruler, since letters have many of them.
      const double score = found - 0.5 * (double(runs.size()) - found) - 0.5 * (steps + 1 - found);
      if (score > best.score) best = {first, spacing, score, found, runs[i].column};
    }
  return best;
}

/// Length of a mark to both sides of the column.
int lengthOf(const cv::Mat_<float>& contrast, int row, int column) {
  const auto light = [&](int c) {
    for (int r = std::max(0, row - 1); r <= std::min(contrast.rows - 1, row + 1); ++r)
      if (contrast(r, c) > kLeastContrast) return true;
    return false;
  };
  int from = column, to = column;
  while (from > 0 && column - from < 40 && light(from - 1)) --from;
  while (to + 1 < contrast.cols && to - column < 40 && light(to + 1)) ++to;
  return to - from + 1;
}

/// Every n-th mark longer than the others.
int longEvery(const std::vector<int>& lengths) {
  for (const int every : {2, 5, 10}) {
    if (int(lengths.size()) < every + 1) break;
    for (int start = 0; start < every; ++start) {
      double longs = 0, shorts = 0;
      int shortest = 1000, longest = 0;
      for (int k = 0; k < int(lengths.size()); ++k) {
        if (lengths[std::size_t(k)] <= 0) continue;
        if (k % every == start)
          shortest = std::min(shortest, lengths[std::size_t(k)]), ++longs;
        else
          longest = std::max(longest, lengths[std::size_t(k)]), ++shorts;
      }
      if (longs > 0 && shorts > 0 && shortest >= 1.25 * longest && shortest >= longest + 2) return every;
    }
  }
  return 0;
}

}  // namespace

std::optional<DepthRuler> depthMarks(const cv::Mat_<uchar>& gray, const FovModel& model) {
  const Upright upright = uprightOf(gray, model);
  const double depth = model.outer - model.inner;
  const int highest = std::max(5, int(kHighestMark * depth));
  cv::Mat_<float> ground, contrast;
  // Light marks with the height of a mark, on dark background.
  cv::morphologyEx(upright.gray, ground, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, {1, highest + 3}));
  contrast = upright.gray - ground;
  cv::Mat_<uchar> outside(contrast.size(), uchar{0});
  FovModel straight = model;
  straight.x = straight.y = straight.turn = 0;
  const Beyond from(straight);
  for (int row = 0; row < outside.rows; ++row)
    for (int column = 0; column < outside.cols; ++column) {
      const auto beyond = from({upright.left + column, upright.top + row});
      if (*std::max_element(beyond.begin(), beyond.end()) > 3) outside(row, column) = 1;
    }
  Comb best;
  for (int column = 2; column + 2 < contrast.cols; ++column) {
    const Comb comb = combThrough(runsIn(contrast, outside, column, highest), depth);
    if (comb.score > best.score + 0.01) best = comb;
  }
  if (best.marks < kFewestMarks) return std::nullopt;
  // Repeats the search in the ruler's column: the visible marks, and the spacing by least squares.
  DepthRuler ruler;
  std::vector<int> lengths;
  double n = 0, sumK = 0, sumV = 0, sumKK = 0, sumKV = 0;
  int previous = -1;
  for (const Run& run : runsIn(contrast, outside, best.column, highest)) {
    const double ahead = (run.middle - best.first) / best.spacing, whole = std::round(ahead);
    if (whole <= previous || whole < 0 || std::abs(ahead - whole) * best.spacing > 2 * kOffPlace_px) continue;
    for (; previous + 1 < int(whole); ++previous) lengths.push_back(0);
    previous = int(whole);
    lengths.push_back(lengthOf(contrast, int(std::lround(run.middle)), best.column));
    n += 1, sumK += whole, sumV += run.middle, sumKK += whole * whole, sumKV += whole * run.middle;
    const double u = upright.left + best.column, v = upright.top + run.middle;
    const double c = std::cos(model.turn), s = std::sin(model.turn);
    ruler.at.push_back({model.x + c * u + s * v, model.y - s * u + c * v});
  }
  const double det = n * sumKK - sumK * sumK;
  if (n < kFewestMarks || det <= 0) return std::nullopt;
  ruler.spacing_px = (n * sumKV - sumK * sumV) / det;
  ruler.marks = int(n);
  ruler.longEvery = longEvery(lengths);
  return ruler;
}

}  // namespace insonate::fit
