#pragma once

#include "LevelControls.h"

#include <insonate/curriculum/MetricMeaning.h>

#include <QWidget>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace insonate::ui {

/// When one attempt passes: points, standards, and how many of them. Completed, succeeded and without a critical
/// error it must be in any case.
class StandardsEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit StandardsEditor(const std::vector<MetricMeaning>& metrics, QWidget* parent = nullptr);

  void show(const PassRule& rule);
  using QWidget::show;

 Q_SIGNALS:
  void edited(const QString& field, const insonate::ui::LevelEdit& change);

 private:
  QWidget* buildRule();
  QWidget* buildStandard();
  void add();
  void remove();
  void showStandard();
  /// Of the standard whose row is chosen.
  void change(const QString& field, const std::function<void(MetricStandard&)>& what);
  QString titleOf(const MetricStandard& standard) const;

  const std::vector<MetricMeaning>& metrics_;
  PassRule rule_;
  QCheckBox *points_, *critical_;
  QDoubleSpinBox *leastPoints_, *percent_, *limit_;
  QTableWidget* table_;
  QComboBox *metric_, *bound_;
  QLineEdit* otherwise_;
  QPushButton *add_, *remove_;
};

}  // namespace insonate::ui
