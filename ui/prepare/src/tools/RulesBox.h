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

/// Rules for every tool: the labels that it may overwrite, and the range in which the CT must be.
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
