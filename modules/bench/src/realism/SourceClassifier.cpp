#include "realism/SourceClassifier.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace insonate::bench {
namespace {

constexpr double kShrink = 0.5;

class Discriminant {
 public:
  explicit Discriminant(const std::vector<const FeatureRow*>& rows) {
    const auto features = Eigen::Index(rows.front()->values.size());
    middle_ = Eigen::VectorXd::Zero(features), spread_ = Eigen::VectorXd::Ones(features);
    for (Eigen::Index f = 0; f < features; ++f) standardize(rows, f);
    Eigen::VectorXd means[2] = {Eigen::VectorXd::Zero(features), Eigen::VectorXd::Zero(features)};
    double counts[2] = {0, 0};
    for (const FeatureRow* row : rows) means[row->simulated] += standardized(*row), ++counts[row->simulated];
    for (const int group : {0, 1}) means[group] /= std::max(1.0, counts[group]);
    Eigen::MatrixXd within = Eigen::MatrixXd::Zero(features, features);
    for (const FeatureRow* row : rows) {
      const Eigen::VectorXd off = standardized(*row) - means[row->simulated];
      within += off * off.transpose();
    }
    within /= std::max(1.0, double(rows.size()) - 2);
    const Eigen::VectorXd diagonal = within.diagonal();
    within *= 1 - kShrink;
    within.diagonal() += kShrink * diagonal + Eigen::VectorXd::Constant(features, 1e-6);
    weights_ = within.ldlt().solve(means[1] - means[0]);
    threshold_ = weights_.dot(means[0] + means[1]) / 2;
    scale_ = std::sqrt(std::max(1e-12, weights_.dot(within * weights_)));
  }

  double operator()(const FeatureRow& row) const { return (weights_.dot(standardized(row)) - threshold_) / scale_; }

 private:
  void standardize(const std::vector<const FeatureRow*>& rows, Eigen::Index f) {
    double sum = 0, square = 0, count = 0;
    for (const FeatureRow* row : rows)
      if (const double v = row->values[std::size_t(f)]; std::isfinite(v)) sum += v, square += v * v, ++count;
    if (count == 0) return;
    middle_[f] = sum / count;
    if (const double variance = square / count - middle_[f] * middle_[f]; variance > 0)
      spread_[f] = std::sqrt(variance);
  }
  Eigen::VectorXd standardized(const FeatureRow& row) const {
    Eigen::VectorXd z(middle_.size());
    for (Eigen::Index f = 0; f < z.size(); ++f) {
      const double v = row.values[std::size_t(f)];
      z[f] = std::isfinite(v) ? (v - middle_[f]) / spread_[f] : 0;
    }
    return z;
  }

  Eigen::VectorXd middle_, spread_, weights_;
  double threshold_ = 0, scale_ = 1;
};

}  // namespace

std::vector<double> leaveOneSourceOut(const std::vector<FeatureRow>& rows) {
  std::vector<double> scores(rows.size(), std::numeric_limits<double>::quiet_NaN());
  std::set<std::string> sources;
  for (const FeatureRow& row : rows) sources.insert(row.source);
  for (const std::string& source : sources) {
    std::vector<const FeatureRow*> others;
    for (const FeatureRow& row : rows)
      if (row.source != source) others.push_back(&row);
    const auto isSimulated = [](const FeatureRow* row) { return row->simulated; };
    if (std::ranges::all_of(others, isSimulated) || std::ranges::none_of(others, isSimulated)) continue;
    const Discriminant discriminant(others);
    for (std::size_t n = 0; n < rows.size(); ++n)
      if (rows[n].source == source) scores[n] = discriminant(rows[n]);
  }
  return scores;
}

}  // namespace insonate::bench
