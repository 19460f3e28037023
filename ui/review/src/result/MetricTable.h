#pragma once

#include <insonate/procedure/AttemptScore.h>

#include <QTableWidget>
#include <vector>

namespace insonate::review {

/// All metrics with value, unit, and a bar between what novices and experts reach; "n/a" where something is not known.
class MetricTableView : public QTableWidget {
 public:
  enum Column { kName, kValue, kNovice, kBar, kExpert, kColumns };

  explicit MetricTableView(QWidget* parent = nullptr);
  /// Shows scores, those with novice and expert values first. Empty for none.
  void show(const std::vector<MetricScore>& scores);

 private:
  class Bars;
  std::vector<MetricScore> scores_;
};

/// Orders scores for display: those with norms first.
std::vector<MetricScore> ordered(std::vector<MetricScore> scores);

}  // namespace insonate::review
