#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;

namespace insonate::views {
struct HuHistogram;
}

namespace insonate::prepare {

class LabelBox;
struct PrepareModel;
class RangeField;

/// Editor of the rules for all tools: the labels that they may overwrite, and the range of CT values that they may
/// change.
class RulesBox : public QWidget {
 public:
  explicit RulesBox(PrepareModel& shared, QWidget* parent = nullptr);

  void setHistogram(const views::HuHistogram& histogram);

 private:
  void connectParts();
  void refresh();

  PrepareModel& shared_;
  QComboBox* over_;
  LabelBox* inside_;
  QCheckBox* limited_;
  RangeField* range_;
};

}  // namespace insonate::prepare
