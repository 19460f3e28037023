#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;

namespace insonate::views {
struct HuHistogram;
}

namespace insonate::prepare {

class LabelBox;
class PrepareSession;
class RangeField;

/// What every tool must leave alone: which labels it may overwrite, and where the CT must be in a range.
class RulesBox : public QWidget {
 public:
  explicit RulesBox(PrepareSession& session, QWidget* parent = nullptr);

  void setHistogram(const views::HuHistogram& histogram);

 private:
  void connectParts();
  void refresh();

  PrepareSession& session_;
  QComboBox* over_;
  LabelBox* inside_;
  QCheckBox* limited_;
  RangeField* range_;
};

}  // namespace insonate::prepare
