#pragma once

#include <insonate/procedure/AttemptScore.h>

#include <QString>
#include <QTableWidget>
#include <vector>

namespace insonate::review {

/// Table of all metrics with value, unit, and a bar between the values of novices and experts; "n/a" for unknown
/// values.
class MetricTableView : public QTableWidget {
 public:
  enum Column { kName, kValue, kNovice, kBar, kExpert, kColumns };

  explicit MetricTableView(QWidget* parent = nullptr);
  /// Shows scores. Scores with novice and expert values come first. Empty: no scores.
  void show(const std::vector<MetricScore>& scores);

 private:
  class Bars;
  std::vector<MetricScore> scores_;
};

/// Orders scores for display: those with norms first. Metrics of the line without a value are left out, since an
/// attempt that ends with the puncture has none.
std::vector<MetricScore> ordered(std::vector<MetricScore> scores);

/// Formats a norm with as many digits as its study reports.
QString normOf(Metric metric, double value);
/// Explains, for a tooltip, what the metric counts, who measured novices and experts, and the evidence.
QString explanationOf(const MetricScore& score);

}  // namespace insonate::review
